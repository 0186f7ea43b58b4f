// SIMD version of DistanceWalk::trace in double, one ray per lane: the same steps with the same bits. Compiled for each
// target.

#if defined(RELIEF_DISTANCE_WALK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_DISTANCE_WALK_LANES_INL_H
#undef RELIEF_DISTANCE_WALK_LANES_INL_H
#else
#define RELIEF_DISTANCE_WALK_LANES_INL_H
#endif

#include "relief/methods/distance_walk.h"
#include "relief/simd/cell_lanes-inl.h"
#include "relief/simd/stored_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// A vector of rays in flight.
template <class Visits>
class VoxelWalk : public CellWalk<VoxelWalk<Visits>, DistanceWalk> {
  public:
    explicit VoxelWalk(RayQueue<DistanceWalk>& queue)
        : Cells(queue, queue.search.field(), queue.search.grid()),
          walk_(queue.search),
          map_(*walk_.distanceMap()),
          values_(map_.values) {}

    bool take(std::size_t lane, const ViewRay& ray, std::size_t number);
    void step();

  private:
    using Cells = CellWalk<VoxelWalk, DistanceWalk>;
    using Cells::active_;
    using Cells::grid_;
    using Cells::lambda_;
    using Cells::queue_;
    using Cells::ray_;
    using Cells::x_;
    using Cells::y_;
    using Axis = WalkAxisLanes;
    // A voxel's index along one axis, and its cells [low, high).
    struct Side {
        V number, low, high;
    };
    HWY_INLINE Side sideOf(const Axis& axis, const GridAxis& grid) const {
        const V f = constant(map_.parameters.footprint);
        const V number =
            hn::Floor(hn::Mul(hn::Add(axis.index(), constant(0.5)), constant(1.0 / map_.parameters.footprint)));
        const V low = hn::Mul(number, f);
        return {number, low, hn::Min(hn::Add(low, f), constant(grid.cells))};
    }
    HWY_INLINE V layerAt(V lambda) const;
    HWY_INLINE V floorOf(V layer) const { return hn::Sub(constant(1), hn::Div(layer, constant(map_.layers()))); }
    HWY_INLINE V distanceOf(V bx, V by, V layer) const;

    const DistanceWalk& walk_;
    const DistanceMap& map_;
    StoredLanes values_;
    Row<double> metric_{}, plane_{}, served_{};
};

template <class Visits>
bool VoxelWalk<Visits>::take(std::size_t lane, const ViewRay& viewRay, std::size_t number) {
    const GridRay ray(grid_, viewRay);
    // In a slab of no thickness a vertical ray has no length.
    if (!ray.inDomain() || !(walk_.perLambda(ray) > 0)) {
        queue_.fallback.push_back(number);
        return false;
    }
    if (!this->begin(lane, number, ray, walk_.records(ray))) return false;
    metric_[lane] = walk_.perLambda(ray);
    plane_[lane] = azimuthSector(ray.x.run, ray.y.run, map_.parameters.sectors) * map_.layers();
    served_[lane] = walk_.serves(ray) ? 1 : 0;
    return true;
}

// DistanceWalk::voxelAt.
template <class Visits>
V VoxelWalk<Visits>::layerAt(V lambda) const {
    const V zero = hn::Zero(D()), one = constant(1), layers = constant(map_.layers());
    const V guess = hn::Sub(hn::Ceil(hn::Mul(hn::Sub(one, lambda), layers)), one);
    const V layer = hn::Min(hn::Max(guess, zero), constant(map_.layers() - 1.0));
    const M lower = hn::And(hn::Gt(layer, zero), hn::Le(floorOf(layer), lambda));
    return hn::Sub(layer, hn::IfThenElseZero(lower, one));
}

// The stored distance, or kSurface for rays that the map does not serve.
template <class Visits>
V VoxelWalk<Visits>::distanceOf(V bx, V by, V layer) const {
    const V plane = hn::Add(load(plane_), layer);
    const V row = hn::Add(hn::Mul(plane, constant(map_.ny())), by);
    const V number = hn::Add(hn::Mul(row, constant(map_.nx())), bx);
    const V stored = values_.at(number);
    const M served = hn::Gt(load(served_), hn::Zero(D()));
    return hn::IfThenElse(served, stored, constant(static_cast<double>(StoredValues::kSurface)));
}

template <class Visits>
void VoxelWalk<Visits>::step() {
    const V zero = hn::Zero(D()), lambda = load(lambda_);
    const Axis x(grid_.x, x_, lambda), y(grid_.y, y_, lambda);
    const Side sideX = sideOf(x, grid_.x), sideY = sideOf(y, grid_.y);
    const V layer = layerAt(lambda);
    const V distance = distanceOf(sideX.number, sideY.number, layer);
    const bool classic = walk_.rule() == StepRule::Classic;
    const M solid = hn::Lt(distance, constant(classic ? DistanceWalk::kShortestClassic : 0));
    V out = lambda;
    if (!classic) {
        const V sides = hn::Min(x.leaveCells(sideX.low, sideX.high), y.leaveCells(sideY.low, sideY.high));
        out = hn::Max(hn::Min(sides, floorOf(layer)), lambda);
    }
    const V further = hn::Sub(hn::Div(distance, load(metric_)), constant(kExclusionMargin));
    const std::uint32_t walking = active_;
    const V after = this->moveOn(x, y, lambda, solid, hn::Add(out, hn::Max(zero, further)));
    if constexpr (Visits::kRecords) {
        Visits::visit(ray_, walking, sideX.number, sideY.number, layer, distance, lambda, after);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
