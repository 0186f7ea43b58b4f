// When an answer lies behind the first hit.
#pragma once

#include "relief/ray.h"

namespace relief {

// Rounding by which a march that ends on the surface may lie behind it, in lambda.
inline constexpr double kOvershootRounding = 1e-12;

// Returns true if `found` is a miss, or a hit behind `exact`, which is a hit, by more than rounding.
inline bool overshoots(const Hit& found, const Hit& exact) {
    return found.outcome == Outcome::Miss ||
           (found.outcome == Outcome::Hit && found.lambda > exact.lambda + kOvershootRounding);
}

}  // namespace relief
