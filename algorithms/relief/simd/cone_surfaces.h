// The implementation of cone_lanes.cpp for each surface type: traceCones...() traces rays whose columns s0, t0, a, b
// are given and writes their hits from index firstHit on; resumeCones...() resumes rays in a cell, as in cone_lanes.h.
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
