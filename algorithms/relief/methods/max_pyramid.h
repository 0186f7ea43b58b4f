// max-pyramid: hierarchical skip on the pyramid of maxima, iterative and stackless. [MIP18]; Tevs 2008.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing; any ray that descends.
// Model: a node whose maximum is below the ray all along its stay is skipped; otherwise its children are asked; the one
// leaf decides at level 0. After a step that leaves the parent, the walk goes up one level.
// Guarantee: with base level 0 exact, the same bits as `exact` and `max-pyramid-paper`. Failure mode: needle forests at
// grazing angles, where little can be skipped. Cost: O(log) steps a ray on even surfaces, one stored maximum a step.
// Other forms: max_pyramid_paper.h follows the paper word by word; pyramid_rays.h, SIMD, traces blocks without a
// log.
#pragma once

#include "relief/describe.h"
#include "relief/methods/pyramid_rays.h"
#include "relief/methods/pyramid_walk.h"

namespace relief {

class MaxPyramidTracer {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "max-pyramid";
        method.title = "max pyramid";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::ViewRays;
        method.help = "Skips what lies below the ray by the pyramid of maxima; iterative, stackless.";
        method.source = "[MIP18]; Tevs 2008";
        method.maps = {"max-pyramid"};
        return method;
    }
    struct Options {
        std::string base = "0";

        static std::vector<OptionField<Options>> fields() { return {baseLevelField(&Options::base)}; }
    };
    // An automatic base level counts as one above 0.
    static bool simdWith(const Options& options) { return options.base == "0"; }
    static MaxPyramidTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work,
                                 Form form = Form::Simd) {
        const BaseField base = baseField(field, baseLevelNumber(options.base), cache, work);
        MaxPyramidTracer tracer(PyramidWalk(base, field, maxPyramidMap(base.field, cache, work)));
        if (base.level == 0 && form == Form::Simd)
            tracer.useLanes(depthPyramid(field, tracer.walk_.map(), cache, work));
        return tracer;
    }

    explicit MaxPyramidTracer(PyramidWalk walk) : walk_(std::move(walk)) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const;
    // The same hits, many at a time; rays [first, last) of the block.
    void traceLanes(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        if (!depths_) {
            for (std::size_t i = first; i < last; ++i) hits.set(i, trace(rays[i], sink));
            return;
        }
        std::vector<std::size_t> left;
        traceByPyramid(scene_, *depths_, rays, first, last, hits, left);
        for (const std::size_t i : left) hits.set(i, trace(rays[i], sink));
    }

    const HeightField& field() const { return walk_.wholeField(); }
    bool hasSimdMap() const { return depths_ != nullptr; }
    std::size_t bytes() const { return walk_.bytes() + (depths_ ? depths_->bytes() : 0); }
    double stepBound(const ViewRay& ray) const { return walk_.stepBound(walk_.gridRay(ray)); }
    // A base level above 0 is another surface.
    Guarantee guarantee() const { return walk_.baseLevel() == 0 ? Guarantee::Exact : Guarantee::Approximate; }
    const PyramidWalk& pyramidWalk() const { return walk_; }

  private:
    void useLanes(std::shared_ptr<const DepthPyramid> depths) {
        depths_ = std::move(depths);
        if (depths_) scene_ = FloatScene(field(), depths_->highest, 1 << depths_->top);
    }

    PyramidWalk walk_;
    std::shared_ptr<const DepthPyramid> depths_;
    FloatScene scene_;
};

template <class Sink>
Hit MaxPyramidTracer::trace(const ViewRay& viewRay, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const GridRay ray = walk_.gridRay(viewRay);
    const PyramidStart start = pyramidStart(walk_, ray, sink);
    if (start.outcome != Outcome::Unset) return Hit::none(start.outcome);
    if (start.hit) return Hit::at(viewRay, *start.hit);

    const int top = walk_.top();
    int level = top;
    PyramidNode node = start.node;
    double lambda = start.lambda;
    for (double left = walk_.nodeBound(ray); left > 0; --left) {
        const float maximum = walk_.maximum(level, node);
        const PyramidWalk::Exit exit = walk_.exit(ray, level, node);
        const double out = std::min(exit.first(), 1.0);
        sink.read(1);
        const bool skip = PyramidWalk::excluded(maximum, out);
        if (!skip && level > 0) {
            sink.step([&] { return walk_.descent(ray, level, node, lambda, out, maximum); });
            node = walk_.child(ray, level, node, lambda);
            --level;
            continue;
        }
        if (!skip) {
            sink.read(walk_.leafReads());
            if (const auto hit = walk_.leaf(ray, node)) {
                sink.step([&] { return walk_.record(Decision::Hit, 0, node, lambda, out, maximum, *hit); });
                return Hit::at(viewRay, *hit);
            }
        }
        sink.step([&] {
            return walk_.record(skip ? Decision::Skip : Decision::Test, level, node, lambda, out, maximum, out);
        });
        const PyramidNode before = node;
        const bool inside = walk_.moveOn(ray, level, exit, node) && exit.first() < 1;
        lambda = out;
        if (!inside) {
            sink.step([&] { return walk_.record(Decision::Miss, level, before, lambda, lambda, maximum, lambda); });
            return Hit::none(Outcome::Miss);
        }
        if (level < top && !PyramidWalk::sameParent(before, node)) {
            PyramidWalk::toParent(node);
            ++level;
            sink.step([&] { return walk_.ascent(level, before, lambda); });
        }
    }
    sink.step([&] { return walk_.record(Decision::Limit, level, node, lambda, lambda, 0, lambda); });
    return Hit::none(Outcome::Limit);
}

}  // namespace relief
