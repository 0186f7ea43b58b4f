// SIMD version of max-pyramid for many rays, without a log: one ray per lane, down and up the pyramid of depths
// (simd/pyramid_lanes-inl.h). Reference: depth_walk.h, with the same results.
#pragma once

#include <vector>

#include "relief/maps/depth_pyramid.h"
#include "relief/methods/float_scene.h"
#include "relief/ray.h"

namespace relief {

// Sets hits for the rays [first, last) of the block. Rays that float cannot decide are appended to `left`, by their
// index in the block, for the reference.
void traceByPyramid(const FloatScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, std::vector<std::size_t>& left);

}  // namespace relief
