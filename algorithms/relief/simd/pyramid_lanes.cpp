#include "relief/methods/pyramid_rays.h"

#include <algorithm>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/pyramid_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/pyramid_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void tracePyramid(const FloatScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                  HitBlock& hits, LaneRays& scratch) {
    tracePyramidOn(scene, pyramid, rays, first, hits, scratch);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(tracePyramid);

void traceByPyramid(const FloatScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, std::vector<std::size_t>& left) {
    traceChunks(
        first, last, hits,
        [&](std::size_t begin, std::size_t end, LaneRays& scratch) {
            scratch.count = end - begin;
            HWY_DYNAMIC_DISPATCH(tracePyramid)(scene, pyramid, rays, begin, hits, scratch);
            std::fill_n(hits.outcome.data() + begin, scratch.count, Outcome::Hit);
        },
        [&](std::size_t begin, const LaneRays& scratch) {
            for (std::size_t n = 0; n < scratch.othersCount; ++n) {
                const LaneRays::Other& other = scratch.others[n];
                if (other.end != LaneEnd::Miss) left.push_back(begin + other.ray);
            }
        });
}

}  // namespace relief
#endif
