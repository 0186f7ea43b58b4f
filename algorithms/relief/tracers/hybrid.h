// hybrid: one middle level of the max pyramid marks the segments of the ray that are worth testing; another method
// traces within them. [MIP18], last paragraph.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing; any ray that descends.
// Model: the ray is advanced to the highest point, then walks the texels of that one level. A texel whose maximum is
// below the ray over its whole interval is skipped. In the others the inner method starts at the point of entry, which
// it tests, and continues to the exit.
// Guarantee: that of the inner method (the paper means methods with a guaranteed-free step: distances, cones). Failure
// mode: that of the inner method, within segments. Cost: one maximum per texel, and that of the inner method. It mostly
// takes more steps than the inner method alone, whose own steps skip as far and are cut at the segments' borders
// (tests/benchmarks/RESULTS.md).
#pragma once

#include "relief/methods/pyramid_walk.h"
#include "relief/tracers.h"
#include "relief/tracers/segment_blocks.h"

namespace relief {

class HybridTracer {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "hybrid";
        method.title = "hybrid";
        method.guarantee = Guarantee::Approximate;
        method.help =
            "One level of the max pyramid marks the segments worth testing; the inner method searches them, and its "
            "guarantee holds. This mostly takes more steps than the inner method alone: compare the two.";
        method.source = "[MIP18]";
        method.maps = {"max-pyramid"};
        return method;
    }
    struct Options {
        int level = 3;
        std::string inner = "distance-conservative";
        OptionValues innerOptions;  // given as inner.NAME

        static std::vector<OptionField<Options>> fields() {
            return {{{"level",
                      OptionKind::Integer,
                      "level",
                      0,
                      kMaxLevels - 1,
                      1,
                      {},
                      "middle level (the top level if there are fewer)"},
                     &Options::level},
                    {{"inner", OptionKind::Method, "", 0, 0, 0, innerTracerNames(),
                      "method that searches the segments; its own options are given as inner.NAME"},
                     &Options::inner}};
        }
    };
    static HybridTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {PyramidWalk(field, maxPyramidMap(field, cache, work)), options.level,
                makeSegmentTracer({options.inner, options.innerOptions}, field, cache, work)};
    }

    static bool simdWith(const Options& options) { return segmentsInSimd({options.inner, options.innerOptions}); }
    static std::string formNote() {
        return "In SIMD with the inner methods distance-conservative, distance-refined, cone-dummer, cone-robust, "
               "relaxed-cone, relaxed-cone-robust and cone:layout=texel; with others, whose SIMD versions begin at the "
               "top plane, the reference runs.";
    }

    HybridTracer(PyramidWalk walk, int level, std::shared_ptr<const SegmentBlockTracer> inner)
        : walk_(std::move(walk)), level_(std::min(level, walk_.top())), inner_(std::move(inner)) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const;

    // The SIMD version, with the same results: sets hits for the rays first to last - 1. Each ray walks through the
    // texels of the level as in the reference; the segments at which rays arrive are searched together, in SIMD.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const;

    const HeightField& field() const { return walk_.field(); }
    std::size_t bytes() const { return walk_.bytes() + inner_->bytes(); }
    // A descent, an ascent or a skip per texel; the inner method's steps for the whole ray, and its additional ones for
    // each segment.
    double stepBound(const ViewRay& ray) const {
        const double texels = walk_.gridRay(ray).cellBound();
        return 4 + texels * (2 + inner_->segmentRecords()) + inner_->stepBound(ray);
    }
    Guarantee guarantee() const { return inner_->guarantee(); }
    const PyramidWalk& pyramidWalk() const { return walk_; }

  private:
    // A ray in a texel of the level.
    struct Place {
        GridRay ray;
        PyramidNode node{};
        double lambda = 0;         // where it enters the texel
        double left = 0;           // the cells that it may still cross
        PyramidWalk::Exit exit{};  // of the texel
        double out = 0;            // lambda at the exit, at most 1
    };
    // Sets the place at which the walk begins. Returns the hit if it is known there, and Outcome::Unset otherwise.
    template <class Sink>
    Hit begin(const ViewRay& viewRay, Place& place, Sink& sink) const;
    // Skips texels below the ray. Returns Outcome::Unset in a texel that the inner method must search.
    template <class Sink>
    Outcome skip(Place& place, Sink& sink) const;
    // Moves to the next texel. Returns false if the ray ends there.
    template <class Sink>
    bool leave(Place& place, Sink& sink) const;
    template <class Sink>
    void note(const Place& place, Decision decision, double in, double after, Sink& sink) const {
        sink.step([&] {
            const float maximum = walk_.maximum(level_, place.node);
            return walk_.record(decision, level_, place.node, in, place.out, maximum, after);
        });
    }

    // How much a texel that the inner method traces subtracts from the ray's cellBound(). Within the domain of
    // exactness 1; beyond it, where the bound limits the work, as many cells as a line can cross in the texel, since
    // the inner method's work counts as well.
    double segmentCost(const GridRay& ray) const {
        if (ray.inDomain()) return 1;
        const double side = std::ldexp(1.0, level_);
        return std::min<double>(side, walk_.grid().x.cells) + std::min<double>(side, walk_.grid().y.cells);
    }

    PyramidWalk walk_;
    int level_;
    std::shared_ptr<const SegmentBlockTracer> inner_;
};

template <class Sink>
Hit HybridTracer::begin(const ViewRay& viewRay, Place& place, Sink& sink) const {
    const PyramidStart start = pyramidStart(walk_, place.ray, sink);
    if (start.outcome != Outcome::Unset) return Hit::none(start.outcome);
    if (start.hit) return Hit::at(viewRay, *start.hit);
    place.node = start.node;
    place.lambda = start.lambda;
    for (int level = walk_.top(); level > level_; --level) {
        place.node = walk_.child(place.ray, level, place.node, place.lambda);
    }
    place.left = place.ray.cellBound();
    return Hit::none(Outcome::Unset);
}

template <class Sink>
Outcome HybridTracer::skip(Place& place, Sink& sink) const {
    while (place.left > 0) {
        const float maximum = walk_.maximum(level_, place.node);
        place.exit = walk_.exit(place.ray, level_, place.node);
        place.out = std::min(place.exit.first(), 1.0);
        sink.read(1);
        if (!PyramidWalk::excluded(maximum, place.out)) {
            note(place, Decision::Descend, place.lambda, place.lambda, sink);
            return Outcome::Unset;
        }
        note(place, Decision::Skip, place.lambda, place.out, sink);
        --place.left;
        if (!leave(place, sink)) return Outcome::Miss;
    }
    const double at = place.lambda;
    sink.step([&] { return walk_.record(Decision::Limit, level_, place.node, at, at, 0, at); });
    return Outcome::Limit;
}

template <class Sink>
bool HybridTracer::leave(Place& place, Sink& sink) const {
    place.lambda = place.out;
    const PyramidNode before = place.node;
    if (walk_.moveOn(place.ray, level_, place.exit, place.node) && place.exit.first() < 1) return true;
    place.node = before;
    note(place, Decision::Miss, place.out, place.out, sink);
    return false;
}

template <class Sink>
Hit HybridTracer::trace(const ViewRay& viewRay, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    Place place{walk_.gridRay(viewRay)};
    if (const Hit known = begin(viewRay, place, sink); known.outcome != Outcome::Unset) return known;
    const double cost = segmentCost(place.ray);
    for (;;) {
        if (const Outcome end = skip(place, sink); end != Outcome::Unset) return Hit::none(end);
        const Hit hit = inner_->traceSegment(viewRay, {place.lambda, place.out}, sink);
        if (hit.outcome != Outcome::Miss) return hit;
        note(place, Decision::Ascend, place.out, place.out, sink);
        place.left -= cost;
        if (!leave(place, sink)) return Hit::none(Outcome::Miss);
    }
}

inline void HybridTracer::traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
    struct Walker {
        std::size_t ray;
        Place place;
    };
    NullSink sink;
    std::vector<Walker> walkers;
    for (std::size_t i = first; i < last; ++i) {
        const ViewRay ray = rays[i];
        Hit known = Hit::none(Outcome::Miss);
        if (ray.finite()) {
            walkers.push_back({i, {walk_.gridRay(ray)}});
            known = begin(ray, walkers.back().place, sink);
            if (known.outcome == Outcome::Unset) continue;
            walkers.pop_back();
        }
        hits.set(i, known);
    }
    RayBlock block;
    std::vector<Segment> segments;
    HitBlock found;
    while (!walkers.empty()) {
        std::erase_if(walkers, [&](Walker& walker) {
            const Outcome end = skip(walker.place, sink);
            if (end != Outcome::Unset) hits.set(walker.ray, Hit::none(end));
            return end != Outcome::Unset;
        });
        block.resize(walkers.size());
        segments.resize(walkers.size());
        for (std::size_t k = 0; k < walkers.size(); ++k) {
            block.set(k, rays[walkers[k].ray]);
            segments[k] = {walkers[k].place.lambda, walkers[k].place.out};
        }
        inner_->traceSegments(block, segments, found);
        std::size_t next = 0;
        std::erase_if(walkers, [&](Walker& walker) {
            const Hit hit = found[next++];
            if (hit.outcome == Outcome::Miss) {
                walker.place.left -= segmentCost(walker.place.ray);
                if (leave(walker.place, sink)) return false;
            }
            hits.set(walker.ray, hit);
            return true;
        });
    }
}

}  // namespace relief
