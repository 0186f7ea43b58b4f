// How far bilinear relief is turned to the light, in lanes of double: the bits of HeightField::slope,
// ReliefAxes::normalOf and glm::dot on every instruction set.
#pragma once

#include <algorithm>
#include <span>

#include "relief/methods/slope_scene.h"
#include "rendering/lighting.h"

namespace relief {

// out[n]: the normal at (s[n], t[n]), texels, rounded to float, times the direction to the light. slabTexels: thickness
// of the slab. All spans of one length; places that are NaN give NaN.
void facingLight(const SlopeScene& scene, const ReliefAxes& axes, double slabTexels, glm::dvec3 toLight,
                 std::span<const double> s, std::span<const double> t, std::span<double> out);

// By how much lit() multiplies a colour. Inline, so that compilers make a row of them at once.
inline float litAmount(double facing, const Light& light) {
    return static_cast<float>(light.intensity * (light.ambient + (1 - light.ambient) * std::max(0.0, facing)));
}

}  // namespace relief
