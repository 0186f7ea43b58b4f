#include "relief/lanes/cone_lanes.h"

#include <algorithm>

#include "relief/packed_walk.h"

// Vectors in structures: not for the instruction sets without a fixed width.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/lanes/cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/lanes/cone_beams-inl.h"
#include "relief/lanes/cone_walk-inl.h"
#include "relief/lanes/lane_settle-inl.h"
#include "relief/lanes/ray_quadrants-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

template <Address kAddress, Surface kSurface>
void traceConesIn(const LaneScene& scene, const PackedCones& cones, const double* const* given,
                  const QuadrantParts& parts, HitBlock& hits, std::size_t firstHit, LaneRays& scratch) {
    static thread_local WalkColumns walk;
    scratch.start.fill(scene.start);
    scratch.othersCount = 0;
    for (std::uint32_t q = 0; q < kQuadrants; ++q) {
        const std::size_t begin = parts.begin[q], end = parts.end[q];
        if (begin == end) continue;
        // A beam's rays are of one quadrant, and those of a view mostly come in order.
        if (end - begin == scratch.count && scratch.count >= kBeamRays)
            leadBeams<kAddress>(scene, cones, q, given, scratch);
        ConeKernel<kAddress, kSurface>(scene, cones, q, given, scratch, begin, end, walk).run();
        settleLanes<kAddress, kSurface>(scene, given, begin, end, (q & 1U) != 0, (q & 2U) != 0, scratch, hits,
                                        firstHit);
    }
}

void traceConesOf(const LaneScene& scene, const PackedCones& cones, const double* const* given,
                  const QuadrantParts& parts, HitBlock& hits, std::size_t firstHit, LaneRays& scratch) {
    const auto with = [&]<Address kAddress>() {
        if (scene.surface == Surface::Bilinear) {
            traceConesIn<kAddress, Surface::Bilinear>(scene, cones, given, parts, hits, firstHit, scratch);
        } else {
            traceConesIn<kAddress, Surface::Columns>(scene, cones, given, parts, hits, firstHit, scratch);
        }
    };
    switch (scene.address) {
        case Address::Repeat:
            return with.template operator()<Address::Repeat>();
        case Address::Clamp:
            return with.template operator()<Address::Clamp>();
        case Address::Border:
            return with.template operator()<Address::Border>();
    }
}

void traceCones(const LaneScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                std::size_t first, LaneRays& scratch) {
    const std::size_t common = commonQuadrant(given[2], given[3], scratch.count);
    if (common < kQuadrants) {
        QuadrantParts parts;
        parts.end[common] = scratch.count;
        traceConesOf(scene, cones, given, parts, hits, first, scratch);
        return;
    }
    static thread_local QuadrantOrder order;
    static thread_local HitBlock found(kLaneSlots);
    orderByQuadrant(given, scratch.count, order);
    const double* const ordered[] = {order.columns[0].data(), order.columns[1].data(), order.columns[2].data(),
                                     order.columns[3].data()};
    traceConesOf(scene, cones, ordered, order.parts, found, 0, scratch);
    const double* const from[] = {found.lambda.data(), found.s.data(), found.t.data()};
    double* const to[] = {hits.lambda.data() + first, hits.s.data() + first, hits.t.data() + first};
    for (std::size_t q = 0; q < kQuadrants; ++q) {
        for (std::size_t n = order.parts.begin[q]; n < order.parts.end[q]; ++n) {
            const auto i = static_cast<std::size_t>(order.from[n]);
            for (std::size_t c = 0; c < 3; ++c) to[c][i] = from[c][n];
        }
    }
    for (std::size_t n = 0; n < scratch.othersCount; ++n) {
        scratch.others[n].ray = static_cast<std::uint32_t>(order.from[scratch.others[n].ray]);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(traceCones);

void traceConeLanes(const LaneScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch) {
    assert(last - first <= kLaneChunk);
    scratch.count = last - first;
    if (scratch.count == 0) return;
    const double* const given[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                   rays.b.data() + first};
    HWY_DYNAMIC_DISPATCH(traceCones)(scene, cones, given, hits, first, scratch);
    std::fill_n(hits.outcome.data() + first, scratch.count, Outcome::Hit);
}

void traceByCones(const HeightField& field, const LaneScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat) {
    static thread_local std::vector<PackedStart> starts;
    const auto rest = [&](std::size_t begin, const LaneRays& scratch) {
        starts.clear();
        for (std::size_t n = 0; n < scratch.othersCount; ++n) {
            const LaneRays::Other& other = scratch.others[n];
            if (other.end != LaneEnd::Scalar) continue;
            const std::size_t i = begin + other.ray;
            packedWalks(scene.grid, rays[i]) ? starts.push_back({i, other.from}) : flat.push_back(i);
        }
        packedHits(field, scene.grid, cones, rays, starts, hits);
    };
    traceChunks(
        first, last, hits,
        [&](std::size_t begin, std::size_t end, LaneRays& scratch) {
            traceConeLanes(scene, cones, rays, begin, end, hits, scratch);
        },
        rest);
}

}  // namespace relief
#endif
