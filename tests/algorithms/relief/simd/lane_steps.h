// Records the steps that SIMD traversals in double take, as lists of numbers, ray by ray.
#pragma once

#include <vector>

#include "relief/methods/distance_march_lanes.h"
#include "relief/methods/distance_walk.h"
#include "relief/methods/layer_lanes.h"
#include "relief/methods/offset_lanes.h"
#include "relief/methods/texel_cone_lanes.h"
#include "relief/visibility/packed_cone_any.h"

namespace relief::test {

using LaneSteps = std::vector<std::vector<double>>;

// segments, here and below: one per ray, if only these are traced.

// Voxel (three numbers), distance, lambda before and after; for rays in the exact domain.
std::vector<LaneSteps> stepsInLanes(const DistanceWalk& walk, const RayBlock& rays, const Segment* segments = nullptr);
// Lambda, distance, lambda after; not for the last step, where the ray has arrived; for rays that the map supports.
std::vector<LaneSteps> stepsInLanes(const MarchSearch& search, const RayBlock& rays);
// Layer, lambda, surface minus ray.
std::vector<LaneSteps> stepsInLanes(const LayerSearch& search, const RayBlock& rays);
// Height, lambda; for rays whose start is inside.
std::vector<LaneSteps> stepsInLanes(const OffsetSearch& search, const RayBlock& rays);
// Cell (two numbers), slope or, where the leaf tests, apex, lambda before, at the cell's end and after; for rays in the
// exact domain.
std::vector<LaneSteps> stepsInLanes(const ConeCellSearch& search, const RayBlock& rays,
                                    const Segment* segments = nullptr);
// Lambda, slope, lambda after, then of each bisection the ends of the bracket and the height; for rays that are not
// far.
std::vector<LaneSteps> stepsInLanes(const ConeMarchSearch& search, const RayBlock& rays,
                                    const Segment* segments = nullptr);
// Cell (two numbers); for segments in the exact domain.
std::vector<LaneSteps> stepsInLanes(const PackedConeAnyHit& query, const AnyRayBlock& rays);

}  // namespace relief::test
