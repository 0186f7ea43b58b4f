#include "relief/visibility/packed_cone_any.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/visibility/packed_cone_any_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/visibility/packed_cone_any_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void queryBlock(const PackedConeAnyHit& query, const AnyRayBlock& rays, std::size_t first, std::size_t last,
                Visibility* results) {
    runQueries(query, rays, first, last, results);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(queryBlock);

void PackedConeAnyHit::querySimd(const AnyRayBlock& rays, std::size_t first, std::size_t last,
                                 VisibilityBlock& results) const {
    HWY_DYNAMIC_DISPATCH(queryBlock)(*this, rays, first, last, results.visibility.data());
}

}  // namespace relief
#endif
