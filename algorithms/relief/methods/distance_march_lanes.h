// SIMD version of distance_march.h: a ray per lane of double, finished lanes refilled; the operations of
// DistanceMarch::trace and DistanceMap::trilinear in their order, so the same bits for any target and width.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "relief/maps/distance_map.h"
#include "relief/ray.h"

namespace relief {

// Where a march ends: distance_march.h. within: texels, of Distance.
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

// hits of rays first to last - 1. Returns those that are left to the reference implementation: all if the map is not of
// floats or has more than 2^31 values, those flatter than the map serves, and those so far off that a period cannot be
// taken off exactly by one product.
std::vector<std::size_t> marchInLanes(const MarchSearch& search, const RayBlock& rays, std::size_t first,
                                      std::size_t last, HitBlock& hits);

}  // namespace relief
