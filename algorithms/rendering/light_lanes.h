// SIMD version, in double, of the cosine between the normal of bilinear relief and the light: the same bits as
// HeightField::slope, ReliefAxes::normalOf and glm::dot on every instruction set.
#pragma once

#include <algorithm>
#include <span>

#include "relief/methods/slope_scene.h"
#include "rendering/lighting.h"

namespace relief {

// out[n]: the dot product of toLight and the normal at (s[n], t[n]), texels, the normal being rounded to float.
// slabTexels: thickness of the slab in texels. All spans have the same length; places that are NaN give NaN.
void facingLight(const SlopeScene& scene, const ReliefAxes& axes, double slabTexels, glm::dvec3 toLight,
                 std::span<const double> s, std::span<const double> t, std::span<double> out);

// Returns the factor by which lit() multiplies a colour. Inline, so that compilers vectorise loops over a row.
inline float litAmount(double facing, const Light& light) {
    return static_cast<float>(light.intensity * (light.ambient + (1 - light.ambient) * std::max(0.0, facing)));
}

}  // namespace relief
