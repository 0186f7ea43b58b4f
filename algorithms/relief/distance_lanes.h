// Fixed steps by the trilinear distance (distance, distance-refined-sampled) in lanes of double, a ray a lane, finished
// lanes refilled: the operations of distance_fixed.h and DistanceMap::trilinear in their order, so the same bits for
// any target and width. Twin: DistanceFixed::trace.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/maps/distance_map.h"
#include "relief/ray.h"

namespace relief {

struct DistanceMarch {
    const HeightField& field;
    const DistanceMap& map;
    int iterations;
};

// hits of rays first to last - 1. Returns those that are left to the scalar text: all if the map is not of floats or
// has more than 2^31 values, and those so far off that a period cannot be taken off exactly by one product.
std::vector<std::size_t> marchInLanes(const DistanceMarch& march, const RayBlock& rays, std::size_t first,
                                      std::size_t last, HitBlock& hits);

}  // namespace relief
