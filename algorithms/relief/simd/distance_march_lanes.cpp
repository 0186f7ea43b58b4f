#include "relief/methods/distance_march_lanes.h"

#include "base/simd_targets.h"
#include "relief/methods/lane_fallback.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/distance_march_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/distance_march_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void marchAll(const MarchSearch& search, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
              std::vector<std::size_t>& left) {
    RayQueue<MarchSearch> queue{search, rays, hits, first, last, left};
    runAlternating<DistanceSteps<NoVisits>>(queue);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(marchAll);

std::vector<std::size_t> marchSimd(const MarchSearch& search, const RayBlock& rays, std::size_t first, std::size_t last,
                                   HitBlock& hits) {
    if (!fitsLanes(search.map.values) || search.iterations < 1) return allRays(first, last);
    std::vector<std::size_t> left;
    HWY_DYNAMIC_DISPATCH(marchAll)(search, rays, first, last, hits, left);
    return left;
}

}  // namespace relief
#endif
