// How long a span may be in which u and v are taken as linear.
//
// Source: Heckbert 1989 (the rational map); re-derived. On a span of m pixels between exact values, q0 and q1 at its
// ends, with u_x = a / q^2 (a is constant along a row), the error of the straight line is greatest where q is the
// geometric mean of the ends' and is there exactly
//
//     E(m) = |a G| m^2 / (q0 q1 (sqrt q0 + sqrt q1)^2)        texels
//
// With k the ratio of the ends' q (of their depths) that is (sqrt k - 1) / (sqrt k + 1) of the span's own change of u,
// at the fraction sqrt k / (sqrt k + 1) of the span, counted from the end with the larger q: k = 4, a third at two
// thirds.
//
// Frames and units: pixels along the row, texels; homography.h. Range: q > 0 on the whole span. Where G = 0 or a = 0
// the line is exact, and spans have no end. Cost: a logarithm of the row's length.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/clipping.h"
#include "mapping/homography.h"

namespace relief {

// E(m) of one coordinate: numerator a (of u_x) or b (of v_x), q0 and q1 > 0 at the ends.
double linearError(double numerator, double stepQ, double length, double q0, double q1);

struct AffineError {
    double share = 0;     // of the span's change of the coordinate
    double fraction = 0;  // of the span's length, from its end with the larger q
};
// ratio: k >= 1.
AffineError affineError(double ratio);

// a and b of u_x = a / q^2, v_x = b / q^2 on the line y.
struct RowSlopes {
    double a = 0;
    double b = 0;
};
RowSlopes rowSlopes(const Homography& map, double y);

// The longest m, at least 1, at most the span's size, such that every sub-span of m pixels inside the span (its pixels'
// centres) keeps `error` texels (> 0) in u and in v.
std::int64_t longestSpan(const Homography& map, double y, PixelSpan span, double error);

}  // namespace relief
