// All rays of a block by packed cones: by the SIMD walk, and in double where that cannot finish them.
#pragma once

#include <vector>

#include "relief/lanes/cone_lanes.h"

namespace relief {

// The hits of rays [first, last) of the block, any number. Rays that the SIMD walk cannot finish and that are flatter
// than the domain of exactness are added to `flat` instead. lanes: other functions in tests.
void traceByCones(const HeightField& field, const LaneScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat,
                  const ConeLanes& lanes = kConeLanes);

}  // namespace relief
