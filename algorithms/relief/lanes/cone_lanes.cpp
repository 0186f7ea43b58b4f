#include "relief/lanes/cone_lanes.h"

#include <algorithm>

// Vectors in structures: not for the instruction sets without a fixed width.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/lanes/cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/lanes/cone_beams-inl.h"
#include "relief/lanes/cone_walk-inl.h"
#include "relief/lanes/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

template <Address kAddress, Surface kSurface>
void traceConesIn(const LaneScene& scene, const PackedCones& cones, const double* const* columns,
                  const std::size_t* quadrants, HitBlock& hits, std::size_t firstHit, LaneRays& scratch) {
    static thread_local WalkColumns walk;
    scratch.start.fill(scene.start);
    if (scratch.count >= kBeamRays) {
        for (std::uint32_t q = 0; q < 4; ++q) {
            if (quadrants[q + 1] - quadrants[q] == scratch.count)
                leadBeams<kAddress>(scene, cones, q, columns, scratch);
        }
    }
    setUpLanes<kAddress>(scene, columns[0], columns[1], columns[2], columns[3], scratch);
    for (std::uint32_t q = 0; q < 4; ++q) {
        if (quadrants[q] == quadrants[q + 1]) continue;
        ConeKernel<kAddress, kSurface>(scene, cones, q, scratch, quadrants[q], quadrants[q + 1], walk).run();
    }
    settleLanes<kAddress, kSurface>(scene, columns[0], columns[1], columns[2], columns[3], scratch, hits, firstHit);
}

// The quadrant of all rays; 4: they have not one in common.
std::size_t commonQuadrant(const double* a, const double* b, std::size_t count) {
    const DD d;
    const auto sign = [&](const double* runs) {
        MD every = hn::FirstN(d, kHalfLanes), any = hn::MaskFromVec(hn::Zero(d));
        std::size_t i = 0;
        for (; i + kHalfLanes <= count; i += kHalfLanes) {
            const MD back = hn::Lt(hn::LoadU(d, runs + i), hn::Zero(d));
            every = hn::And(every, back), any = hn::Or(any, back);
        }
        bool all = count >= kHalfLanes ? hn::AllTrue(d, every) : runs[0] < 0;
        bool some = !hn::AllFalse(d, any);
        for (; i < count; ++i) all = all && runs[i] < 0, some = some || runs[i] < 0;
        return all ? 1 : (some ? 2 : 0);
    };
    const int x = sign(a), y = sign(b);
    return x == 2 || y == 2 ? 4 : static_cast<std::size_t>(x + 2 * y);
}

void traceCones(const LaneScene& scene, const PackedCones& cones, const double* const* columns,
                const std::size_t* quadrants, HitBlock& hits, std::size_t firstHit, LaneRays& scratch) {
    const auto with = [&]<Address kAddress>() {
        if (scene.surface == Surface::Bilinear) {
            traceConesIn<kAddress, Surface::Bilinear>(scene, cones, columns, quadrants, hits, firstHit, scratch);
        } else {
            traceConesIn<kAddress, Surface::Columns>(scene, cones, columns, quadrants, hits, firstHit, scratch);
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
HWY_EXPORT(commonQuadrant);

namespace {

// Rays of a chunk by quadrant of their direction; order[n]: which ray comes n-th.
struct QuadrantOrder {
    std::array<std::size_t, 5> begin{};
    bool sorted = true;
    std::array<std::uint16_t, kLaneChunk> order;
};

void orderByQuadrant(const RayBlock& rays, std::size_t first, std::size_t count, QuadrantOrder& out) {
    const std::size_t common =
        HWY_DYNAMIC_DISPATCH(commonQuadrant)(rays.a.data() + first, rays.b.data() + first, count);
    out.sorted = common < 4;
    for (std::size_t q = 0; q < 5; ++q) out.begin[q] = q <= common ? 0 : count;
    if (out.sorted) return;
    std::array<std::uint8_t, kLaneChunk> quadrant;
    std::array<std::size_t, 4> counts{};
    for (std::size_t i = 0; i < count; ++i) {
        quadrant[i] = static_cast<std::uint8_t>((rays.a[first + i] < 0 ? 1 : 0) + (rays.b[first + i] < 0 ? 2 : 0));
    }
    for (std::size_t i = 0; i < count; ++i) ++counts[quadrant[i]];
    out.begin[0] = 0;
    for (std::size_t q = 0; q < 4; ++q) out.begin[q + 1] = out.begin[q] + counts[q];
    std::array<std::size_t, 4> next{};
    std::copy_n(out.begin.begin(), 4, next.begin());
    for (std::size_t i = 0; i < count; ++i) out.order[next[quadrant[i]]++] = static_cast<std::uint16_t>(i);
}

}  // namespace

void traceConeLanes(const LaneScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch) {
    assert(last - first <= kLaneChunk);
    const std::size_t count = last - first;
    if (count == 0) return;
    scratch.count = count;
    static thread_local QuadrantOrder order;
    orderByQuadrant(rays, first, count, order);
    if (order.sorted) {
        const double* const columns[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                         rays.b.data() + first};
        HWY_DYNAMIC_DISPATCH(traceCones)(scene, cones, columns, order.begin.data(), hits, first, scratch);
    } else {
        static thread_local std::array<std::array<double, kLaneChunk>, 4> columns;
        static thread_local HitBlock found(kLaneChunk);
        const std::array<const std::vector<double>*, 4> from{&rays.s0, &rays.t0, &rays.a, &rays.b};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            for (std::size_t n = 0; n < count; ++n) columns[c][n] = (*from[c])[first + order.order[n]];
        }
        const double* const pointers[] = {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()};
        HWY_DYNAMIC_DISPATCH(traceCones)(scene, cones, pointers, order.begin.data(), found, 0, scratch);
        std::array<std::int32_t, kLaneChunk> ends;
        std::copy_n(scratch.end.begin(), count, ends.begin());
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t i = order.order[n];
            hits.lambda[first + i] = found.lambda[n];
            hits.s[first + i] = found.s[n];
            hits.t[first + i] = found.t[n];
            hits.outcome[first + i] = Outcome::Hit;
            scratch.end[i] = ends[n];
        }
    }
    if (scratch.allHit) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (scratch.end[i] == static_cast<std::int32_t>(LaneEnd::Miss)) hits.set(first + i, Hit::none(Outcome::Miss));
    }
}

}  // namespace relief
#endif
