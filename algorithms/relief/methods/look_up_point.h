// The point at which colours and slopes are sampled for a hit.
//
// The wall of a column lies exactly on the line between two texels. There, rounding of s0 + lambda a picks either texel
// at random, which would make a picture speckled; correct is the column that was hit. So near a line the point is moved
// kWallNudge to one side: beyond the line, in the direction of the ray, if the column there reaches up to the hit (its
// wall was hit), otherwise before it (a top was hit). Bilinear surfaces have no walls: the point is the hit itself.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// In texels: above the rounding of coordinates up to 10^6, below the visible.
inline constexpr double kWallNudge = 1e-6;

// (s, t) in texels, not reduced to a period, as in the hit.
inline glm::dvec2 lookUpPoint(const HeightField& field, const ViewRay& ray, const Hit& hit) {
    const glm::dvec2 place{hit.s, hit.t};
    if (field.surface() != Surface::Columns) return place;
    // Moves a coordinate near a line beyond it (side 1) or before it (side -1), in the direction of the ray.
    const auto moved = [&](double x, double run, double side) {
        const double line = std::round(x);
        return run != 0 && std::abs(x - line) < kWallNudge ? line + std::copysign(kWallNudge, run) * side : x;
    };
    const glm::dvec2 beyond{moved(hit.s, ray.a, 1), moved(hit.t, ray.b, 1)};
    if (beyond == place) return place;
    // The leaf's comparison, up to the rounding of 1 - lambda.
    if (field.at(beyond.x, beyond.y) >= 1 - hit.lambda - 0x1p-40) return beyond;
    return {moved(hit.s, ray.a, -1), moved(hit.t, ray.b, -1)};
}

}  // namespace relief
