// Rays of a block that the SIMD walk cannot finish, by the walk in double (packed_walk.h), many together.
#pragma once

#include <vector>

#include "relief/methods/packed_walk.h"

namespace relief {

// A part of a ray's way. Ended: with that hit or none, which a step that began before `until` has found. Else it is in
// that cell, no earlier than at `until`.
struct PackedPart {
    std::size_t ray;  // number in the block
    double from;      // lambda before which it meets nothing
    double until;
    bool ended = false;
    Hit hit{};
    AxisCell x{}, y{};
};

struct PackedStart {
    std::size_t ray;  // number in the block
    double from;      // lambda before which it meets nothing
};

// The hits of some rays of the block, into their places.
void packedHits(const ConeGround& ground, const RayBlock& rays, const std::vector<PackedStart>& starts, HitBlock& hits);

// The same for parts, of rays that enter the map.
void packedParts(const ConeGround& ground, const RayBlock& rays, std::vector<PackedPart>& parts);

}  // namespace relief
