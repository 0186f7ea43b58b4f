#include "relief/simd/cone_lanes.h"

#include <algorithm>
#include <cassert>

#include "relief/simd/cone_surfaces.h"

namespace relief {

void traceConeLanes(const FloatScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch) {
    assert(last - first <= kLaneChunk);
    scratch.count = last - first;
    scratch.behind = rays.size() - last;
    if (scratch.count == 0) return;
    const double* const given[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                   rays.b.data() + first};
    const auto trace = scene.surface == Surface::Bilinear ? traceConesBilinear : traceConesColumns;
    trace(scene, cones, given, hits, first, scratch);
    std::fill_n(hits.outcome.data() + first, scratch.count, Outcome::Hit);
}

void resumeConeLanes(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
                     HitBlock& hits) {
    assert(rays.count <= kLaneChunk);
    if (rays.count == 0) return;
    const auto resume = scene.surface == Surface::Bilinear ? resumeConesBilinear : resumeConesColumns;
    resume(scene, cones, given, rays, hits);
}

}  // namespace relief
