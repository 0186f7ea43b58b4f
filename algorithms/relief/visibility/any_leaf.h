// Whether the surface within a cell blocks a segment. All any-hit queries use this test, as all view rays use leaf.h.
#pragma once

#include "relief/leaf.h"
#include "relief/visibility/any_ray.h"

namespace relief {

// The mu from which on the segment is above the whole surface, at most 1. highest: the largest height.
inline double endBelow(const AnyRay& ray, double highest) {
    if (ray.dz <= 0) return 1;
    return std::min(1.0, (highest - ray.z) / ray.dz);
}

// Border: returns true for a segment that runs parallel to an edge outside the picture. Other segments that begin
// outside are handled by the walk.
inline bool runsOutside(const CellGrid& grid, const GridRay& course) {
    const auto outside = [](const GridAxis& axis, const RayAxis& ray) {
        return ray.side == 0 && !(ray.start >= axis.low && ray.start <= axis.high);
    };
    return grid.bounded && (outside(grid.x, course.x) || outside(grid.y, course.y));
}

// The largest value of surface minus segment over the cell interval: at an end, or at the vertex of the parabola.
inline double highestGap(const Patch& patch, double zIn, double zOut) {
    const double fIn = patch.heightIn - zIn;
    const double fOut = patch.heightOut - zOut;
    const double c = patch.curvature;
    const double b = fOut - fIn - c;
    const double atEnds = std::max(fIn, fOut);
    if (!(c < 0 && b > 0 && b < -2 * c)) return atEnds;
    return std::max(atEnds, fIn - b * b / (4 * c));
}

// Returns true if within the cell, up to mu = end, the surface rises above the segment by more than
// kVisibilityClearance.
inline bool cellBlocks(const HeightField& field, const CellGrid& grid, const AnyRay& ray, const GridRay& course,
                       AxisCell cx, AxisCell cy, double end) {
    const CellInterval whole = cellInterval(grid, course, cx, cy);
    const CellInterval interval{whole.in, std::min(whole.out, end)};
    if (!(interval.in < interval.out)) return false;
    const double zIn = ray.heightAt(interval.in);
    const double zOut = ray.heightAt(interval.out);
    return withHeights(field, [&](const auto& heights) {
        const double gap = field.surface() == Surface::Columns
                               ? heights(cx.index, cy.index) - std::min(zIn, zOut)
                               : highestGap(Patch(heights, grid, course, cx, cy, interval), zIn, zOut);
        return gap > kVisibilityClearance;
    });
}

}  // namespace relief
