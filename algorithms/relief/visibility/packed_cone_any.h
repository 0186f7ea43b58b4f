// packed-cone-any: visibility query by the packed cones of the segment's quadrant.
//
// Frame and units: any_ray.h. Surfaces: bilinear, columns; any addressing. Guarantee: exact.
// Model: the walk of view rays (methods/packed_walk.h), which ends at the first cell that blocks. A cell is tested only
// if the segment falls below its highest point there. From where the segment leaves a cell above the apex, it is free
// up to where it meets the cone, or for ever if it rises faster than the cone. Cost: one map entry per step; rising
// segments (shadows, footprints) take a few steps. Memory: 16 bytes per cell.
#pragma once

#include "relief/methods/packed_walk.h"
#include "relief/visibility/any_leaf.h"

namespace relief {

// The target of PackedConeWalk in this query: a cell that blocks the segment. The walk's parameter is mu; in logs
// lambda stands for 1 - height.
struct BlockingCell {
    AnyRay segment;
    double above;  // mu from which on the segment is above the whole surface

    static constexpr double kMargin = 0;  // kVisibilityClearance exceeds the rounding of the leaf
    ViewRay course() const { return segment.course(); }
    double heightAt(double mu) const { return segment.heightAt(mu); }
    double rise() const { return segment.dz; }
    double end(const CellGrid& grid, const GridRay& ray) const { return std::min(above, ray.end(grid)); }
    // A segment flatter than the domain of exactness is followed twice as far as a view ray.
    double mostSteps(const GridRay& ray) const { return 2 * ray.cellBound() + 4; }
    std::optional<double> leaf(const ConeGround& ground, const GridRay& ray, AxisCell cx, AxisCell cy,
                               double out) const {
        if (!cellBlocks(ground.field, ground.grid, segment, ray, cx, cy, above)) return std::nullopt;
        return out;
    }
    Step logged(Step step) const {
        for (double* const at : {&step.lambdaIn, &step.lambdaOut, &step.lambdaAfter}) *at = 1 - heightAt(*at);
        return step;
    }
};

class PackedConeAnyHit {
  public:
    static constexpr RayClass kRays = PackedCones::kRays;
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "packed-cone-any";
        method.title = "packed cones, any hit";
        method.kind = MethodKind::AnyHit;
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help =
            "Steps to the edge of the empty cone that the map stores above each cell, one of four for the segment's "
            "quadrant.";
        method.source = "Dummer 2006; Ban et al. 2024";
        method.maps = {"packed-cones"};
        return method;
    }
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };
    static PackedConeAnyHit make(const HeightField& field, const Options&, MapCache& cache, Work& work) {
        return {field, packedCones(field, cache, work)};
    }
    PackedConeAnyHit(HeightField field, std::shared_ptr<const PackedCones> map)
        : field_(std::move(field)), map_(std::move(map)), grid_(field_) {}

    template <class Sink>
    Visibility query(const AnyRay& ray, Sink& sink) const;
    // SIMD version (packed_cone_any_lanes-inl.h) of query() for the segments first to last - 1, with the same results.
    void querySimd(const AnyRayBlock& rays, std::size_t first, std::size_t last, VisibilityBlock& results) const;

    const HeightField& field() const { return field_; }
    const CellGrid& grid() const { return grid_; }
    const PackedCones& map() const { return *map_; }
    double stepBound(const AnyRay& ray) const { return 2 * GridRay(grid_, ray.course()).cellBound() + 6; }

  private:
    HeightField field_;
    std::shared_ptr<const PackedCones> map_;
    CellGrid grid_;
};

template <class Sink>
Visibility PackedConeAnyHit::query(const AnyRay& ray, Sink& sink) const {
    if (!ray.finite()) return Visibility::Clear;
    const ConeGround ground{field_, grid_, *map_};
    const double end = endBelow(ray, map_->highest);
    PackedConeWalk<BlockingCell> walk(ground, {ray, end}, 0, 0, std::numeric_limits<double>::infinity());
    const auto note = [&](Decision decision, double mu) {
        const double lambda = 1 - ray.heightAt(mu);
        sink.step([&] { return cellRecord(field_, grid_, walk.x(), walk.y(), decision, lambda, lambda, 0, lambda); });
    };
    note(Decision::Start, 0);
    if (!(end > 0) || runsOutside(grid_, walk.ray())) {
        note(Decision::Miss, 0);
        return Visibility::Clear;
    }
    while (walk.step(ground, sink)) {
    }
    if (walk.outcome() == Outcome::Hit) return Visibility::Blocked;
    const bool clear = walk.outcome() == Outcome::Miss;
    note(clear ? Decision::Miss : Decision::Limit, std::min(walk.lambda(), end));
    return clear ? Visibility::Clear : Visibility::Limit;
}

}  // namespace relief
