// What walks in lanes of double look at: each step's numbers, ray by ray.
#pragma once

#include <vector>

#include "relief/methods/distance_march_lanes.h"
#include "relief/methods/distance_walk.h"
#include "relief/methods/layer_lanes.h"
#include "relief/visibility/packed_cone_any.h"

namespace relief::test {

using LaneSteps = std::vector<std::vector<double>>;

// Voxel (three numbers), distance, lambda before and after; of rays in the domain of exactness.
std::vector<LaneSteps> stepsInLanes(const DistanceWalk& walk, const RayBlock& rays);
// lambda, distance, lambda after; not where the ray has arrived; of rays that the map serves.
std::vector<LaneSteps> stepsInLanes(const MarchSearch& search, const RayBlock& rays);
// Layer, lambda, the surface less the ray.
std::vector<LaneSteps> stepsInLanes(const LayerSearch& search, const RayBlock& rays);
// Cell (two numbers); of segments in the domain of exactness.
std::vector<LaneSteps> stepsInLanes(const PackedConeAnyHit& query, const AnyRayBlock& rays);

}  // namespace relief::test
