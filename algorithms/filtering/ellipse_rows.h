// Footprints whose ellipses are computed along rows of pixels, as [TEX] has it, in place of each pixel's own Jacobian.
//
// Iterative: q, c and d by forward differences along a row. Cached: sums of what belongs to a row and what belongs to a
// column. Formulas and counts of operations: mapping/rows/derivatives.h. Both are of the polygon's plane, in float; the
// parallax of a hit scales the derivatives by 1 + lambda spread, as in a query's own Jacobian.
//
// The cached form knows an ellipse and not how the pixel lies in it. Filters read Jacobians, so it becomes the
// triangular one with this ellipse, from the longer of its two rows: with F = A C - B^2 / 4 and, for example, C >= A,
//
//     u_x = sqrt C   v_x = -B / (2 sqrt C)   u_y = 0   v_y = sqrt(F / C)
//
// Error, relative, of a semi-axis: 4 units of 2^-24, iterative up to 34 (15 differences between restarts), times
// |G x| + |H y| + |I| over q (large near the horizon); the iterative form's minor axis also times the ratio of the
// axes. Failure mode: a pixel without a view, not finite, or so thin that float loses F keeps its own Jacobian: the
// direct form. Cost: measured in tests/benchmarks/EXPERIMENTS.md; the direct Jacobians of a block are made in any case.
#pragma once

#include <cstdint>
#include <string_view>

#include "filtering/filter_block.h"

namespace relief {

enum class EllipseForm : std::uint8_t { Direct, Iterative, Cached };
// name: "direct", "iterative" or "cached".
inline EllipseForm ellipseForm(std::string_view name) {
    return name == "iterative" ? EllipseForm::Iterative : name == "cached" ? EllipseForm::Cached : EllipseForm::Direct;
}

// Pixels between restarts of the iterative form, at columns that are multiples of it: a pixel's ellipse depends on the
// pixel alone, not on the block around it.
inline constexpr int kEllipseAnchor = 16;

// Puts the block's places and its footprints of this form, not Direct, into `out`, where all else is unspecified.
void ellipseRows(EllipseForm form, const FilterBlock& block, FilterBlock& out);

// The largest relative difference of a semi-axis of a footprint from that of the same pixel in `from`.
double largestAxisDifference(const FilterBlock& of, const FilterBlock& from);

}  // namespace relief
