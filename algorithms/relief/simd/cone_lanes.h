// The walk by packed cones in lanes: one ray a lane, a step one word. Reference: methods/cone_walk.h, which looks at
// the same cells.
#pragma once

#include <vector>

#include "relief/maps/packed_cones.h"
#include "relief/simd/lane_rays.h"

namespace relief {

// Rays [first, last) of the block, at most kLaneChunk, into the same places of hits. scratch.others tells afterwards
// which rays miss or are left over; the others are done.
void traceConeLanes(const FloatScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch);

// Rays that go on, whose columns s0, t0, a, b are given: the first rays.count, in the cells hitCell and hitPeriod of
// rays.{x,y} or behind them (rays.within). Their hits in this order; rays.others as above.
void resumeConeLanes(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                     HitBlock& hits);

// The two functions that traceByCones() calls; tests pass others.
struct ConeLanes {
    decltype(&traceConeLanes) trace;
    decltype(&resumeConeLanes) resume;
};
// As traceByCones() of methods/cone_rays.h, with these functions.
void traceByCones(const ConeLanes& lanes, const HeightField& field, const FloatScene& scene, const PackedCones& cones,
                  const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
                  std::vector<std::size_t>& flat);

}  // namespace relief
