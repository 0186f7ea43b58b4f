// The SIMD walk by packed cones: one ray per lane, one map entry per step. Reference: methods/cone_walk.h, which visits
// the same cells.
#pragma once

#include <vector>

#include "relief/maps/packed_cones.h"
#include "relief/simd/lane_rays.h"

namespace relief {

// Traces the rays [first, last) of the block, at most kLaneChunk, and sets their hits. Afterwards scratch.others lists
// the rays that miss and those that are not finished.
void traceConeLanes(const FloatScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch);

// Resumes the first rays.count rays, whose columns s0, t0, a, b are given, in the cells hitCell and hitPeriod of
// rays.{x,y} or after them (rays.within). Writes their hits in this order; rays.others as above.
void resumeConeLanes(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                     HitBlock& hits);

// The two functions that traceByCones() calls; tests replace them.
struct ConeLanes {
    decltype(&traceConeLanes) trace;
    decltype(&resumeConeLanes) resume;
};
// traceByCones() of methods/cone_rays.h, with these functions.
void traceByCones(const ConeLanes& lanes, const HeightField& field, const FloatScene& scene, const PackedCones& cones,
                  const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
                  std::vector<std::size_t>& flat);

}  // namespace relief
