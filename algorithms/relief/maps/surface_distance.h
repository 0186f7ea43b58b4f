// The distance of a point to the surface itself: the nearest of its bilinear patches or columns, found by branch and
// bound over the max pyramid.
//
// Metric: X = (x, y, D z) in texels, D = HeightField::slabTexels. Columns have walls. Outside of a border is no
// surface. Accuracy: columns exact to rounding; patches to better than 1e-4 texels, found by a search along one side.
// Cost: some tens of nodes and a few patches per point. Thread-safe.
#pragma once

#include <memory>

#include "relief/cell_grid.h"
#include "relief/maps/max_pyramid_map.h"

namespace relief {

class SurfaceDistance {
  public:
    SurfaceDistance(HeightField field, std::shared_ptr<const MaxPyramidMap> maxima);

    // Of the point (s, t, z), texels and height; 0 at or below the surface. (s, t) lies in the picture. known: a
    // distance that is certainly not exceeded (infinity: none known), which spares work where it is tight.
    double at(double s, double t, double z, double known) const { return nearest(s, t, z, known).distance; }
    // And where the nearest point is, unwrapped texels and height; on a wall at the point's own height.
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
    // The least squared distance so far, and the point's place in cell coordinates.
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
