// Conservative cones in lanes: one ray a lane, a step one word. Twin: ../cone.h, same bits (both exact).
#pragma once

#include "relief/lanes/lane_rays.h"
#include "relief/maps/packed_cones.h"

namespace relief {

// Rays [first, last) of the block, at most kLaneChunk, into the same places of hits. scratch.others tells afterwards
// which rays are left to the scalar text (LaneEnd::Scalar) or miss; the others are done.
void traceConeLanes(const LaneScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch);

}  // namespace relief
