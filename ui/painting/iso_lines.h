// Iso-lines (contours) of a grid of samples, which lie at the centres of its cells.
#pragma once

#include <vector>

#include "painting/drawing.h"

namespace reliefui {

// Tints of a line (LevelTint::level) by the brightness of its background, a height map's colour, which does not depend
// on the theme.
inline constexpr int kLightLine = 1, kDarkLine = 2;

struct IsoLine {
    double value = 0;
    std::vector<Point> points;  // in cells: sample (i, j) lies at (i + 1/2, j + 1/2)
    bool closed = false;
};

// Iso-lines at each of the values (marching squares). Squares with a NaN corner have no line. Lines end at the
// outermost samples. A saddle is resolved by the mean of its four corners.
std::vector<IsoLine> isoLines(const relief::FloatImage& samples, const std::vector<double>& values);

}  // namespace reliefui
