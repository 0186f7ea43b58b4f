// Whether a cell is in the way of a segment: the one answer for all any-hit queries, as leaf.h is for view rays.
#pragma once

#include "relief/leaf.h"
#include "relief/visibility/any_ray.h"

namespace relief {

// Where along the segment it is above all that there is.
inline double endBelow(const AnyRay& ray, double highest) {
    if (ray.dz <= 0) return 1;
    return std::min(1.0, (highest - ray.z) / ray.dz);
}

// Border: parallel to an edge and outside of it; whatever else begins outside finds its way in by the walk.
inline bool runsOutside(const CellGrid& grid, const GridRay& course) {
    const auto outside = [](const GridAxis& axis, const RayAxis& ray) {
        return ray.side == 0 && !(ray.start >= axis.low && ray.start <= axis.high);
    };
    return grid.bounded && (outside(grid.x, course.x) || outside(grid.y, course.y));
}

// The largest value of surface minus segment over the stay: at an end, or at the vertex of the parabola.
inline double highestGap(const Patch& patch, double zIn, double zOut) {
    const double fIn = patch.heightIn - zIn;
    const double fOut = patch.heightOut - zOut;
    const double c = patch.curvature;
    const double b = fOut - fIn - c;
    const double atEnds = std::max(fIn, fOut);
    if (!(c < 0 && b > 0 && b < -2 * c)) return atEnds;
    return std::max(atEnds, fIn - b * b / (4 * c));
}

// Whether the surface within the cell rises above the segment, up to mu = end, by more than kVisibilityClearance.
inline bool cellBlocks(const HeightField& field, const CellGrid& grid, const AnyRay& ray, const GridRay& course,
                       AxisCell cx, AxisCell cy, double end) {
    const CellInterval whole = cellInterval(grid, course, cx, cy);
    const CellInterval interval{whole.in, std::min(whole.out, end)};
    if (!(interval.in < interval.out)) return false;
    const double zIn = ray.heightAt(interval.in);
    const double zOut = ray.heightAt(interval.out);
    if (field.surface() == Surface::Columns) {
        return field.heights()(cx.index, cy.index) - std::min(zIn, zOut) > kVisibilityClearance;
    }
    return highestGap(Patch(field.heights(), grid, course, cx, cy, interval), zIn, zOut) > kVisibilityClearance;
}

}  // namespace relief
