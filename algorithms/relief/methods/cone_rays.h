// All rays of a block by packed cones: by the SIMD walk (simd/cone_rays.cpp), and in double where that cannot finish
// them. Reference: cone_walk.h.
#pragma once

#include <vector>

#include "relief/methods/float_scene.h"
#include "relief/ray.h"

namespace relief {

// The hits of rays [first, last) of the block, any number. Rays that the SIMD walk cannot finish and that are flatter
// than the domain of exactness are added to `flat` instead.
void traceByCones(const HeightField& field, const FloatScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat);

}  // namespace relief
