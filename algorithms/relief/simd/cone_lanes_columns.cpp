#include "relief/simd/cone_surfaces.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/simd/cone_lanes_columns.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/cone_entry-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

void traceColumns(const FloatScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                  std::size_t firstHit, LaneRays& scratch) {
    traceConesOn<Surface::Columns>(scene, cones, given, hits, firstHit, scratch);
}

void resumeColumns(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                   HitBlock& hits) {
    resumeConesOn<Surface::Columns>(scene, cones, given, rays, hits);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(traceColumns);
HWY_EXPORT(resumeColumns);

void traceConesColumns(const FloatScene& scene, const PackedCones& cones, const double* const* given, HitBlock& hits,
                       std::size_t firstHit, LaneRays& scratch) {
    HWY_DYNAMIC_DISPATCH(traceColumns)(scene, cones, given, hits, firstHit, scratch);
}

void resumeConesColumns(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                        HitBlock& hits) {
    HWY_DYNAMIC_DISPATCH(resumeColumns)(scene, cones, given, rays, hits);
}

}  // namespace relief
#endif
