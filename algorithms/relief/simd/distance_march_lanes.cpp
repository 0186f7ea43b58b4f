#include "relief/methods/distance_march_lanes.h"

#include <limits>
#include <numeric>

#include "base/simd_targets.h"
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
    std::vector<std::size_t> left;
    const auto* values = std::get_if<std::vector<float>>(&search.map.values.codes());
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (values == nullptr || values->size() > kMost || search.iterations < 1) {
        left.resize(last - first);
        std::iota(left.begin(), left.end(), first);
        return left;
    }
    HWY_DYNAMIC_DISPATCH(marchAll)(search, rays, first, last, hits, left);
    return left;
}

}  // namespace relief
#endif
