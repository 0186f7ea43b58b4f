#include "relief/methods/layer_lanes.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/layer_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/layer_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void searchLayers(const LayerSearch& search, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
                  std::vector<std::size_t>& left) {
    LayerQueue queue{{search, rays, hits, first, last, left}, {}};
    runAlternating<LayerWalk<NoVisits>>(queue);
    if (search.refinement == LayerRefinement::Bisection) bisect<NoVisits>(queue);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(searchLayers);

std::vector<std::size_t> layersSimd(const LayerSearch& search, const RayBlock& rays, std::size_t first,
                                    std::size_t last, HitBlock& hits) {
    std::vector<std::size_t> left;
    HWY_DYNAMIC_DISPATCH(searchLayers)(search, rays, first, last, hits, left);
    return left;
}

}  // namespace relief
#endif
