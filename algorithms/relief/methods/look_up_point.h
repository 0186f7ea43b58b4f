// Where colours and slopes are looked up for a hit.
//
// A column's wall stands exactly on the line between two texels. There rounding of s0 + lambda a picks either texel,
// and a picture of it would be speckled; what is seen is the column that was hit. So near a line the point is put a
// kWallNudge inside: on the far side of the line, as the ray goes, if the column there reaches up to the hit (its wall
// was hit), else on the near side (a top was hit). Bilinear surfaces have no walls: the point is the hit's.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// Texels: above the rounding of coordinates up to 10^6, below anything that can be seen.
inline constexpr double kWallNudge = 1e-6;

// (s, t) in texels, unwrapped as the hit's.
inline glm::dvec2 lookUpPoint(const HeightField& field, const ViewRay& ray, const Hit& hit) {
    const glm::dvec2 place{hit.s, hit.t};
    if (field.surface() != Surface::Columns) return place;
    // Near a line, to its far side (side 1) or its near side (-1), as the ray goes.
    const auto moved = [&](double x, double run, double side) {
        const double line = std::round(x);
        return run != 0 && std::abs(x - line) < kWallNudge ? line + std::copysign(kWallNudge, run) * side : x;
    };
    const glm::dvec2 beyond{moved(hit.s, ray.a, 1), moved(hit.t, ray.b, 1)};
    if (beyond == place) return place;
    // As the leaf compares, up to the rounding of 1 - lambda.
    if (field.at(beyond.x, beyond.y) >= 1 - hit.lambda - 0x1p-40) return beyond;
    return {moved(hit.s, ray.a, -1), moved(hit.t, ray.b, -1)};
}

}  // namespace relief
