// The length of a view ray, in the metric of distance maps.
#pragma once

#include <cmath>

namespace relief {

// Length, in texels of the metric (x, y, D z), that a ray of run (a, b) covers per unit of lambda. D is the slab's
// thickness in texels. A step of distance d advances lambda by d over this length.
inline double texelsPerLambda(double a, double b, double slabTexels) {
    return std::hypot(std::hypot(a, b), slabTexels);
}

}  // namespace relief
