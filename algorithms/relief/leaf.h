// The leaf: the intersection of a ray with the surface within one cell. Traversals only exclude cells; every hit is
// decided here.
//
// Over the interval [in, out], the surface minus the ray, f(w) with w from 0 at the entry to 1 at the exit, is
// quadratic (bilinear patch) or a constant minus a linear function (column):
//     f(w) = f_in + (f_out - f_in - c) w + c w^2,   c = du dv (h11 - h10 - h01 + h00)
// - If f >= 0 at the entry, the entry is the hit (walls, borders between patches, rounding).
// - Otherwise the hit is the root at which f reaches 0 from below, in the form without cancellation.
// Watertight: f at the exit is compared by >= here, and f at the same point by >= in the next cell.
// All arithmetic is in double. The parameter is measured from the entry of the cell, so that long and flat rays keep
// their precision.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

#include "relief/cell_grid.h"
#include "relief/height_source.h"

namespace relief {

// Clearance of a ray, in heights, that an exclusion test must demand: rounding of the leaf's interpolation (about
// 2^-50) could still make a closer ray a hit.
inline constexpr double kExclusionMargin = 0x1p-40;

// The lambda interval of the ray in the cell (cx, cy), clamped to [0, 1]; the ray crosses the cell only if in < out.
[[gnu::always_inline]] inline CellInterval cellInterval(const CellGrid& grid, const GridRay& ray, AxisCell cx,
                                                        AxisCell cy) {
    const double in = std::max({ray.x.enter(grid.x, cx.index, cx.index + 1, cx.base),
                                ray.y.enter(grid.y, cy.index, cy.index + 1, cy.base), 0.0});
    const double out = std::min({ray.x.leave(grid.x, cx.index, cx.index + 1, cx.base),
                                 ray.y.leave(grid.y, cy.index, cy.index + 1, cy.base), 1.0});
    return {in, out};
}

// Heights of the four nodes of a bilinear cell: (before, before), (after, before), (before, after), (after, after) in
// (x, y). Number: float or double. Heights: a source (height_source.h), here and below.
template <class Number = double, class Heights>
std::array<Number, 4> cellCorners(const Heights& heights, const CellGrid& grid, int cx, int cy) {
    const int i0 = grid.x.nodeBefore(cx);
    const int i1 = grid.x.nodeAfter(cx);
    const int j0 = grid.y.nodeBefore(cy);
    const int j1 = grid.y.nodeAfter(cy);
    if constexpr (std::is_same_v<Heights, TileSource>) {
        const std::array<float, 4> four = heights.corners(i0, i1, j0, j1);
        return {four[0], four[1], four[2], four[3]};
    } else {
        return {heights(i0, j0), heights(i1, j0), heights(i0, j1), heights(i1, j1)};
    }
}

// Largest and smallest stored height of the surface within a cell.
template <Surface kSurface, class Heights>
float cellMaximum(const Heights& heights, const CellGrid& grid, int cx, int cy) {
    if constexpr (kSurface == Surface::Columns) {
        return heights(cx, cy);
    } else {
        const auto [h00, h10, h01, h11] = cellCorners<float>(heights, grid, cx, cy);
        return std::max(std::max(h00, h10), std::max(h01, h11));
    }
}

template <Surface kSurface, class Heights>
float cellMinimum(const Heights& heights, const CellGrid& grid, int cx, int cy) {
    if constexpr (kSurface == Surface::Columns) {
        return heights(cx, cy);
    } else {
        const auto [h00, h10, h01, h11] = cellCorners<float>(heights, grid, cx, cy);
        return std::min(std::min(h00, h10), std::min(h01, h11));
    }
}

namespace leaf_detail {

// Position within a cell, [0, 1]; exact where the interval begins or ends on one of the cell's own lines.
inline double within(const RayAxis& axis, AxisCell cell, double lambda) {
    const double x = axis.start + lambda * axis.run;
    return std::clamp(x - static_cast<double>(cell.base + cell.index), 0.0, 1.0);
}

// The bilinear surface at (u, v) in a cell with corner heights h00 .. h11 (first index along x).
inline double lerpPatch(double h00, double h10, double h01, double h11, double u, double v) {
    return (1 - v) * ((1 - u) * h00 + u * h10) + v * ((1 - u) * h01 + u * h11);
}

// The first w in (0, 1] at which f_in + b w + c w^2 (f_in < 0) reaches 0; std::nullopt if there is none.
inline std::optional<double> firstRoot(double fIn, double fOut, double c) {
    const double b = fOut - fIn - c;
    if (fOut < 0 && !(c < 0 && b > 0 && b < -2 * c)) return std::nullopt;  // no maximum inside: f remains below 0
    const double discriminant = b * b - 4 * c * fIn;
    if (discriminant < 0 && fOut < 0) return std::nullopt;
    const double root = std::sqrt(std::max(discriminant, 0.0));
    // Both forms give the root with a positive slope; each is used where its sum does not cancel.
    const double w = b >= 0 ? -2 * fIn / (b + root) : (root - b) / (2 * c);
    return w < 1 ? w : 1.0;  // also for NaN (0/0): then the exit is the hit
}

}  // namespace leaf_detail

// The bilinear surface along the ray's interval in one cell: its height at the entry and at the exit, and the curvature
// c of the parabola in between, height(w) = heightIn + (heightOut - heightIn - c) w + c w^2, w from 0 to 1.
struct Patch {
    double heightIn;
    double heightOut;
    double curvature;

    template <class Heights>
    Patch(const Heights& heights, const CellGrid& grid, const GridRay& ray, AxisCell cx, AxisCell cy,
          CellInterval interval) {
        const int i0 = grid.x.nodeBefore(cx.index);
        const int i1 = grid.x.nodeAfter(cx.index);
        const int j0 = grid.y.nodeBefore(cy.index);
        const int j1 = grid.y.nodeAfter(cy.index);
        double h00, h10, h01, h11;
        if constexpr (std::is_same_v<Heights, TileSource>) {
            const std::array<float, 4> four = heights.corners(i0, i1, j0, j1);
            h00 = four[0], h10 = four[1], h01 = four[2], h11 = four[3];
        } else {
            // With an array between, exact takes a fifth longer.
            h00 = heights(i0, j0), h10 = heights(i1, j0), h01 = heights(i0, j1), h11 = heights(i1, j1);
        }
        const double uIn = leaf_detail::within(ray.x, cx, interval.in);
        const double vIn = leaf_detail::within(ray.y, cy, interval.in);
        const double uOut = leaf_detail::within(ray.x, cx, interval.out);
        const double vOut = leaf_detail::within(ray.y, cy, interval.out);
        heightIn = leaf_detail::lerpPatch(h00, h10, h01, h11, uIn, vIn);
        heightOut = leaf_detail::lerpPatch(h00, h10, h01, h11, uOut, vOut);
        curvature = (uOut - uIn) * (vOut - vIn) * ((h11 - h10) - (h01 - h00));
    }
};

// Lambda of the hit in the cell (cx, cy), or std::nullopt. The interval in the cell is computed here.
template <Surface kSurface, class Heights>
[[gnu::always_inline]] inline std::optional<double> leafHit(const Heights& heights, const CellGrid& grid,
                                                            const GridRay& ray, AxisCell cx, AxisCell cy) {
    const CellInterval interval = cellInterval(grid, ray, cx, cy);
    if (!(interval.in < interval.out)) return std::nullopt;
    if constexpr (kSurface == Surface::Columns) {
        const double h = heights(cx.index, cy.index);
        if (1 - interval.in <= h) return interval.in;
        const double top = 1 - h;
        if (top <= interval.out) return std::max(top, interval.in);
        return std::nullopt;
    } else {
        const Patch patch(heights, grid, ray, cx, cy, interval);
        const double fIn = patch.heightIn - (1 - interval.in);
        if (!(fIn < 0)) return interval.in;
        const auto w = leaf_detail::firstRoot(fIn, patch.heightOut - (1 - interval.out), patch.curvature);
        if (!w) return std::nullopt;
        const double lambda = interval.in + *w * (interval.out - interval.in);
        return std::min(lambda, interval.out);
    }
}

// The same for the surface type of the field. Maps that are read by tiles take a call, so that the code of those in
// memory stays as it is.
[[gnu::noinline]] inline std::optional<double> leafHitByTiles(const HeightField& field, const CellGrid& grid,
                                                              const GridRay& ray, AxisCell cx, AxisCell cy) {
    const TileSource heights{*field.tiles()};
    return field.surface() == Surface::Bilinear ? leafHit<Surface::Bilinear>(heights, grid, ray, cx, cy)
                                                : leafHit<Surface::Columns>(heights, grid, ray, cx, cy);
}
[[gnu::always_inline]] inline std::optional<double> leafHit(const HeightField& field, const CellGrid& grid,
                                                            const GridRay& ray, AxisCell cx, AxisCell cy) {
    if (field.tiles() != nullptr) [[unlikely]]
        return leafHitByTiles(field, grid, ray, cx, cy);
    return field.surface() == Surface::Bilinear ? leafHit<Surface::Bilinear>(field.heights(), grid, ray, cx, cy)
                                                : leafHit<Surface::Columns>(field.heights(), grid, ray, cx, cy);
}

// Number of stored heights that leafHit() fetches.
constexpr std::uint32_t leafReads(Surface surface) {
    return surface == Surface::Bilinear ? 4 : 1;
}

}  // namespace relief
