#include "relief/lanes/cone_lanes.h"

#include <algorithm>
#include <memory>

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

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Of this thread. Not in its own storage: that is set aside for every thread from the start.
template <class T>
T& ofThread() {
    static thread_local const auto scratch = std::make_unique<T>();
    return *scratch;
}

// Rays whose cell the exact leaf refused, by themselves.
struct Refused {
    LaneRays rays;
    alignas(64) std::array<std::array<double, kLaneSlots>, 4> columns;  // s0, t0, a, b
    std::array<std::uint32_t, kLaneSlots> of;                           // which ray of the chunk it is
    HitBlock found = HitBlock(kLaneSlots);
    std::size_t count = 0;

    // other: of the rays `from`, whose columns are given; it is the ray `number` of the chunk.
    void add(const LaneRays& from, const double* const* given, const LaneRays::Other& other, std::uint32_t number) {
        for (std::size_t c = 0; c < columns.size(); ++c) columns[c][count] = given[c][other.ray];
        rays.x.hitCell[count] = from.x.hitCell[other.ray], rays.y.hitCell[count] = from.y.hitCell[other.ray];
        rays.x.hitPeriod[count] = from.x.hitPeriod[other.ray], rays.y.hitPeriod[count] = from.y.hitPeriod[other.ray];
        of[count++] = number;
    }
};

bool isRefused(const LaneRays::Other& other) {
    return other.end == LaneEnd::Scalar && other.from > 0;
}

// Rays that the exact leaf refuses go on behind their cells, together: they wait for memory together.
template <Address kAddress, Surface kSurface>
void goOn(const LaneScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
          std::size_t firstHit, LaneRays& scratch, WalkColumns& walk) {
    // Fewer, or more often refused: one by one.
    constexpr std::size_t kFew = 4;
    constexpr int kMostTimes = 4;
    Refused& refused = ofThread<Refused>();
    LaneRays& rays = refused.rays;
    const double* const columns[] = {refused.columns[0].data(), refused.columns[1].data(), refused.columns[2].data(),
                                     refused.columns[3].data()};
    const auto scalarBegin = std::partition(scratch.others.begin(),
                                            scratch.others.begin() + static_cast<std::ptrdiff_t>(scratch.othersCount),
                                            [](const LaneRays::Other& other) { return !isRefused(other); });
    const auto settledCount = static_cast<std::size_t>(scalarBegin - scratch.others.begin());
    if (scratch.othersCount - settledCount < kFew) return;
    refused.count = 0;
    for (std::size_t n = settledCount; n < scratch.othersCount; ++n) {
        refused.add(scratch, given, scratch.others[n], scratch.others[n].ray);
    }
    scratch.othersCount = settledCount;
    for (int times = 0; refused.count > 0; ++times) {
        rays.count = refused.count;
        rays.othersCount = 0;
        rays.start.fill(scene.start);
        for (LaneAxisRays* axis : {&rays.x, &rays.y}) {
            hn::StoreU(hn::Zero(DI()), DI(), axis->hitCell.data() + rays.count);
            hn::StoreU(hn::Zero(DI()), DI(), axis->hitPeriod.data() + rays.count);
        }
        ConeKernel<kAddress, kSurface>(scene, WalkMap(cones, true), columns, rays, true, walk).run();
        settleLanes<kAddress, kSurface>(scene, columns, rays, refused.found, 0);
        for (std::size_t n = 0; n < rays.count; ++n) {
            const std::size_t i = firstHit + refused.of[n];
            hits.lambda[i] = refused.found.lambda[n];
            hits.s[i] = refused.found.s[n];
            hits.t[i] = refused.found.t[n];
        }
        refused.count = 0;
        for (std::size_t n = 0; n < rays.othersCount; ++n) {
            const LaneRays::Other other = rays.others[n];
            const std::uint32_t number = refused.of[other.ray];
            if (isRefused(other) && times + 1 < kMostTimes) {
                refused.add(rays, columns, other, number);
            } else {
                scratch.others[scratch.othersCount++] = {number, other.end, other.from};
            }
        }
    }
}

template <Address kAddress, Surface kSurface>
void traceConesIn(const LaneScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                  std::size_t firstHit, LaneRays& scratch) {
    WalkColumns& walk = ofThread<WalkColumns>();
    scratch.start.fill(scene.start);
    scratch.othersCount = 0;
    bool scattered = true;
    if (scratch.count >= kBeamRays) {
        // A beam's rays are of one quadrant, and those of a view mostly come in order.
        const std::size_t common = commonQuadrant(given[2], given[3], scratch.count);
        if (common < kQuadrants) {
            leadBeams<kAddress>(scene, cones, static_cast<std::uint32_t>(common), given, scratch);
            scattered = std::max(std::abs(given[2][0]), std::abs(given[3][0])) > kShortWay;
        }
    }
    ConeKernel<kAddress, kSurface>(scene, WalkMap(cones, scattered), given, scratch, false, walk).run();
    settleLanes<kAddress, kSurface>(scene, given, scratch, hits, firstHit);
    goOn<kAddress, kSurface>(scene, cones, given, hits, firstHit, scratch, walk);
}

void traceCones(const LaneScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                std::size_t firstHit, LaneRays& scratch) {
    const auto with = [&]<Address kAddress>() {
        if (scene.surface == Surface::Bilinear) {
            traceConesIn<kAddress, Surface::Bilinear>(scene, cones, given, hits, firstHit, scratch);
        } else {
            traceConesIn<kAddress, Surface::Columns>(scene, cones, given, hits, firstHit, scratch);
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
