// Conservative cones in lanes: one ray a lane, a step one word. Twin: ../cone.h, same bits (both exact).
#pragma once

#include <vector>

#include "relief/lanes/lane_rays.h"
#include "relief/maps/packed_cones.h"

namespace relief {

// Rays [first, last) of the block, at most kLaneChunk, into the same places of hits. scratch.others tells afterwards
// which rays are left to the scalar text (LaneEnd::Scalar) or miss; the others are done.
void traceConeLanes(const LaneScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch);

// Rays [first, last) of the block, any number, what lanes leave over included. Rays flatter than the domain of
// exactness that lanes leave over are added to `flat`, and their hits are not set.
void traceByCones(const HeightField& field, const LaneScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat);

}  // namespace relief
