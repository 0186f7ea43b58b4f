// max-pyramid-paper: the recursion of [MIP18]. Its step log follows the procedure of the paper step by step.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing; any ray that descends.
//   1. Highest point: the ray is advanced to its height; if the surface at the start is as high, it is the hit.
//   2. One level down: coordinates double, V(i+1) = 2 V(i); step through the texels that the ray crosses.
//   3. A texel whose maximum is strictly below the ray over its whole interval is free and skipped.
//   4. Otherwise repeat one level lower, down to the base level (option; 0: the heights themselves).
//   5. Without a confirmed hit ("the higher point is not on the ray's projection") return to the level above, continue.
//   6. The search ends when the base level confirms the hit.
// Guarantee: with base level 0 exact, the same bits as `exact`. Failure mode and cost: see max_pyramid.h, which begins
// on a lower level and descends without recursion.
// Difference: a line crosses one, two or three of four children, where the paper says at most two.
#pragma once

#include "relief/describe.h"
#include "relief/methods/pyramid_walk.h"

namespace relief {

class MaxPyramidPaperTracer {
  public:
    static std::string formNote() {
        return "It shows the recursion of the paper; max-pyramid finds the same hits in SIMD.";
    }
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "max-pyramid-paper";
        method.title = "max pyramid, the paper's recursion";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::ViewRays;
        method.help = "Skips areas below the ray with a pyramid of maxima; recursive, as in the paper.";
        method.source = "[MIP18]";
        method.maps = {"max-pyramid"};
        method.tiled = true;
        return method;
    }
    struct Options {
        std::string base = "0";

        static std::vector<OptionField<Options>> fields() { return {baseLevelField(&Options::base)}; }
    };
    static MaxPyramidPaperTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        const BaseField base = baseField(field, baseLevelNumber(options.base), cache, work);
        return MaxPyramidPaperTracer(PyramidWalk(base, field, maxPyramidMap(base.field, cache, work)));
    }

    explicit MaxPyramidPaperTracer(PyramidWalk walk) : walk_(std::move(walk)) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const;
    // Continues from lambda `from`, before which the ray does not meet the surface, on the top level.
    template <class Sink>
    Hit resume(const ViewRay& viewRay, const GridRay& ray, double from, const PyramidNode& node, Sink& sink) const;

    const HeightField& field() const { return walk_.wholeField(); }
    std::size_t bytes() const { return walk_.bytes(); }
    double stepBound(const ViewRay& ray) const { return walk_.stepBound(walk_.gridRay(ray)); }
    // A base level above 0 is a different surface.
    Guarantee guarantee() const { return walk_.baseLevel() == 0 ? Guarantee::Exact : Guarantee::Approximate; }
    const PyramidWalk& pyramidWalk() const { return walk_; }

  private:
    struct State {
        double lambda = 0;
        double left = 0;  // number of nodes until the step limit
        Outcome outcome = Outcome::Unset;
        double hit = 0;
    };

    // Steps through the texels of `level` that the ray crosses, beginning with `node`, until it leaves their parent (on
    // the top level: until the ray ends). Returns true if the outcome is known.
    template <class Sink>
    bool level(const GridRay& ray, int level, PyramidNode node, State& state, Sink& sink) const;

    PyramidWalk walk_;
};

template <class Sink>
Hit MaxPyramidPaperTracer::trace(const ViewRay& viewRay, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const GridRay ray = walk_.gridRay(viewRay);
    const PyramidStart start = pyramidStart(walk_, ray, sink);
    if (start.outcome != Outcome::Unset) return Hit::none(start.outcome);
    if (start.hit) return Hit::at(viewRay, *start.hit);
    return resume(viewRay, ray, start.lambda, start.node, sink);
}

template <class Sink>
Hit MaxPyramidPaperTracer::resume(const ViewRay& viewRay, const GridRay& ray, double from, const PyramidNode& node,
                                  Sink& sink) const {
    State state;
    state.lambda = from;
    state.left = walk_.nodeBound(ray);
    level(ray, walk_.top(), node, state, sink);
    return state.outcome == Outcome::Hit ? Hit::at(viewRay, state.hit) : Hit::none(state.outcome);
}

template <class Sink>
bool MaxPyramidPaperTracer::level(const GridRay& ray, int level, PyramidNode node, State& state, Sink& sink) const {
    for (;;) {
        if (--state.left < 0) {
            sink.step([&] {
                return walk_.record(Decision::Limit, level, node, state.lambda, state.lambda, 0, state.lambda);
            });
            state.outcome = Outcome::Limit;
            return true;
        }
        const float maximum = walk_.maximum(level, node);
        const PyramidWalk::Exit exit = walk_.exit(ray, level, node);
        const double in = state.lambda;
        const double out = std::min(exit.first(), 1.0);
        sink.read(1);
        if (PyramidWalk::excluded(maximum, out)) {  // step 3
            sink.step([&] { return walk_.record(Decision::Skip, level, node, in, out, maximum, out); });
        } else if (level > 0) {  // step 4
            sink.step([&] { return walk_.descent(ray, level, node, in, out, maximum); });
            const PyramidNode child = walk_.child(ray, level, node, in);
            if (this->level(ray, level - 1, child, state, sink)) return true;
            sink.step([&] { return walk_.record(Decision::Ascend, level, node, out, out, maximum, out); });  // step 5
        } else {
            sink.read(walk_.leafReads());
            if (const auto hit = walk_.leaf(ray, node)) {  // step 6
                sink.step([&] { return walk_.record(Decision::Hit, level, node, in, out, maximum, *hit); });
                state.outcome = Outcome::Hit;
                state.hit = *hit;
                return true;
            }
            sink.step([&] { return walk_.record(Decision::Test, level, node, in, out, maximum, out); });
        }
        state.lambda = out;
        const PyramidNode before = node;
        if (!walk_.moveOn(ray, level, exit, node) || exit.first() >= 1) {
            sink.step([&] { return walk_.record(Decision::Miss, level, before, out, out, maximum, out); });
            state.outcome = Outcome::Miss;
            return true;
        }
        if (level < walk_.top() && !PyramidWalk::sameParent(before, node)) return false;
    }
}

}  // namespace relief
