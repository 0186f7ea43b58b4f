// SIMD version of distance_march.h in double, one ray per lane; finished lanes are refilled. It performs the operations
// of DistanceMarch::trace and DistanceMap::trilinear in the same order, so the results are the same bits for any target
// and vector width.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "relief/maps/distance_map.h"
#include "relief/ray.h"

namespace relief {

// Criterion that ends a march (distance_march.h).
enum class MarchStop : std::uint8_t { Surface, Distance, Never };
struct MarchEnd {
    MarchStop stop = MarchStop::Surface;
    double within = 0;
};

struct MarchSearch {
    const HeightField& field;
    const DistanceMap& map;
    int iterations;
    MarchEnd end;
};

// Sets hits for the rays first to last - 1. Returns the indices of rays that the reference has to trace: all if the map
// has more than 2^31 values; rays flatter than the map serves; and rays so distant that one product cannot subtract
// their period exactly.
std::vector<std::size_t> marchSimd(const MarchSearch& search, const RayBlock& rays, std::size_t first, std::size_t last,
                                   HitBlock& hits);

}  // namespace relief
