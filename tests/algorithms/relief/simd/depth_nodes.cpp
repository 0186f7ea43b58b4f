#include "depth_nodes.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/relief/simd/depth_nodes.cpp"
#include <hwy/foreach_target.h>
// Included after foreach_target.h.
#include "plain_arithmetic-inl.h"
#include "relief/simd/pyramid_lanes-inl.h"

#ifndef RELIEF_DEPTH_NODES_VISITED
#define RELIEF_DEPTH_NODES_VISITED
namespace relief::test {

// Indexed by the ray's position in its chunk.
inline std::vector<std::vector<VisitedNode>>& visitedNodes() {
    static std::vector<std::vector<VisitedNode>> all;
    return all;
}

}  // namespace relief::test
#endif

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

template <class Base>
struct NotingNodes : Base {
    static constexpr bool kRecords = true;
    static void visit(VI slot, VI level, VI x, VI y, VF depth, MF who) {
        const DF df;
        const DI di;
        HWY_ALIGN std::int32_t slots[kLanes], levels[kLanes], xs[kLanes], ys[kLanes], chosen[kLanes];
        HWY_ALIGN float depths[kLanes];
        hn::Store(slot, di, slots), hn::Store(level, di, levels);
        hn::Store(x, di, xs), hn::Store(y, di, ys);
        hn::Store(depth, df, depths);
        hn::Store(hn::IfThenElseZero(asInt(who), hn::Set(di, 1)), di, chosen);
        for (std::size_t k = 0; k < kLanes; ++k) {
            if (chosen[k] == 0) continue;
            test::visitedNodes()[static_cast<std::size_t>(slots[k])].push_back(
                {levels[k], xs[k], ys[k], 1 - static_cast<double>(depths[k])});
        }
    }
};

void traceNotingNodes(bool asTheReference, const FloatScene& scene, const DepthPyramid& depths, const RayBlock& rays,
                      std::size_t first, HitBlock& hits, LaneRays& scratch) {
    if (asTheReference) {
        tracePyramidOn<NotingNodes<PlainArithmetic>>(scene, depths, rays, first, hits, scratch);
    } else {
        tracePyramidOn<NotingNodes<FastArithmetic>>(scene, depths, rays, first, hits, scratch);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(traceNotingNodes);

namespace test {

std::vector<std::vector<VisitedNode>> nodesInLanes(const FloatScene& scene, const DepthPyramid& depths,
                                                   const RayBlock& rays, HitBlock& hits, bool asTheReference) {
    std::vector<std::vector<VisitedNode>> all;
    hits.resize(rays.size());
    traceChunks(
        0, rays.size(), hits,
        [&](std::size_t begin, std::size_t end, LaneRays& scratch) {
            scratch.count = end - begin;
            visitedNodes().assign(scratch.count, {});
            HWY_DYNAMIC_DISPATCH(traceNotingNodes)(asTheReference, scene, depths, rays, begin, hits, scratch);
            std::move(visitedNodes().begin(), visitedNodes().end(), std::back_inserter(all));
        },
        [](std::size_t, const LaneRays&) {});
    return all;
}

}  // namespace test
}  // namespace relief
#endif
