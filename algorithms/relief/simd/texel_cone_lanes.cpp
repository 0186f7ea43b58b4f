#include "relief/methods/texel_cone_lanes.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/texel_cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/texel_cone_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void coneCellsAll(const ConeCellSearch& search, const RayBlock& rays, std::size_t first, std::size_t last,
                  HitBlock& hits, std::vector<std::size_t>& left, const Segment* segments) {
    RayQueue<ConeCellSearch> queue{search, rays, hits, first, last, left, segments};
    runAlternating<ConeCells<NoVisits>>(queue);
}
void coneMarchAll(const ConeMarchSearch& search, const RayBlock& rays, std::size_t first, std::size_t last,
                  HitBlock& hits, std::vector<std::size_t>& left, const Segment* segments) {
    BracketQueue<ConeMarchSearch> queue{{search, rays, hits, first, last, left, segments}, {}};
    runAlternating<ConeSteps<NoVisits>>(queue);
    bisect<NoVisits>(queue);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(coneCellsAll);
HWY_EXPORT(coneMarchAll);

std::vector<std::size_t> coneCellsSimd(const ConeCellSearch& search, const RayBlock& rays, std::size_t first,
                                       std::size_t last, HitBlock& hits, const Segment* segments) {
    std::vector<std::size_t> left;
    HWY_DYNAMIC_DISPATCH(coneCellsAll)(search, rays, first, last, hits, left, segments);
    return left;
}
std::vector<std::size_t> coneMarchSimd(const ConeMarchSearch& search, const RayBlock& rays, std::size_t first,
                                       std::size_t last, HitBlock& hits, const Segment* segments) {
    std::vector<std::size_t> left;
    HWY_DYNAMIC_DISPATCH(coneMarchAll)(search, rays, first, last, hits, left, segments);
    return left;
}

}  // namespace relief
#endif
