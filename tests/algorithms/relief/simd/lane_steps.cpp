#include "lane_steps.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/relief/simd/lane_steps.cpp"
#include <hwy/foreach_target.h>
// Included after foreach_target.h.
#include "relief/simd/distance_march_lanes-inl.h"
#include "relief/simd/distance_walk_lanes-inl.h"
#include "relief/simd/layer_lanes-inl.h"
#include "relief/simd/offset_lanes-inl.h"
#include "relief/simd/texel_cone_lanes-inl.h"
#include "relief/visibility/packed_cone_any_lanes-inl.h"

#ifndef RELIEF_LANE_STEPS_NOTED
#define RELIEF_LANE_STEPS_NOTED
namespace relief::test {

inline std::vector<LaneSteps>& noted() {
    static std::vector<LaneSteps> all;
    return all;
}

}  // namespace relief::test
#endif

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

struct NotedVisits {
    static constexpr bool kRecords = true;
    template <class... Vectors>
    static void visit(const std::array<std::size_t, kLanes>& rays, std::uint32_t lanes, Vectors... numbers) {
        std::array<Row<double>, sizeof...(numbers)> rows;
        std::size_t next = 0;
        (store(numbers, rows[next++]), ...);
        overLanes(lanes, [&](std::size_t k) {
            std::vector<double>& step = test::noted()[rays[k]].emplace_back();
            for (const Row<double>& row : rows) step.push_back(row[k]);
        });
    }
};

void noteWalk(const DistanceWalk& walk, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& left,
              const Segment* segments) {
    RayQueue<DistanceWalk> queue{walk, rays, hits, 0, rays.size(), left, segments};
    runAlternating<VoxelWalk<NotedVisits>>(queue);
}
void noteMarch(const MarchSearch& search, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& left) {
    RayQueue<MarchSearch> queue{search, rays, hits, 0, rays.size(), left};
    runAlternating<DistanceSteps<NotedVisits>>(queue);
}
void noteLayers(const LayerSearch& search, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& left) {
    LayerQueue queue{{search, rays, hits, 0, rays.size(), left}, {}};
    runAlternating<LayerWalk<NotedVisits>>(queue);
}
void noteOffsets(const OffsetSearch& search, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& left) {
    OffsetLanes<NotedVisits>(search, rays, hits, left).run(0, rays.size());
}
void noteConeCells(const ConeCellSearch& search, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& left,
                   const Segment* segments) {
    RayQueue<ConeCellSearch> queue{search, rays, hits, 0, rays.size(), left, segments};
    runAlternating<ConeCells<NotedVisits>>(queue);
}
void noteConeMarch(const ConeMarchSearch& search, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& left,
                   const Segment* segments) {
    BracketQueue<ConeMarchSearch> queue{{search, rays, hits, 0, rays.size(), left, segments}, {}};
    runAlternating<ConeSteps<NotedVisits>>(queue);
    bisect<NotedVisits>(queue);
}
void noteQueries(const PackedConeAnyHit& query, const AnyRayBlock& rays, Visibility* results) {
    runQueries<NotedVisits>(query, rays, 0, rays.size(), results);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(noteWalk);
HWY_EXPORT(noteMarch);
HWY_EXPORT(noteLayers);
HWY_EXPORT(noteOffsets);
HWY_EXPORT(noteConeCells);
HWY_EXPORT(noteConeMarch);
HWY_EXPORT(noteQueries);

namespace test {

namespace {

template <class Kernel>
std::vector<LaneSteps> notedBy(const RayBlock& rays, const Kernel& kernel) {
    noted().assign(rays.size(), {});
    HitBlock hits;
    hits.resize(rays.size());
    std::vector<std::size_t> left;
    kernel(hits, left);
    return std::move(noted());
}

}  // namespace

std::vector<LaneSteps> stepsInLanes(const DistanceWalk& walk, const RayBlock& rays, const Segment* segments) {
    return notedBy(rays, [&](auto&... rest) { HWY_DYNAMIC_DISPATCH(noteWalk)(walk, rays, rest..., segments); });
}
std::vector<LaneSteps> stepsInLanes(const MarchSearch& search, const RayBlock& rays) {
    return notedBy(rays, [&](auto&... rest) { HWY_DYNAMIC_DISPATCH(noteMarch)(search, rays, rest...); });
}
std::vector<LaneSteps> stepsInLanes(const LayerSearch& search, const RayBlock& rays) {
    return notedBy(rays, [&](auto&... rest) { HWY_DYNAMIC_DISPATCH(noteLayers)(search, rays, rest...); });
}
std::vector<LaneSteps> stepsInLanes(const OffsetSearch& search, const RayBlock& rays) {
    return notedBy(rays, [&](auto&... rest) { HWY_DYNAMIC_DISPATCH(noteOffsets)(search, rays, rest...); });
}
std::vector<LaneSteps> stepsInLanes(const ConeCellSearch& search, const RayBlock& rays, const Segment* segments) {
    return notedBy(rays, [&](auto&... rest) { HWY_DYNAMIC_DISPATCH(noteConeCells)(search, rays, rest..., segments); });
}
std::vector<LaneSteps> stepsInLanes(const ConeMarchSearch& search, const RayBlock& rays, const Segment* segments) {
    return notedBy(rays, [&](auto&... rest) { HWY_DYNAMIC_DISPATCH(noteConeMarch)(search, rays, rest..., segments); });
}
std::vector<LaneSteps> stepsInLanes(const PackedConeAnyHit& query, const AnyRayBlock& rays) {
    noted().assign(rays.size(), {});
    std::vector<Visibility> results(rays.size());
    HWY_DYNAMIC_DISPATCH(noteQueries)(query, rays, results.data());
    return std::move(noted());
}

}  // namespace test
}  // namespace relief
#endif
