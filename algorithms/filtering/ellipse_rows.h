// Footprints whose ellipses are computed along rows of pixels, as in [TEX], instead of from each pixel's own Jacobian.
//
// Iterative: q, c and d by forward differences along a row. Cached: sums of a term of the row and a term of the column.
// Formulas and operation counts: mapping/rows/derivatives.h. Both describe the polygon's plane, in float; the parallax
// of a hit scales the derivatives by 1 + lambda spread, as in a query's own Jacobian.
//
// The cached form yields an ellipse but not the orientation of the pixel in it. Filters read Jacobians, so it becomes
// the triangular Jacobian of this ellipse, built from the longer of its two rows: with F = A C - B^2 / 4 and, for
// example, C >= A,
//
//     u_x = sqrt C   v_x = -B / (2 sqrt C)   u_y = 0   v_y = sqrt(F / C)
//
// Relative error of a semi-axis: 4 units of 2^-24 (iterative: up to 34, from 15 differences between restarts), times
// |G x| + |H y| + |I| over q, which is large near the horizon; for the iterative form's minor axis also times the ratio
// of the axes. A pixel without a view, with values that are not finite, or so thin that float loses F keeps its own
// Jacobian (the direct form). Cost: see tests/benchmarks/EXPERIMENTS.md; the direct Jacobians of a block are computed
// in any case.
#pragma once

#include <cstdint>
#include <string_view>

#include "filtering/filter_block.h"

namespace relief {

enum class EllipseForm : std::uint8_t { Direct, Iterative, Cached };
// name: "direct", "iterative" or "cached"; other names give Direct.
inline EllipseForm ellipseForm(std::string_view name) {
    return name == "iterative" ? EllipseForm::Iterative : name == "cached" ? EllipseForm::Cached : EllipseForm::Direct;
}

// Pixels between restarts of the iterative form, which are at columns that are multiples of it. So a pixel's ellipse
// does not depend on the block that contains it.
inline constexpr int kEllipseAnchor = 16;

// Writes the block's places and its footprints in this form (not Direct) to `out`; the other columns of `out` are
// unspecified.
void ellipseRows(EllipseForm form, const FilterBlock& block, FilterBlock& out);

// Returns the largest relative difference between a semi-axis of a footprint in `of` and that of the same pixel in
// `from`.
double largestAxisDifference(const FilterBlock& of, const FilterBlock& from);

}  // namespace relief
