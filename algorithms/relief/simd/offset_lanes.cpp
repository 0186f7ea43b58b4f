#include "relief/methods/offset_lanes.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/offset_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/offset_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void shiftAll(const OffsetSearch& search, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
              std::vector<std::size_t>& left) {
    OffsetLanes<NoVisits>(search, rays, hits, left).run(first, last);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(shiftAll);

std::vector<std::size_t> offsetSimd(const OffsetSearch& search, const RayBlock& rays, std::size_t first,
                                    std::size_t last, HitBlock& hits) {
    std::vector<std::size_t> left;
    HWY_DYNAMIC_DISPATCH(shiftAll)(search, rays, first, last, hits, left);
    return left;
}

}  // namespace relief
#endif
