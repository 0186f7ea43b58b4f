// What the cone tracers of shaders share: a number of steps to the edge of the interpolated cone. Dummer 2006;
// Policarpo & Oliveira 2007. Whether a step is safe depends on the map: most cones are not, once they are interpolated.
// SIMD: simd/texel_cone_lanes-inl.h.
#pragma once

#include <algorithm>

#include "relief/maps/cone_map.h"
#include "relief/methods/lane_fallback.h"
#include "relief/methods/texel_cone_lanes.h"
#include "relief/sampled_surface.h"

namespace relief {

// Describes the fields of those of these members that the struct of options has.
template <class Options>
std::vector<OptionField<Options>> coneFields() {
    std::vector<OptionField<Options>> fields{
        {{"iterations", OptionKind::Integer, "steps", 1, 4096, 1, {}, "largest number of steps"},
         &Options::iterations}};
    if constexpr (requires(Options o) { o.bisections; }) {
        fields.push_back(
            {{"bisections", OptionKind::Integer, "halvings", 0, 60, 1, {}, "number of bisections of the last step"},
             &Options::bisections});
        fields.push_back({{"radius",
                           OptionKind::Integer,
                           "texels",
                           1,
                           1024,
                           1,
                           {},
                           "search radius for the obstacles that limit a cone"},
                          &Options::radius});
    }
    if constexpr (requires(Options o) { o.directions; }) {
        fields.push_back({{"directions",
                           OptionKind::Integer,
                           "azimuths",
                           4,
                           256,
                           1,
                           {},
                           "number of azimuths along which cones are measured"},
                          &Options::directions});
    }
    fields.push_back(
        {{"precision", OptionKind::Choice, "", 0, 0, 0, {"float", "u16", "u8"}, "storage format of the cones"},
         &Options::precision});
    return fields;
}

// The parameters of the map that the options describe.
template <class Options>
ConeParameters coneParameters(const Options& options) {
    ConeParameters parameters;
    parameters.precision = parsePrecision(options.precision);
    if constexpr (requires { options.radius; }) parameters.radius = options.radius;
    if constexpr (requires { options.directions; }) parameters.directions = options.directions;
    return parameters;
}

class ConeMarch {
  public:
    // iterations: largest number of cone steps. bisections: number of halvings of the last step once a point below the
    // surface is found.
    ConeMarch(HeightField field, std::shared_ptr<const ConeMap> map, int iterations, int bisections)
        : field_(std::move(field)), map_(std::move(map)), iterations_(iterations), bisections_(bisections) {}

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
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return march(ray, SampledSurface(field_, ray), segment, false, sink);
    }

    // The SIMD version, with the same results: sets hits for the rays first to last - 1.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        for (const std::size_t i : coneMarchSimd({field_, *map_, iterations_, bisections_}, rays, first, last, hits)) {
            hits.set(i, trace(rays[i], sink));
        }
    }
    // The SIMD version of traceSegment() for blocks. Returns the indices of rays that traceSegment() has to trace.
    std::vector<std::size_t> traceSegmentsSimd(const RayBlock& rays, const std::vector<Segment>& segments,
                                               HitBlock& hits) const {
        if (!hasSimdMap()) return allRays(0, rays.size());
        return coneMarchSimd({field_, *map_, iterations_, bisections_}, rays, 0, rays.size(), hits, segments.data());
    }
    bool hasSimdMap() const { return fitsLanes(map_->slopes); }

    const HeightField& field() const { return field_; }
    const std::shared_ptr<const ConeMap>& coneMap() const { return map_; }
    std::size_t bytes() const { return map_->bytes(); }
    double stepBound(const ViewRay&) const { return segmentRecords(); }
    double segmentRecords() const { return iterations_ + bisections_ + 4.0; }

  private:
    // The slope interpolated bilinearly between texel centres, for either surface type, as a texture fetch does.
    double slopeAt(double s, double t) const {
        const double x = s - 0.5;
        const double y = t - 0.5;
        const auto i = static_cast<std::int64_t>(std::clamp(std::floor(x), -0x1p53, 0x1p53));
        const auto j = static_cast<std::int64_t>(std::clamp(std::floor(y), -0x1p53, 0x1p53));
        const double u = x - std::floor(x);
        const double v = y - std::floor(y);
        const auto at = [&](std::int64_t p, std::int64_t q) {
            return static_cast<double>(map_->slopes(addressIndex(p, map_->nx(), field_.address()),
                                                    addressIndex(q, map_->ny(), field_.address()), 0));
        };
        return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) + v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
    }

    template <class Sink>
    Hit march(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole, Sink& sink) const;
    template <class Sink>
    double bisected(const SampledSurface& surface, double above, double below, Sink& sink) const;

    HeightField field_;
    std::shared_ptr<const ConeMap> map_;
    int iterations_;
    int bisections_;
};

template <class Sink>
double ConeMarch::bisected(const SampledSurface& surface, double above, double below, Sink& sink) const {
    for (int n = 0; n < bisections_; ++n) {
        const double middle = 0.5 * (above + below);
        const double gap = surface.gapAt(middle);
        sink.read(surface.readsEach());
        (gap < 0 ? above : below) = middle;
        sink.step(
            [&] { return surface.record(Phase::Refine, Decision::Refine, above, below, gap + 1 - middle, middle); });
    }
    return below;
}

template <class Sink>
Hit ConeMarch::march(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole, Sink& sink) const {
    const double runLength = std::hypot(ray.a, ray.b);
    double lambda = segment.in;
    double before = segment.in;
    for (int n = 0; n < iterations_; ++n) {
        if (!surface.inside(lambda)) {
            if (whole)
                sink.step([&] { return surface.record(Phase::Search, Decision::Miss, before, lambda, 0, lambda); });
            return Hit::none(Outcome::Miss);
        }
        const double gap = surface.gapAt(lambda);
        sink.read(surface.readsEach());
        if (gap >= 0 || lambda >= segment.out) break;
        const auto [s, t] = surface.placeAt(lambda);
        const double kappa = slopeAt(s, t);
        sink.read(4);
        before = lambda;
        lambda = std::min(lambda - gap / (1 + kappa * runLength), segment.out);
        const double after = lambda;
        sink.step([&, s = s, t = t] {
            Step step = surface.record(Phase::Search, Decision::Advance, before, before, kappa, after);
            step.lambdaOut = after;
            step.subject = subject::Cone{s, t, gap + 1 - before, kappa, 0, 1, false, false, areRelaxed(map_->kind)};
            return step;
        });
    }
    if (lambda >= segment.out && segment.out < 1 && surface.gapAt(lambda) < 0) return Hit::none(Outcome::Miss);
    if (!surface.inside(lambda)) {
        if (whole) sink.step([&] { return surface.record(Phase::Search, Decision::Miss, before, lambda, 0, lambda); });
        return Hit::none(Outcome::Miss);
    }
    const double hit = surface.gapAt(lambda) > 0 ? bisected(surface, before, lambda, sink) : lambda;
    sink.step(
        [&] { return surface.record(Phase::Search, Decision::Hit, before, lambda, surface.heightAt(lambda), hit); });
    return Hit::at(ray, hit);
}

}  // namespace relief
