// Layout of a pyramid's levels side by side: level 0 large, the others in rows of equal blocks. All blocks show the
// same part of the texture, so that the ray looks the same on every level.
#pragma once

#include <vector>

#include "painting/drawing.h"

namespace reliefui {

struct LevelBlock {
    int level = 0;
    Box box;      // on the drawing
    Box domain;   // part of the texture plane shown, in texels
    Point title;  // lower left corner of the title

    double unitX() const { return box.width() / domain.width(); }
    double unitY() const { return box.height() / domain.height(); }
    Point toDrawing(Point texel) const {
        return {box.x0 + (texel.x - domain.x0) * unitX(), box.y0 + (texel.y - domain.y0) * unitY()};
    }
    Box toDrawing(const Box& texels) const {
        const Point low = toDrawing(Point{texels.x0, texels.y0});
        const Point high = toDrawing(Point{texels.x1, texels.y1});
        return {low.x, low.y, high.x, high.y};
    }
    Box toTexels(const Box& drawn) const {
        const auto x = [&](double at) { return domain.x0 + (at - box.x0) / unitX(); };
        const auto y = [&](double at) { return domain.y0 + (at - box.y0) / unitY(); };
        return {x(drawn.x0), y(drawn.y0), x(drawn.x1), y(drawn.y1)};
    }
};

inline constexpr double kTitleHeight = 14;

// width, height: available room in points.
std::vector<LevelBlock> pyramidLayout(int levels, const Box& domain, double width, double height);

}  // namespace reliefui
