// The templates that cone_lanes_bilinear.cpp and cone_lanes_columns.cpp instantiate for their surface type. They are
// two source files because both together take a minute to compile. Compiled for each target.

#if defined(RELIEF_CONE_ENTRY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_ENTRY_INL_H
#undef RELIEF_CONE_ENTRY_INL_H
#else
#define RELIEF_CONE_ENTRY_INL_H
#endif

#include <memory>

#include "relief/simd/candidates-inl.h"
#include "relief/simd/cone_beams-inl.h"
#include "relief/simd/cone_packets-inl.h"
#include "relief/simd/cone_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// The buffers of this thread. They are allocated on first use, since thread-local storage would be reserved in every
// thread.
inline WalkColumns& columnsOfThread() {
    static thread_local const auto columns = std::make_unique<WalkColumns>();
    return *columns;
}

inline PacketColumns& packetsOfThread() {
    static thread_local const auto columns = std::make_unique<PacketColumns>();
    return *columns;
}

template <Address kAddress, Surface kSurface, class Arithmetic>
void resumeConesIn(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                   HitBlock& hits) {
    rays.othersCount = 0;
    rays.start.fill(scene.start);
    for (LaneAxisRays* axis : {&rays.x, &rays.y}) {
        hn::StoreU(hn::Zero(DI()), DI(), axis->hitCell.data() + rays.count);
        hn::StoreU(hn::Zero(DI()), DI(), axis->hitPeriod.data() + rays.count);
    }
    hn::StoreU(hn::Zero(DI()), DI(), rays.within.data() + rays.count);
    ConeKernel<kAddress, kSurface, Arithmetic>(scene, WalkMap(cones, true), given, rays, true, columnsOfThread()).run();
    resolveCandidates<kAddress, kSurface>(scene, given, rays, hits, 0);
}

template <Address kAddress, Surface kSurface, class Arithmetic>
void traceConesIn(const FloatScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                  std::size_t firstHit, LaneRays& scratch) {
    WalkColumns& walk = columnsOfThread();
    scratch.start.fill(scene.start);
    scratch.othersCount = 0;
    bool scattered = true;
    if (Arithmetic::kBeams && scratch.count >= kBeamRays) {
        // The rays of a beam need a common quadrant. Those of a view mostly have one, in which case they also come in
        // the order of neighbouring pixels.
        const std::size_t common = commonQuadrant(given[2], given[3], scratch.count);
        if (common < kQuadrants) {
            const auto quadrant = static_cast<std::uint32_t>(common);
            scattered = false;
            if constexpr (kLanes >= kLeastPacket) {
                PacketColumns& columns = packetsOfThread();
                PacketWalk<kAddress, kSurface, Arithmetic> packets(scene, cones, quadrant, given, scratch, columns);
                packets.run();
                const std::size_t left = scratch.count - packets.taken();
                if (8 * left > scratch.count) leadBeams<kAddress>(scene, cones, quadrant, given, scratch);
                if (left > 0) {
                    ConeKernel<kAddress, kSurface, Arithmetic> singles(scene, WalkMap(cones, false), given, scratch,
                                                                       false, walk);
                    singles.only(columns.left);
                    singles.run();
                }
                packets.keep();
                resolveCandidates<kAddress, kSurface>(scene, given, scratch, hits, firstHit);
                return;
            }
            leadBeams<kAddress>(scene, cones, quadrant, given, scratch);
        }
    }
    ConeKernel<kAddress, kSurface, Arithmetic>(scene, WalkMap(cones, scattered), given, scratch, false, walk).run();
    resolveCandidates<kAddress, kSurface>(scene, given, scratch, hits, firstHit);
}

template <Surface kSurface, class Arithmetic = FastArithmetic>
void traceConesOn(const FloatScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                  std::size_t firstHit, LaneRays& scratch) {
    forAddress(scene, [&]<Address kAddress>() {
        traceConesIn<kAddress, kSurface, Arithmetic>(scene, cones, given, hits, firstHit, scratch);
    });
}

template <Surface kSurface, class Arithmetic = FastArithmetic>
void resumeConesOn(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                   HitBlock& hits) {
    forAddress(scene, [&]<Address kAddress>() {
        resumeConesIn<kAddress, kSurface, Arithmetic>(scene, cones, given, rays, hits);
    });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
