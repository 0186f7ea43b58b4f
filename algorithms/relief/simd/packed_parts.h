// Traces rays of a block that the SIMD walk cannot finish by the walk in double (packed_walk.h), many at a time.
#pragma once

#include <vector>

#include "relief/methods/packed_walk.h"

namespace relief {

// A part of a ray, from lambda `from` on. If `ended`, a step that began before `until` ended the walk with `hit`.
// Otherwise the ray is in the cell (x, y), at a lambda no earlier than `until`.
struct PackedPart {
    std::size_t ray;  // index in the block
    double from;      // lambda before which the ray does not meet the surface
    double until;
    bool ended = false;
    Hit hit{};
    AxisCell x{}, y{};
};

struct PackedStart {
    std::size_t ray;  // index in the block
    double from;      // lambda before which the ray does not meet the surface
};

// Traces some rays of the block to their ends and sets their hits.
void packedHits(const ConeGround& ground, const RayBlock& rays, const std::vector<PackedStart>& starts, HitBlock& hits);

// The same for parts; their rays must enter the map.
void packedParts(const ConeGround& ground, const RayBlock& rays, std::vector<PackedPart>& parts);

}  // namespace relief
