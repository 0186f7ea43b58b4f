// All rays of a block by packed cones: in lanes, and what lanes leave over.
#pragma once

#include <vector>

#include "relief/lanes/cone_lanes.h"

namespace relief {

// Rays [first, last) of the block, any number, what lanes leave over included. Rays flatter than the domain of
// exactness that lanes leave over are added to `flat`, and their hits are not set. lanes: tests have others.
void traceByCones(const HeightField& field, const LaneScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat,
                  const ConeLanes& lanes = kConeLanes);

}  // namespace relief
