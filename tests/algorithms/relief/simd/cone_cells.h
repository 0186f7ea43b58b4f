// What the cone walk looks at in lanes: each step's cell and word, ray by ray.
#pragma once

#include <vector>

#include "relief/simd/cone_lanes.h"

namespace relief::test {

// A cell before any addressing, and its word in the ray's quadrant.
struct LookedAt {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::uint32_t word = 0;
    bool operator==(const LookedAt&) const = default;
};

// begin: lambda at which the ray parted from its packet.
struct LookedAtRay {
    double begin = 0;
    std::vector<LookedAt> cells;
};

// Of an instance of the walk that rounds as the reference does (products and sums apart, quotients) and leads no rays
// in packets; or of the product's. The rays differ from each other. hits: of all rays but those flatter than the
// domain.
std::vector<LookedAtRay> cellsInLanes(const HeightField& field, const PackedCones& cones, const RayBlock& rays,
                                      HitBlock& hits, bool asTheReference);

}  // namespace relief::test
