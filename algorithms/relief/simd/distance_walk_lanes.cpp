#include "relief/methods/distance_walk_lanes.h"

#include "base/simd_targets.h"
#include "relief/methods/lane_fallback.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/distance_walk_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/distance_walk_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void walkAll(const DistanceWalk& walk, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
             std::vector<std::size_t>& left, const Segment* segments) {
    RayQueue<DistanceWalk> queue{walk, rays, hits, first, last, left, segments};
    runAlternating<VoxelWalk<NoVisits>>(queue);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(walkAll);

std::vector<std::size_t> walkSimd(const DistanceWalk& walk, const RayBlock& rays, std::size_t first, std::size_t last,
                                  HitBlock& hits, const Segment* segments) {
    if (!fitsLanes(walk.distanceMap()->values) || !gathersHeights(walk.field())) return allRays(first, last);
    std::vector<std::size_t> left;
    HWY_DYNAMIC_DISPATCH(walkAll)(walk, rays, first, last, hits, left, segments);
    return left;
}

}  // namespace relief
#endif
