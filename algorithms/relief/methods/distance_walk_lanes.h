// SIMD version of the walk through conservative distance maps (distance-conservative, distance-refined) in double, one
// ray per lane; finished lanes are refilled. Reference: DistanceWalk::trace. It performs the operations of
// distance_walk.h and RayAxis in the same order, so the walk and the results are the same bits for any target, vector
// width and map. SIMD only excludes cells; in the others the leaf decides.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/ray.h"

namespace relief {

class DistanceWalk;

// Sets hits for the rays first to last - 1; with segments, one per ray of the block, those of traceSegment(). Returns
// the indices of rays that the reference has to trace: all if the map has more than 2^31 values; and rays flatter than
// the domain of exactness.
std::vector<std::size_t> walkSimd(const DistanceWalk& walk, const RayBlock& rays, std::size_t first, std::size_t last,
                                  HitBlock& hits, const Segment* segments = nullptr);

}  // namespace relief
