// Records the nodes that the SIMD traversal of the pyramid of depths visits, ray by ray.
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
    double maximum = 0;  // 1 - the node's depth
    bool operator==(const VisitedNode&) const = default;
};

// asTheReference: uses an instance that rounds as the reference does (no fused sums, true quotients); otherwise the
// instance that is shipped. hits: of the rays that SIMD finishes.
std::vector<std::vector<VisitedNode>> nodesInLanes(const FloatScene& scene, const DepthPyramid& depths,
                                                   const RayBlock& rays, HitBlock& hits, bool asTheReference);

}  // namespace relief::test
