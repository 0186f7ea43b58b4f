// What both interpolating distance tracers share: a fixed number of steps, each by the trilinear distance. Donnelly
// 2005. Not safe: an interpolated distance reaches beyond the surface at edges.
#pragma once

#include "relief/distance_lanes.h"
#include "relief/maps/distance_map.h"
#include "relief/sampled_surface.h"

namespace relief {

class DistanceFixed {
  public:
    DistanceFixed(HeightField field, std::shared_ptr<const DistanceMap> map, int iterations)
        : field_(std::move(field)), map_(std::move(map)), iterations_(iterations) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        const SampledSurface surface(field_, ray);
        sink.step([&] { return surface.record(Phase::Start, Decision::Start, 0, 0, 1, 0); });
        if (!surface.inside(0)) {
            sink.step([&] { return surface.record(Phase::Search, Decision::Miss, 0, 0, 0, 0); });
            return Hit::none(Outcome::Miss);
        }
        return march(ray, surface, {}, true, sink);
    }
    // The same bits in lanes: rays first to last - 1.
    void traceLanes(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        for (const std::size_t i : marchInLanes({field_, *map_, iterations_}, rays, first, last, hits)) {
            hits.set(i, trace(rays[i], sink));
        }
    }
    // Counts as a hit if the steps did not lead out of the segment.
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return march(ray, SampledSurface(field_, ray), segment, false, sink);
    }

    const HeightField& field() const { return field_; }
    const std::shared_ptr<const DistanceMap>& distanceMap() const { return map_; }
    std::size_t bytes() const { return map_->bytes(); }
    double stepBound(const ViewRay&) const { return iterations_ + 3.0; }
    double segmentRecords() const { return iterations_ + 3.0; }

  private:
    template <class Sink>
    Hit march(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole, Sink& sink) const;

    // Voxels are named where the step begins: there the distance was read.
    Step record(const SampledSurface& surface, Decision decision, double in, double value, double after) const {
        Step step = surface.record(Phase::Search, decision, in, in, value, after);
        step.lambdaOut = after;
        step.i = step.i * map_->nx() / field_.width();
        step.j = step.j * map_->ny() / field_.height();
        step.k = static_cast<std::int64_t>(std::clamp((1 - in) * map_->layers(), 0.0, map_->layers() - 1.0));
        return step;
    }

    HeightField field_;
    std::shared_ptr<const DistanceMap> map_;
    int iterations_;
};

template <class Sink>
Hit DistanceFixed::march(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole,
                         Sink& sink) const {
    const double perLambda = std::hypot(std::hypot(ray.a, ray.b), map_->slabTexels);
    double lambda = segment.in;
    const auto step = [&](Decision decision, double in, double value, double after) {
        sink.step([&] { return record(surface, decision, in, value, after); });
    };
    for (int n = 0; n < iterations_ && lambda < segment.out; ++n) {
        const auto [s, t] = surface.placeAt(lambda);
        const double distance = map_->trilinear(s, t, 1 - lambda);
        sink.read(8);
        const double after = perLambda > 0 ? std::min(lambda + distance / perLambda, 1.0) : 1.0;
        step(Decision::Advance, lambda, distance, after);
        lambda = after;
        if (surface.inside(lambda)) continue;
        if (whole) step(Decision::Miss, lambda, 0, lambda);
        return Hit::none(Outcome::Miss);
    }
    const bool left = !(lambda < segment.out) && segment.out < 1;
    if (left) return Hit::none(Outcome::Miss);
    step(Decision::Hit, lambda, 0, lambda);
    return Hit::at(ray, lambda);
}

}  // namespace relief
