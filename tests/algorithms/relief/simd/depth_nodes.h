// Records the nodes that the SIMD walk over the pyramid of depths visits, ray by ray.
#pragma once

#include <cstdint>
#include <vector>

#include "relief/methods/depth_walk.h"
#include "relief/ray.h"

namespace relief::test {

struct VisitedNode {
    int level = 0;
    std::int64_t x = 0;
    std::int64_t y = 0;
    double maximum = 0;  // 1 - its depth
    bool operator==(const VisitedNode&) const = default;
};

// asTheReference: by an instance that rounds as the reference does (no fused sums, quotients); else by the product's.
// hits: of the rays that lanes finish.
std::vector<std::vector<VisitedNode>> nodesInLanes(const FloatScene& scene, const DepthPyramid& depths,
                                                   const RayBlock& rays, HitBlock& hits, bool asTheReference);

}  // namespace relief::test
