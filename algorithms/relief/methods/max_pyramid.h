// max-pyramid: hierarchical skips on the pyramid of maxima, iterative and stackless. [MIP18]; Tevs 2008.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing; any ray that descends.
// Model: the walk begins at the height of the highest point, on the level whose nodes are a quarter to half as long as
// the ray's run along its longer axis, or on the nearest existing level. A node whose maximum is below the ray over the
// ray's whole interval in it is skipped; otherwise its children are visited. On level 0 the leaf decides. After a step
// that leaves the parent, the walk goes up one level.
//
// Walk: depth_walk.h, in float over 16-bit depths; SIMD, for base level 0: simd/pyramid_lanes-inl.h. Fallback, where
// float cannot decide: the paper's walk in double (max_pyramid_paper.h).
//
// Guarantee: with base level 0 exact, the same bits as `exact` and `max-pyramid-paper`. Failure mode: needle forests at
// grazing angles, where little can be skipped. Cost: O(log) steps per ray on smooth surfaces, one stored maximum per
// step.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "relief/describe.h"
#include "relief/methods/depth_walk.h"
#include "relief/methods/max_pyramid_paper.h"
#include "relief/methods/pyramid_rays.h"
#include "relief/methods/steps_within.h"

namespace relief {

class MaxPyramidTracer {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "max-pyramid";
        method.title = "max pyramid";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::ViewRays;
        method.help = "Skips areas below the ray with a pyramid of maxima; iterative, without a stack.";
        method.source = "[MIP18]; Tevs 2008";
        method.maps = {"max-pyramid"};
        method.tiled = true;
        return method;
    }
    struct Options {
        std::string base = "0";

        static std::vector<OptionField<Options>> fields() { return {baseLevelField(&Options::base)}; }
    };
    // An automatic base level counts as one above 0, for which there is no SIMD version.
    static bool simdWith(const Options& options) { return options.base == "0"; }
    static MaxPyramidTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        const BaseField base = baseField(field, baseLevelNumber(options.base), cache, work);
        PyramidWalk walk(base, field, maxPyramidMap(base.field, cache, work));
        auto depths = depthPyramid(base.field, walk.map(), cache, work);
        return {std::move(walk), std::move(depths)};
    }

    // depths: those of the walk's map.
    MaxPyramidTracer(PyramidWalk walk, std::shared_ptr<const DepthPyramid> depths)
        : paper_(std::move(walk)), depths_(std::move(depths)), walk_(pyramidWalk(), *depths_) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const {
        if (!viewRay.finite()) return Hit::none(Outcome::Miss);
        return trace(viewRay, sink, sink);
    }
    // Requires a finite ray. inDouble: receives the steps of the fallback in double.
    template <class Sink, class DoubleSink>
    Hit trace(const ViewRay& viewRay, Sink& sink, DoubleSink& inDouble) const;
    // The SIMD version, with the same results: sets hits for the rays [first, last) of the block.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        if (!hasSimdMap()) {
            for (std::size_t i = first; i < last; ++i) hits.set(i, trace(rays[i], sink));
            return;
        }
        std::vector<std::size_t> left;
        traceByPyramid(walk_.scene(), *depths_, rays, first, last, hits, left);
        for (const std::size_t i : left) hits.set(i, trace(rays[i], sink));
    }

    const HeightField& field() const { return paper_.field(); }
    bool hasSimdMap() const { return pyramidWalk().baseLevel() == 0; }
    std::size_t bytes() const { return paper_.bytes() + depths_->bytes(); }
    // The walk in double starts anew, slightly before the place where float stops.
    double stepBound(const ViewRay& ray) const { return 2 * paper_.stepBound(ray); }
    Guarantee guarantee() const { return paper_.guarantee(); }
    const PyramidWalk& pyramidWalk() const { return paper_.pyramidWalk(); }

  private:
    MaxPyramidPaperTracer paper_;
    std::shared_ptr<const DepthPyramid> depths_;
    DepthWalk walk_;
};

template <class Sink, class DoubleSink>
Hit MaxPyramidTracer::trace(const ViewRay& viewRay, Sink& sink, DoubleSink& inDouble) const {
    const GridRay ray = pyramidWalk().gridRay(viewRay);
    const DepthWalk::Answer answer = walk_.trace(pyramidWalk(), ray, sink);
    switch (answer.end) {
        case DepthWalk::End::Hit:
            return Hit::at(viewRay, answer.lambda);
        case DepthWalk::End::Miss:
            return Hit::none(Outcome::Miss);
        case DepthWalk::End::Unfit:
            return paper_.trace(viewRay, inDouble);
        case DepthWalk::End::Fallback:
            break;
    }
    StepsWithin<DoubleSink> rest{inDouble, answer.lambda, 1};
    return paper_.resume(viewRay, ray, answer.from, pyramidWalk().topNode(ray, answer.from), rest);
}

}  // namespace relief
