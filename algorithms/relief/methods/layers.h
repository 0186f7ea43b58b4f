// layers, layers-secant, layers-bisection: the slab is divided into N equal layers. The walk finds the first layer at
// which the ray is at or below the surface; a secant or bisection between it and the layer above may refine the hit.
// McGuire 2005 and [DIST17] fig. 2 (layers), Tatarchuk 2006 (secant), Policarpo 2005 (bisection).
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: the surface is sampled only at lambda_n = n / N, n = 0 .. N.
// Guarantee: none. The hit lies behind a crossing, by at most one layer, but a feature thinner than the ray's run in
// one layer, (|a| + |b|) / N texels, can be missed altogether. Failure mode: thin features.
// Cost: one height per layer and per bisection.
#pragma once

#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/methods/layer_lanes.h"
#include "relief/sampled_surface.h"

namespace relief {

template <LayerRefinement kRefinement>
class LayersTracerOf {
  public:
    struct Options {
        int layers = 64;
        int bisections = 8;

        static std::vector<OptionField<Options>> fields() {
            std::vector<OptionField<Options>> all{
                {{"layers", OptionKind::Integer, "layers", 1, 65536, 1, {}, "number of layers in the slab"},
                 &Options::layers}};
            if (kRefinement == LayerRefinement::Bisection) {
                all.push_back({{"bisections",
                                OptionKind::Integer,
                                "halvings",
                                1,
                                60,
                                1,
                                {},
                                "number of bisections of the last layer"},
                               &Options::bisections});
            }
            return all;
        }
    };

    static MethodDescription describe() {
        MethodDescription method;
        method.guarantee = Guarantee::Approximate;
        method.tiled = true;
        switch (kRefinement) {
            case LayerRefinement::None:
                method.name = "layers";
                method.title = "layers";
                method.help = "Layers of equal depth; the answer is the first one below the surface.";
                method.source = "McGuire 2005; [DIST17] fig. 2";
                break;
            case LayerRefinement::Secant:
                method.name = "layers-secant";
                method.title = "layers, secant";
                method.help = "Layers of equal depth, then a straight line between the last two.";
                method.source = "Tatarchuk 2006";
                break;
            case LayerRefinement::Bisection:
                method.name = "layers-bisection";
                method.title = "layers, bisection";
                method.help = "Layers of equal depth, then bisection of the last one.";
                method.source = "Policarpo 2005";
                break;
        }
        return method;
    }
    static LayersTracerOf make(const HeightField& field, const Options& options, MapCache&, Work&) {
        return {field, options};
    }

    LayersTracerOf(HeightField field, Options options) : field_(std::move(field)), options_(options) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        const SampledSurface surface(field_, ray);
        sink.step([&] { return surface.record(Phase::Start, Decision::Start, 0, 0, 1, 0); });
        return search(ray, surface, {}, true, sink);
    }
    // The SIMD version, with the same results: sets hits for the rays first to last - 1.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        const LayerSearch inLanes{field_, options_.layers, kRefinement, options_.bisections};
        for (const std::size_t i : layersSimd(inLanes, rays, first, last, hits)) hits.set(i, trace(rays[i], sink));
    }
    // Uses the same distance between layers, counted from the begin of the segment; also samples its end.
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return search(ray, SampledSurface(field_, ray), segment, false, sink);
    }
    double segmentRecords() const { return 3.0 + options_.bisections; }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return 0; }
    double stepBound(const ViewRay&) const { return options_.layers + options_.bisections + 4.0; }

  private:
    struct Bracket {
        double above, gapAbove;  // lambda of the last layer above the surface, and surface minus ray there (negative)
        double below, gapBelow;  // lambda of the first layer at or below the surface, and surface minus ray there
    };
    template <class Sink>
    Hit search(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole, Sink& sink) const;
    template <class Sink>
    double refined(const SampledSurface& surface, Bracket bracket, Sink& sink) const;

    HeightField field_;
    Options options_;
};

using LayersTracer = LayersTracerOf<LayerRefinement::None>;
using LayersSecantTracer = LayersTracerOf<LayerRefinement::Secant>;
using LayersBisectionTracer = LayersTracerOf<LayerRefinement::Bisection>;

template <LayerRefinement kRefinement>
template <class Sink>
double LayersTracerOf<kRefinement>::refined(const SampledSurface& surface, Bracket bracket, Sink& sink) const {
    if constexpr (kRefinement == LayerRefinement::Secant) {
        const double share = bracket.gapAbove / (bracket.gapAbove - bracket.gapBelow);
        const double lambda = bracket.above + share * (bracket.below - bracket.above);
        sink.step([&] {
            return surface.record(Phase::Refine, Decision::Refine, bracket.above, bracket.below,
                                  bracket.gapBelow + 1 - bracket.below, lambda);
        });
        return lambda;
    }
    if constexpr (kRefinement == LayerRefinement::Bisection) {
        for (int n = 0; n < options_.bisections; ++n) {
            const double middle = 0.5 * (bracket.above + bracket.below);
            const double gap = surface.gapAt(middle);
            sink.read(surface.readsEach());
            (gap < 0 ? bracket.above : bracket.below) = middle;
            sink.step([&] {
                return surface.record(Phase::Refine, Decision::Refine, bracket.above, bracket.below, gap + 1 - middle,
                                      middle);
            });
        }
    }
    return bracket.below;
}

template <LayerRefinement kRefinement>
template <class Sink>
Hit LayersTracerOf<kRefinement>::search(const ViewRay& ray, const SampledSurface& surface, Segment segment, bool whole,
                                        Sink& sink) const {
    double above = segment.in;
    double gapAbove = 0;
    for (int n = 0; n <= options_.layers; ++n) {
        const double lambda = std::min(segment.in + static_cast<double>(n) / options_.layers, segment.out);
        const auto record = [&](Decision decision, double height, double after) {
            Step step = surface.record(Phase::Search, decision, above, lambda, height, after);
            // Within a segment, layers are counted from its begin and are not layers of the slab.
            if (whole && decision != Decision::Miss) step.subject = subject::Layer{n, options_.layers, height};
            return step;
        };
        if (!surface.inside(lambda)) {
            if (whole) sink.step([&] { return record(Decision::Miss, 0, lambda); });
            return Hit::none(Outcome::Miss);
        }
        const double gap = surface.gapAt(lambda);
        sink.read(surface.readsEach());
        // At the bottom of the slab the surface cannot be below the ray, even if rounding says so.
        if (gap >= 0 || lambda >= 1) {
            const double hit = n == 0 ? lambda : refined(surface, {above, gapAbove, lambda, std::max(gap, 0.0)}, sink);
            sink.step([&] { return record(Decision::Hit, gap + 1 - lambda, hit); });
            return Hit::at(ray, hit);
        }
        sink.step([&] { return record(Decision::Advance, gap + 1 - lambda, lambda); });
        above = lambda;
        gapAbove = gap;
        if (lambda >= segment.out) break;
    }
    return Hit::none(Outcome::Miss);
}

}  // namespace relief
