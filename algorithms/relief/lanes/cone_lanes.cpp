#include "relief/lanes/cone_lanes.h"

#include <algorithm>
#include <cassert>
#include <memory>

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
WalkColumns& columnsOfThread() {
    static thread_local const auto columns = std::make_unique<WalkColumns>();
    return *columns;
}

template <Address kAddress, Surface kSurface>
void goOnIn(const LaneScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
            HitBlock& hits) {
    rays.othersCount = 0;
    rays.start.fill(scene.start);
    for (LaneAxisRays* axis : {&rays.x, &rays.y}) {
        hn::StoreU(hn::Zero(DI()), DI(), axis->hitCell.data() + rays.count);
        hn::StoreU(hn::Zero(DI()), DI(), axis->hitPeriod.data() + rays.count);
    }
    hn::StoreU(hn::Zero(DI()), DI(), rays.within.data() + rays.count);
    ConeKernel<kAddress, kSurface>(scene, WalkMap(cones, true), given, rays, true, columnsOfThread()).run();
    settleLanes<kAddress, kSurface>(scene, given, rays, hits, 0);
}

template <Address kAddress, Surface kSurface>
void traceConesIn(const LaneScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                  std::size_t firstHit, LaneRays& scratch) {
    WalkColumns& walk = columnsOfThread();
    scratch.start.fill(scene.start);
    scratch.othersCount = 0;
    bool scattered = true;
    if (scratch.count >= kBeamRays) {
        // A beam's rays are of one quadrant, and those of a view mostly come in order.
        const std::size_t common = commonQuadrant(given[2], given[3], scratch.count);
        if (common < kQuadrants) {
            leadBeams<kAddress>(scene, cones, static_cast<std::uint32_t>(common), given, scratch);
            scattered = false;
        }
    }
    ConeKernel<kAddress, kSurface>(scene, WalkMap(cones, scattered), given, scratch, false, walk).run();
    settleLanes<kAddress, kSurface>(scene, given, scratch, hits, firstHit);
}

// body<address, surface>() of the scene's.
template <class Body>
void forScene(const LaneScene& scene, const Body& body) {
    const auto with = [&]<Address kAddress>() {
        if (scene.surface == Surface::Bilinear) {
            body.template operator()<kAddress, Surface::Bilinear>();
        } else {
            body.template operator()<kAddress, Surface::Columns>();
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
                std::size_t firstHit, LaneRays& scratch) {
    forScene(scene, [&]<Address kAddress, Surface kSurface>() {
        traceConesIn<kAddress, kSurface>(scene, cones, given, hits, firstHit, scratch);
    });
}

void goOn(const LaneScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
          HitBlock& hits) {
    forScene(scene, [&]<Address kAddress, Surface kSurface>() {
        goOnIn<kAddress, kSurface>(scene, cones, given, rays, hits);
    });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(traceCones);
HWY_EXPORT(goOn);

void traceConeLanes(const LaneScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch) {
    assert(last - first <= kLaneChunk);
    scratch.count = last - first;
    scratch.behind = rays.size() - last;
    if (scratch.count == 0) return;
    const double* const given[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                   rays.b.data() + first};
    HWY_DYNAMIC_DISPATCH(traceCones)(scene, cones, given, hits, first, scratch);
    std::fill_n(hits.outcome.data() + first, scratch.count, Outcome::Hit);
}

void goOnConeLanes(const LaneScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                   HitBlock& hits) {
    assert(rays.count <= kLaneChunk);
    if (rays.count > 0) HWY_DYNAMIC_DISPATCH(goOn)(scene, cones, given, rays, hits);
}

}  // namespace relief
#endif
