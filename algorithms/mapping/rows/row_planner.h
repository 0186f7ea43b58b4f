// Lengths of spans on which u and v may be interpolated linearly.
//
// Source: Heckbert 1989 (the rational map); re-derived. On a span of m pixels between exact values, with q0 and q1 at
// its ends and u_x = a / q^2 (a is constant along a row), the error of linear interpolation is greatest where q is the
// geometric mean of q0 and q1. There it is exactly
//
//     E(m) = |a G| m^2 / (q0 q1 (sqrt q0 + sqrt q1)^2)        texels
//
// With k the ratio of q (or of depth) at the ends, this is (sqrt k - 1) / (sqrt k + 1) of the change of u on the span,
// at the fraction sqrt k / (sqrt k + 1) of the span from the end with the larger q. Example: for k = 4 the error is a
// third of the change, at two thirds of the span.
//
// Frames and units: pixels along the row, texels; see homography.h. Range: q > 0 on the whole span. Where G = 0 or
// a = 0 linear interpolation is exact, and spans may be arbitrarily long. Cost: a logarithm of the row's length.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/clipping.h"
#include "mapping/homography.h"

namespace relief {

// E(m) of one coordinate, in texels. numerator: a (of u_x) or b (of v_x); stepQ: G; length: m; q0, q1 > 0 at the ends.
double linearError(double numerator, double stepQ, double length, double q0, double q1);

// Largest error of linear interpolation over a whole span, and its position.
struct AffineError {
    double share = 0;     // error relative to the span's change of the coordinate
    double fraction = 0;  // position relative to the span's length, from the end with the larger q
};
// ratio: the ratio k >= 1 of q at the ends.
AffineError affineError(double ratio);

// a and b of u_x = a / q^2, v_x = b / q^2 on the line y.
struct RowSlopes {
    double a = 0;
    double b = 0;
};
RowSlopes rowSlopes(const Homography& map, double y);

// The longest m in [1, size of the span] such that linear interpolation over any m pixels inside the span (between
// their centres) has an error of at most `error` texels (> 0) in u and v.
std::int64_t longestSpan(const Homography& map, double y, PixelSpan span, double error);

}  // namespace relief
