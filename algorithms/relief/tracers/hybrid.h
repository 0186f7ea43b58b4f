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

namespace relief {

class HybridTracer {
  public:
    static std::string formNote() {
        return "It starts the inner method anew in every segment, ray by ray; the inner method alone is mostly faster.";
    }
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
                makeTracer({options.inner, options.innerOptions}, field, cache, work, Form::Scalar)};
    }

    HybridTracer(PyramidWalk walk, int level, std::shared_ptr<const Tracer> inner)
        : walk_(std::move(walk)), level_(std::min(level, walk_.top())), inner_(std::move(inner)) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const;

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
    std::shared_ptr<const Tracer> inner_;
};

template <class Sink>
Hit HybridTracer::trace(const ViewRay& viewRay, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const GridRay ray = walk_.gridRay(viewRay);
    const PyramidStart start = pyramidStart(walk_, ray, sink);
    if (start.outcome != Outcome::Unset) return Hit::none(start.outcome);
    if (start.hit) return Hit::at(viewRay, *start.hit);

    PyramidNode node = start.node;
    double lambda = start.lambda;
    for (int level = walk_.top(); level > level_; --level) node = walk_.child(ray, level, node, lambda);
    const double cost = segmentCost(ray);
    double left = ray.cellBound();
    while (left > 0) {
        const float maximum = walk_.maximum(level_, node);
        const PyramidWalk::Exit exit = walk_.exit(ray, level_, node);
        const double out = std::min(exit.first(), 1.0);
        sink.read(1);
        const auto record = [&](Decision decision, double in, double after) {
            return walk_.record(decision, level_, node, in, out, maximum, after);
        };
        if (PyramidWalk::excluded(maximum, out)) {
            sink.step([&] { return record(Decision::Skip, lambda, out); });
            --left;
        } else {
            sink.step([&] { return record(Decision::Descend, lambda, lambda); });
            const Hit hit = inner_->traceSegment(viewRay, {lambda, out}, sink);
            if (hit.outcome != Outcome::Miss) return hit;
            sink.step([&] { return record(Decision::Ascend, out, out); });
            left -= cost;
        }
        lambda = out;
        const PyramidNode before = node;
        if (!walk_.moveOn(ray, level_, exit, node) || exit.first() >= 1) {
            node = before;
            sink.step([&] { return record(Decision::Miss, out, out); });
            return Hit::none(Outcome::Miss);
        }
    }
    sink.step([&] { return walk_.record(Decision::Limit, level_, node, lambda, lambda, 0, lambda); });
    return Hit::none(Outcome::Limit);
}

}  // namespace relief
