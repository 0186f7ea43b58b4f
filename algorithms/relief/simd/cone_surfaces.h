// The two halves of cone_lanes.cpp, one a surface: rays whose columns s0, t0, a, b are given, into hits from firstHit
// on (traceCones), and rays that go on from a cell (goOnCones), as in cone_lanes.h.
#pragma once

#include "relief/simd/cone_lanes.h"

namespace relief {

void traceConesBilinear(const FloatScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                        std::size_t firstHit, LaneRays& scratch);
void resumeConesBilinear(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                         HitBlock& hits);
void traceConesColumns(const FloatScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                       std::size_t firstHit, LaneRays& scratch);
void resumeConesColumns(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                        HitBlock& hits);

}  // namespace relief
