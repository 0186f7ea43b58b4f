// The walk through conservative distance maps (distance-conservative, distance-refined) in lanes of double, a ray a
// lane, finished lanes refilled: the operations of distance_walk.h and RayAxis in their order, so the same walk and the
// same bits for any target and width, whatever the map holds. Lanes only exclude cells; where one may be hit the one
// leaf is asked. Reference: DistanceWalk::trace.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/ray.h"

namespace relief {

class DistanceWalk;

// hits of rays first to last - 1. Returns those that are left to the reference: all if the map is not of floats or
// has more than 2^31 values, and those flatter than the domain of exactness.
std::vector<std::size_t> walkInLanes(const DistanceWalk& walk, const RayBlock& rays, std::size_t first,
                                     std::size_t last, HitBlock& hits);

}  // namespace relief
