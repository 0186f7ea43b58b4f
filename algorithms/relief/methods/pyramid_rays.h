// max-pyramid over many rays, without a log: one ray a lane, down and up the pyramid of depths
// (simd/pyramid_lanes-inl.h). Reference: depth_walk.h, the same bits.
#pragma once

#include <vector>

#include "relief/maps/depth_pyramid.h"
#include "relief/methods/float_scene.h"
#include "relief/ray.h"

namespace relief {

// Rays [first, last) of the block into the same places of hits. Those that float cannot decide are added to `left`,
// by their number in the block, for the reference.
void traceByPyramid(const FloatScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, std::vector<std::size_t>& left);

}  // namespace relief
