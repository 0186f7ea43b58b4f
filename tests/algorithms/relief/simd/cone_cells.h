// Records the cells and map entries that the SIMD cone traversal visits, ray by ray.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "relief/simd/cone_lanes.h"

namespace relief::test {

// A cell before addressing, and its map entry for the ray's quadrant.
struct VisitedCell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::uint32_t word = 0;
    bool operator==(const VisitedCell&) const = default;
};

// begin: lambda to which a beam of neighbouring rays led this one. candidate: the cell in which the ray left its
// packet, before addressing; such a ray visits no cells by itself unless that was a false candidate.
struct VisitedRay {
    double begin = 0;
    std::vector<VisitedCell> cells;
    std::optional<std::array<std::int64_t, 2>> candidate;
};

// Traces the rays with a recording instance of the SIMD traversal. asTheReference: an instance that rounds as the
// reference does (no fused sums, true quotients) and forms no packets; otherwise the instance that is shipped. The rays
// must differ from each other. hits: of all rays except those flatter than the supported domain.
std::vector<VisitedRay> cellsInLanes(const HeightField& field, const PackedCones& cones, const RayBlock& rays,
                                     HitBlock& hits, bool asTheReference);

}  // namespace relief::test
