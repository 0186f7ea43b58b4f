// Traces the rays of a block by packed cones: with the SIMD walk (simd/cone_rays.cpp), and in double where that cannot
// finish a ray. Reference: cone_walk.h.
#pragma once

#include <vector>

#include "relief/methods/float_scene.h"
#include "relief/ray.h"

namespace relief {

// Sets hits for the rays [first, last) of the block. Rays that the SIMD walk cannot finish and that are flatter than
// the domain of exactness are appended to `flat` instead, by their index in the block.
void traceByCones(const HeightField& field, const FloatScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat);

}  // namespace relief
