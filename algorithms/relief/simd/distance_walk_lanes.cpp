#include "relief/methods/distance_walk_lanes.h"

#include <limits>
#include <numeric>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/distance_walk_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/distance_walk_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void walkAll(const DistanceWalk& walk, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
             std::vector<std::size_t>& left) {
    RayQueue<DistanceWalk> queue{walk, rays, hits, first, last, left};
    runAlternating<VoxelWalk<NoVisits>>(queue);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(walkAll);

std::vector<std::size_t> walkSimd(const DistanceWalk& walk, const RayBlock& rays, std::size_t first, std::size_t last,
                                  HitBlock& hits) {
    std::vector<std::size_t> left;
    const auto* values = std::get_if<std::vector<float>>(&walk.distanceMap()->values.codes());
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (values == nullptr || values->size() > kMost || walk.field().heights().size() > kMost) {
        left.resize(last - first);
        std::iota(left.begin(), left.end(), first);
        return left;
    }
    HWY_DYNAMIC_DISPATCH(walkAll)(walk, rays, first, last, hits, left);
    return left;
}

}  // namespace relief
#endif
