// max-pyramid in lanes: one ray a lane, down and up the pyramid of depths. Reference: ../max_pyramid.h, same bits.
#pragma once

#include "relief/lanes/lane_rays.h"
#include "relief/maps/depth_pyramid.h"

namespace relief {

// Rays [first, last) of the block, at most kLaneChunk, into the same places of hits. scratch.others tells afterwards
// which rays miss (LaneEnd::Miss) or are left to the reference; the others are done.
void tracePyramidLanes(const LaneScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                       std::size_t last, HitBlock& hits, LaneRays& scratch);

}  // namespace relief
