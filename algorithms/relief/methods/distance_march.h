// What both interpolating distance tracers share: each step advances by the trilinearly interpolated distance, until
// the ray reaches the surface. Donnelly 2005; [DIST17] fig. 4. Not safe: at edges an interpolated distance reaches
// beyond the surface.
//
// Frame and units: ray.h; those of the map: distance_map.h.
// Model, by MarchStop:
// - Surface ([DIST17]): before each step the height of the surface at the ray is sampled. Tracing ends where the ray is
// not above it; the hit is where the straight line between the last two heights meets the ray.
// - Distance: tracing ends where the distance is below `within`; the hit is the ray's position.
// - Never: all `iterations` steps are taken, as in Donnelly's shader.
// After `iterations` steps the hit is the ray's position in each case. A ray flatter than those that the map serves
// walks every cell instead, as in `exact`.
#pragma once

#include "relief/maps/distance_map.h"
#include "relief/methods/distance_march_lanes.h"
#include "relief/methods/exact.h"
#include "relief/ray_length.h"
#include "relief/sampled_surface.h"

namespace relief {

class DistanceMarch {
  public:
    DistanceMarch(HeightField field, std::shared_ptr<const DistanceMap> map, int iterations, MarchEnd end)
        : exact_(std::move(field)), map_(std::move(map)), iterations_(iterations), end_(end) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        if (!serves(ray)) return exact_.trace(ray, sink);
        const SampledSurface surface(field(), ray);
        sink.step([&] { return surface.record(Phase::Start, Decision::Start, 0, 0, 1, 0); });
        if (!surface.inside(0)) {
            sink.step([&] { return surface.record(Phase::Search, Decision::Miss, 0, 0, 0, 0); });
            return Hit::none(Outcome::Miss);
        }
        return march(ray, surface, {}, true, sink);
    }
    // The SIMD version, with the same results: sets hits for the rays first to last - 1.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        for (const std::size_t i : marchSimd({field(), *map_, iterations_, end_}, rays, first, last, hits)) {
            hits.set(i, trace(rays[i], sink));
        }
    }
    // The result is a hit unless the steps lead out of the segment.
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        if (!serves(ray)) return exact_.traceSegment(ray, segment, sink);
        return march(ray, SampledSurface(field(), ray), segment, false, sink);
    }

    const HeightField& field() const { return exact_.field(); }
    const std::shared_ptr<const DistanceMap>& distanceMap() const { return map_; }
    std::size_t bytes() const { return map_->bytes(); }
    double stepBound(const ViewRay& ray) const { return serves(ray) ? iterations_ + 3.0 : exact_.stepBound(ray); }
    double segmentRecords() const { return iterations_ + 3.0; }

  private:
    bool serves(const ViewRay& ray) const { return std::hypot(ray.a, ray.b) <= map_->maxRun; }

    template <class Sink>
    Hit march(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole, Sink& sink) const;

    // Record of a step from lambda `in`, with the voxel from which its distance is fetched.
    Step record(const SampledSurface& surface, Decision decision, double in, double value, double after) const {
        Step step = surface.record(Phase::Search, decision, in, in, value, after);
        subject::Sphere sphere = surface.sphereAt(in, value);
        sphere.refined = map_->refined();
        step.subject = sphere;
        step.lambdaOut = after;
        step.i = step.i * map_->nx() / field().width();
        step.j = step.j * map_->ny() / field().height();
        step.k = static_cast<std::int64_t>(std::clamp((1 - in) * map_->layers(), 0.0, map_->layers() - 1.0));
        return step;
    }

    ExactTracer exact_;
    std::shared_ptr<const DistanceMap> map_;
    int iterations_;
    MarchEnd end_;
};

template <class Sink>
Hit DistanceMarch::march(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole,
                         Sink& sink) const {
    const double perLambda = texelsPerLambda(ray.a, ray.b, map_->slabTexels);
    double lambda = segment.in;
    // lambda of the last point above the surface; its surface minus ray, negative, is gapAbove
    double above = lambda;
    double gapAbove = 0;
    const auto hit = [&](const auto& make, double answer) {
        sink.step(make);
        return Hit::at(ray, answer);
    };
    for (int n = 0; n < iterations_ && lambda < segment.out; ++n) {
        if (end_.stop == MarchStop::Surface) {
            const double gap = surface.gapAt(lambda);
            sink.read(surface.readsEach());
            if (gap >= 0) {
                const double answer = n > 0 ? above + gapAbove / (gapAbove - gap) * (lambda - above) : lambda;
                return hit(
                    [&] {
                        return surface.record(Phase::Search, Decision::Hit, above, lambda, gap + 1 - lambda, answer);
                    },
                    answer);
            }
            above = lambda;
            gapAbove = gap;
        }
        const auto [s, t] = surface.placeAt(lambda);
        const double distance = map_->trilinear(s, t, 1 - lambda);
        sink.read(8);
        if (end_.stop == MarchStop::Distance && distance < end_.within) {
            return hit([&] { return record(surface, Decision::Hit, lambda, distance, lambda); }, lambda);
        }
        const double after = perLambda > 0 ? std::min(lambda + distance / perLambda, 1.0) : 1.0;
        sink.step([&] { return record(surface, Decision::Advance, lambda, distance, after); });
        lambda = after;
        if (surface.inside(lambda)) continue;
        if (whole) sink.step([&] { return surface.record(Phase::Search, Decision::Miss, lambda, lambda, 0, lambda); });
        return Hit::none(Outcome::Miss);
    }
    const bool left = !(lambda < segment.out) && segment.out < 1;
    if (left) return Hit::none(Outcome::Miss);
    // The ray has reached the floor of the slab, or all steps are used.
    return hit(
        [&] { return surface.record(Phase::Search, Decision::Hit, lambda, lambda, surface.heightAt(lambda), lambda); },
        lambda);
}

}  // namespace relief
