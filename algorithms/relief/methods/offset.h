// offset: parallax mapping; one sample, after which the ray is advanced to the height at its point of entry. Kaneko et
// al. 2001; the formula printed in [DIST17] (whose reference plane is the bottom of the slab, here the top).
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: the surface is taken as flat, as high as at the point of entry: T = T0 + (1 - h(T0)) (a, b).
// Guarantee: none. Failure mode: anything steep; grazing rays slide far over the picture ("swimming").
// Cost: one height.
#pragma once

#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/methods/offset_lanes.h"
#include "relief/sampled_surface.h"

namespace relief {

class OffsetTracer {
  public:
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "offset";
        method.title = "parallax offset";
        method.guarantee = Guarantee::Approximate;
        method.tiled = true;
        method.help = "One sample: the ray advances to the height sampled where it enters.";
        method.source = "Kaneko et al. 2001; [DIST17]";
        return method;
    }
    static OffsetTracer make(const HeightField& field, const Options&, MapCache&, Work&) { return OffsetTracer(field); }

    explicit OffsetTracer(HeightField field) : field_(std::move(field)) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        return shifted(field_, ray, 1.0, sink);
    }
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return shiftedWithin(field_, ray, segment, 1.0, sink);
    }
    // The SIMD version, with the same results: sets hits for the rays first to last - 1.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        for (const std::size_t i : offsetSimd({field_, false}, rays, first, last, hits)) {
            hits.set(i, trace(rays[i], sink));
        }
    }
    double segmentRecords() const { return 3; }

    // The result of both offset methods: lambda = (1 - h(T0)) * share.
    template <class Sink>
    static Hit shifted(const HeightField& field, const ViewRay& ray, double share, Sink& sink) {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        const SampledSurface surface(field, ray);
        const auto miss = [&](double at) {
            sink.step([&] { return surface.record(Phase::Search, Decision::Miss, at, at, 0, at); });
            return Hit::none(Outcome::Miss);
        };
        sink.step([&] { return surface.record(Phase::Start, Decision::Start, 0, 0, 1, 0); });
        if (!surface.inside(0)) return miss(0);
        const double height = surface.heightAt(0);
        sink.read(surface.readsEach());
        const double lambda = (1 - height) * share;
        if (!surface.inside(lambda)) return miss(lambda);
        sink.step([&] { return surface.record(Phase::Search, Decision::Hit, 0, lambda, height, lambda); });
        return Hit::at(ray, lambda);
    }

    // The same from the begin of a segment. A miss if the sampled height is reached after the segment's end.
    template <class Sink>
    static Hit shiftedWithin(const HeightField& field, const ViewRay& ray, Segment segment, double share, Sink& sink) {
        const SampledSurface surface(field, ray);
        if (!surface.inside(segment.in)) return Hit::none(Outcome::Miss);
        const double height = surface.heightAt(segment.in);
        sink.read(surface.readsEach());
        const double reached = std::max(1 - height, segment.in);
        const bool hit = reached <= segment.out;
        const double lambda = hit ? segment.in + (reached - segment.in) * share : segment.out;
        const Decision decision = hit ? Decision::Hit : Decision::Advance;
        sink.step([&] { return surface.record(Phase::Search, decision, segment.in, lambda, height, lambda); });
        return hit ? Hit::at(ray, lambda) : Hit::none(Outcome::Miss);
    }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return 0; }
    double stepBound(const ViewRay&) const { return 2; }

  private:
    HeightField field_;
};

}  // namespace relief
