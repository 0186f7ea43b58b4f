// The distance of a point to the surface itself: to the nearest of its bilinear patches or columns, found by branch and
// bound over the max pyramid.
//
// Metric: X = (x, y, D z) in texels, D = HeightField::slabTexels. Columns have walls. Outside a border there is no
// surface.
// Accuracy: columns exact to rounding; patches to better than 1e-4 texels, found by a search along one side. Cost: some
// tens of nodes and a few patches per point. Thread-safe.
#pragma once

#include <memory>

#include "relief/cell_grid.h"
#include "relief/maps/max_pyramid_map.h"

namespace relief {

class SurfaceDistance {
  public:
    SurfaceDistance(HeightField field, std::shared_ptr<const MaxPyramidMap> maxima);

    // Distance of the point (s, t, z), in texels and height; 0 at or below the surface. (s, t) must lie in the picture.
    // known: an upper bound of the distance (infinity: unknown), which speeds up the search if it is tight.
    double at(double s, double t, double z, double known) const { return nearest(s, t, z, known).distance; }
    // The distance and the nearest point, in texels not reduced to a period and height; on a wall at the height of the
    // point.
    struct Nearest {
        double distance = 0;
        double s = 0;
        double t = 0;
        double z = 0;
    };
    Nearest nearest(double s, double t, double z, double known) const;

    struct Point {
        double x;  // cell coordinates
        double y;
        double z;
    };

  private:
    struct Node {
        int level;
        int i;
        int j;
        std::int64_t baseX;  // first cell of the period
        std::int64_t baseY;
    };
    // The smallest squared distance found, and the position of that point in cell coordinates.
    struct Best {
        double squared;
        double x;
        double y;
    };
    void visit(const Node& node, const Point& p, Best& best) const;
    double lowerBound(const Node& node, const Point& p) const;
    Best column(const Node& cell, const Point& p) const;
    Best patch(const Node& cell, const Point& p) const;

    HeightField field_;
    std::shared_ptr<const MaxPyramidMap> maxima_;
    CellGrid grid_;
    double slab_;
};

}  // namespace relief
