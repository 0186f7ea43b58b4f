// max-pyramid-any: visibility query by hierarchical skips on the max pyramid, with early exit. [MIP18] generalised to
// any direction; used for shadows and for footprints traced back.
//
// Frame and units: any_ray.h. Surfaces: bilinear, columns; any addressing; segments in any direction.
// Model: the segment is blocked if the surface is higher than it by more than kVisibilityClearance anywhere. The walk
// begins in the cell of the start, climbs when it leaves a parent, and skips a node whose maximum is not above the
// lowest point of the segment in it. The walk ends at the first cell that blocks, or where the segment is above the
// highest point.
// Guarantee: exact. Failure mode: long level segments among needles. Cost: O(log) steps on smooth surfaces.
// Log: lambda stands for 1 - z of the segment, so it decreases where the segment rises.
#pragma once

#include "relief/describe.h"
#include "relief/methods/pyramid_walk.h"
#include "relief/visibility/any_leaf.h"

namespace relief {

class MaxPyramidAnyHit {
  public:
    static constexpr RayClass kRays = MaxPyramidMap::kRays;

    static MethodDescription describe() {
        MethodDescription method;
        method.name = "max-pyramid-any";
        method.title = "max pyramid, any hit";
        method.kind = MethodKind::AnyHit;
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help = "Tests whether anything blocks a segment; the first obstacle ends the search.";
        method.source = "[MIP18]; Tevs 2008";
        method.maps = {"max-pyramid"};
        method.tiled = true;
        return method;
    }
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };
    static MaxPyramidAnyHit make(const HeightField& field, const Options&, MapCache& cache, Work& work) {
        return MaxPyramidAnyHit(field, maxPyramidMap(field, cache, work));
    }

    MaxPyramidAnyHit(HeightField field, std::shared_ptr<const MaxPyramidMap> map)
        : walk_(std::move(field), std::move(map)) {}

    template <class Sink>
    Visibility query(const AnyRay& ray, Sink& sink) const;

    const HeightField& field() const { return walk_.field(); }
    double stepBound(const AnyRay& ray) const { return walk_.stepBound(GridRay(walk_.grid(), ray.course())); }

  private:
    PyramidWalk walk_;
};

template <class Sink>
Visibility MaxPyramidAnyHit::query(const AnyRay& ray, Sink& sink) const {
    if (!ray.finite()) return Visibility::Clear;
    const GridRay course(walk_.grid(), ray.course());
    const double end = endBelow(ray, walk_.highest());
    const auto record = [&](Decision decision, int level, const PyramidNode& node, double in, double out, double value,
                            double after) {
        return walk_.record(decision, level, node, 1 - ray.heightAt(in), 1 - ray.heightAt(out), value,
                            1 - ray.heightAt(after));
    };
    PyramidNode node{course.x.startCell(walk_.grid().x), course.y.startCell(walk_.grid().y)};
    int level = 0;
    double mu = 0;
    sink.step([&] { return record(Decision::Start, level, node, 0, 0, 0, 0); });
    if (!(end > 0) || runsOutside(walk_.grid(), course)) {
        sink.step([&] { return record(Decision::Miss, level, node, 0, 0, 0, 0); });
        return Visibility::Clear;
    }
    for (double left = walk_.nodeBound(course); left > 0; --left) {
        const float maximum = walk_.maximum(level, node);
        const PyramidWalk::Exit exit = walk_.exit(course, level, node);
        const double out = std::clamp(exit.first(), mu, end);
        sink.read(1);
        const double lowest = std::min(ray.heightAt(mu), ray.heightAt(out));
        const bool skip = static_cast<double>(maximum) + kExclusionMargin < lowest + kVisibilityClearance;
        if (!skip && level > 0) {
            sink.step([&] { return record(Decision::Descend, level, node, mu, out, maximum, mu); });
            node = walk_.child(course, level, node, mu);
            --level;
            continue;
        }
        if (!skip) {
            sink.read(walk_.leafReads());
            if (cellBlocks(field(), walk_.grid(), ray, course, node.x, node.y, end)) {
                sink.step([&] { return record(Decision::Hit, 0, node, mu, out, maximum, mu); });
                return Visibility::Blocked;
            }
        }
        sink.step([&] { return record(skip ? Decision::Skip : Decision::Test, level, node, mu, out, maximum, out); });
        const PyramidNode before = node;
        const bool inside = exit.first() < end && walk_.moveOn(course, level, exit, node);
        mu = out;
        if (!inside) {
            sink.step([&] { return record(Decision::Miss, level, before, mu, mu, maximum, mu); });
            return Visibility::Clear;
        }
        if (level < walk_.top() && !PyramidWalk::sameParent(before, node)) {
            PyramidWalk::toParent(node);
            ++level;
            sink.step([&] { return walk_.ascent(level, before, 1 - ray.heightAt(mu)); });
        }
    }
    sink.step([&] { return record(Decision::Limit, level, node, mu, mu, 0, mu); });
    return Visibility::Limit;
}

}  // namespace relief
