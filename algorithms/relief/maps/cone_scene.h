// The data of a field for the search for conservative cones: its cells, their planes, and the geometry between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "relief/maps/azimuth_sectors.h"
#include "relief/maps/cone_planes.h"
#include "relief/maps/max_pyramid_map.h"

namespace relief {

// The cell that determines a slope, in any period.
struct ConeDecider {
    int x = 0;
    int y = 0;
    double height = 0;
    bool operator==(const ConeDecider&) const = default;
};

struct ConeCells {
    int x0, x1, y0, y1;  // [x0, x1) x [y0, y1)
};

struct ConeScene {
    ConeScene(const HeightField& field, const MaxPyramidMap& map, int sectorCount, double slackShare, Work& work)
        : grid(field),
          cells(map.pyramid.level(0)),
          planes(map.pyramid, work),
          wraps(field.address() == Address::Repeat),
          unbounded(field.address() == Address::Clamp),
          width(cells.width()),
          height(cells.height()),
          reach(wraps ? std::max(1.0, 0.5 * std::min(width, height)) : std::hypot(width, height)),
          squaredReach(reach * reach),
          highest(static_cast<double>(map.highest())),
          slackFactor(1 + slackShare),
          sectors(sectorCount) {}

    CellGrid grid;
    const FloatImage& cells;
    ConePlanes planes;
    bool wraps;
    bool unbounded;  // clamp: the outermost cells have no outer edge
    int width;
    int height;
    // Radius of the search, in cells. Cells farther than half a period have a nearer copy, but in another direction; a
    // lower bound of all slopes (BlockCones::guess) covers them.
    double reach;
    double squaredReach;
    double highest;
    double slackFactor;
    AzimuthSectors sectors;

    static int place(const GridAxis& axis, int k) {
        return axis.wraps ? ((k % axis.cells) + axis.cells) % axis.cells : std::clamp(k, 0, axis.cells - 1);
    }
    // Whether the sector contains a direction from a cell of `from` to a cell of `to`.
    bool meets(const ConeCells& from, const ConeCells& to, int sector) const {
        if (sectors.count() == 1) return true;
        double x0 = to.x0 - from.x1;
        double x1 = to.x1 - from.x0;
        double y0 = to.y0 - from.y1;
        double y1 = to.y1 - from.y0;
        if (unbounded) {
            constexpr double kFar = 1e9;
            if (from.x1 == width || to.x0 == 0) x0 = -kFar;
            if (from.x0 == 0 || to.x1 == width) x1 = kFar;
            if (from.y1 == height || to.y0 == 0) y0 = -kFar;
            if (from.y0 == 0 || to.y1 == height) y1 = kFar;
        }
        return sectors.meets(sector, x0, x1, y0, y1);
    }
};

// The squared gap between two boxes of cells. Exact: sides are below 2^15 cells, and copies are adjacent.
inline std::int64_t squaredGap(const ConeCells& from, const ConeCells& to) {
    const std::int64_t x = std::max({0, to.x0 - from.x1, from.x0 - to.x1});
    const std::int64_t y = std::max({0, to.y0 - from.y1, from.y0 - to.y1});
    return x * x + y * y;
}

// Lower bound of the fall of a cone with the given slope towards a node: its tangent at the node's middle, since the
// cone is convex. offsetX, offsetY: from the cell to the middle.
struct ConeTangent {
    double fall;
    double x;
    double y;

    ConeTangent(double offsetX, double offsetY, double slope) {
        const double gapX = std::max(std::abs(offsetX) - 1, 0.0);
        const double gapY = std::max(std::abs(offsetY) - 1, 0.0);
        const double gap = std::sqrt(gapX * gapX + gapY * gapY);
        const double share = gap > 0 ? slope / gap : 0.0;
        fall = slope * gap;
        x = std::copysign(share * gapX, offsetX);
        y = std::copysign(share * gapY, offsetY);
    }
    // Upper bound of the height of the node's plane above the tangent, with the apex at 0.
    double room(const ConePlanes::Node& node, const NodeSpan& spanX, const NodeSpan& spanY) const {
        return static_cast<double>(node.value) - fall + spanX.half * std::abs(static_cast<double>(node.gradientX) - x) +
               spanY.half * std::abs(static_cast<double>(node.gradientY) - y);
    }
};

}  // namespace relief
