#include <cmath>

#include "relief/files.h"

namespace relief {

// Computed in double: rounding to float then hides last-digit differences between C libraries.
float linearFromSrgb(float encoded) {
    const double e = encoded;
    return static_cast<float>(e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4));
}

float srgbFromLinear(float linear) {
    const double v = linear;
    return static_cast<float>(v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

}  // namespace relief
