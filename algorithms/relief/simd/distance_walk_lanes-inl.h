// SIMD version of DistanceWalk::trace in double, one ray per lane: the same steps with the same bits. Compiled for each
// target.

#if defined(RELIEF_DISTANCE_WALK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_DISTANCE_WALK_LANES_INL_H
#undef RELIEF_DISTANCE_WALK_LANES_INL_H
#else
#define RELIEF_DISTANCE_WALK_LANES_INL_H
#endif

#include <cmath>
#include <limits>

#include "relief/methods/distance_walk.h"
#include "relief/simd/double_lanes-inl.h"
#include "relief/simd/exact_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// RayAxis of the rays in a vector.
struct WalkAxisRows {
    Row<double> start{}, run{}, inverse{};
    Row<double> first{};  // the cell at lambda = 0, numbered continuously across periods

    void set(std::size_t lane, const GridAxis& grid, const RayAxis& ray) {
        const AxisCell cell = ray.startCell(grid);
        start[lane] = ray.start, run[lane] = ray.run, inverse[lane] = ray.inverse;
        first[lane] = static_cast<double>(cell.base + cell.index);
    }
};

class WalkAxisLanes {
  public:
    HWY_INLINE WalkAxisLanes(const GridAxis& grid, const WalkAxisRows& from, V lambda)
        : grid_(grid), start_(load(from.start)), run_(load(from.run)), inverse_(load(from.inverse)) {
        const V zero = hn::Zero(D());
        still_ = hn::Eq(run_, zero);
        forward_ = hn::Gt(run_, zero);
        findCell(load(from.first), lambda);
    }

    HWY_INLINE V index() const { return hn::Sub(cell_, base_); }
    HWY_INLINE V enterCell() const { return enter(cell_); }
    HWY_INLINE V leaveCell() const { return leave(cell_, hn::Add(cell_, constant(1))); }
    // Lambda at which the rays leave the cells [low, high) of the period.
    HWY_INLINE V leaveCells(V low, V high) const { return leave(hn::Add(base_, low), hn::Add(base_, high)); }
    // leaf_detail::within.
    HWY_INLINE V within(V lambda) const {
        const V x = hn::Add(start_, hn::Mul(lambda, run_));
        return stdMin(stdMax(hn::Sub(x, cell_), hn::Zero(D())), constant(1));
    }

  private:
    // GridAxis::edge for cells numbered continuously across periods.
    HWY_INLINE V edge(V k) const {
        if (grid_.wraps) return k;
        const V inner = hn::IfThenElse(hn::Le(k, hn::Zero(D())), constant(grid_.low), k);
        return hn::IfThenElse(hn::Ge(k, constant(grid_.cells)), constant(grid_.high), inner);
    }
    HWY_INLINE V enter(V cell) const {
        const V at = edge(hn::IfThenElse(forward_, cell, hn::Add(cell, constant(1))));
        return hn::IfThenElse(still_, constant(-std::numeric_limits<double>::infinity()),
                              hn::Mul(hn::Sub(at, start_), inverse_));
    }
    HWY_INLINE V leave(V low, V high) const {
        const V at = edge(hn::IfThenElse(forward_, high, low));
        return hn::IfThenElse(still_, constant(std::numeric_limits<double>::infinity()),
                              hn::Mul(hn::Sub(at, start_), inverse_));
    }

    // RayAxis::cellAt: an estimate, then steps until it is right.
    HWY_INLINE void findCell(V first, V lambda) {
        constexpr int kRepairs = 4;
        const V zero = hn::Zero(D()), one = constant(1), last = constant(grid_.cells - 1);
        const V place = hn::Floor(hn::Add(start_, hn::Mul(lambda, run_)));
        const V guess = grid_.wraps ? place : hn::Min(hn::Max(place, zero), last);
        cell_ = hn::IfThenElse(hn::Or(still_, hn::Not(hn::Gt(lambda, zero))), first, guess);
        const V ahead = hn::IfThenElse(forward_, one, constant(-1));
        // Where there is no neighbour, the cell does not change.
        M stays = still_;
        const auto step = [&](M wrong, V side) {
            const V next = hn::Add(cell_, side);
            if (!grid_.wraps) {
                const M none = hn::Or(hn::Lt(next, zero), hn::Gt(next, last));
                stays = hn::Or(stays, hn::And(wrong, none));
                wrong = hn::AndNot(none, wrong);
            }
            cell_ = hn::IfThenElse(wrong, next, cell_);
        };
        for (int n = 0; n < kRepairs; ++n) {
            const M behind = hn::AndNot(stays, hn::Le(leaveCell(), lambda));
            if (hn::AllFalse(D(), behind)) break;
            step(behind, ahead);
        }
        for (int n = 0; n < kRepairs; ++n) {
            const M beyond = hn::AndNot(stays, hn::Gt(enterCell(), lambda));
            if (hn::AllFalse(D(), beyond)) break;
            step(beyond, hn::Neg(ahead));
        }
        base_ = zero;
        if (!grid_.wraps) return;
        const V periods = hn::Floor(hn::Mul(hn::Add(cell_, constant(0.5)), constant(1.0 / grid_.cells)));
        base_ = hn::Mul(periods, constant(grid_.cells));
    }

    const GridAxis& grid_;
    V start_, run_, inverse_;
    M still_, forward_;
    V cell_, base_;
};

// A vector of rays in flight.
template <class Visits>
class VoxelWalk : public VectorOfRays<VoxelWalk<Visits>, DistanceWalk> {
  public:
    explicit VoxelWalk(RayQueue<DistanceWalk>& queue)
        : Rays(queue),
          walk_(queue.search),
          field_(walk_.field()),
          grid_(walk_.grid()),
          map_(*walk_.distanceMap()),
          values_(std::get<std::vector<float>>(map_.values.codes()).data()) {}

    bool take(std::size_t lane, const ViewRay& ray, std::size_t number);
    void step();

  private:
    using Rays = VectorOfRays<VoxelWalk, DistanceWalk>;
    using Rays::active_;
    using Rays::queue_;
    using Rays::ray_;
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
    HWY_INLINE M leaf(const Axis& x, const Axis& y, V out, V& met) const;
    void end(std::size_t lane, const Hit& hit) {
        queue_.hits.set(ray_[lane], hit);
        active_ &= ~(1U << lane);
    }

    const DistanceWalk& walk_;
    const HeightField& field_;
    const CellGrid& grid_;
    const DistanceMap& map_;
    const float* values_;
    WalkAxisRows x_, y_;
    Row<double> lambda_{}, end_{}, metric_{}, plane_{}, served_{}, left_{};
};

template <class Visits>
bool VoxelWalk<Visits>::take(std::size_t lane, const ViewRay& viewRay, std::size_t number) {
    const GridRay ray(grid_, viewRay);
    // In a slab of no thickness a vertical ray has no length.
    if (!ray.inDomain() || !(walk_.perLambda(ray) > 0)) {
        queue_.fallback.push_back(number);
        return false;
    }
    if (ray.entersOutside(grid_)) {
        queue_.hits.set(number, Hit::none(Outcome::Miss));
        return false;
    }
    x_.set(lane, grid_.x, ray.x);
    y_.set(lane, grid_.y, ray.y);
    lambda_[lane] = 0;
    end_[lane] = ray.end(grid_);
    metric_[lane] = walk_.perLambda(ray);
    plane_[lane] = azimuthSector(ray.x.run, ray.y.run, map_.parameters.sectors) * map_.layers();
    served_[lane] = walk_.serves(ray) ? 1 : 0;
    left_[lane] = walk_.records(ray);
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
    const V stored = hn::PromoteTo(D(), hn::GatherIndex(DF(), values_, hn::DemoteTo(DI(), number)));
    const M served = hn::Gt(load(served_), hn::Zero(D()));
    return hn::IfThenElse(served, stored, constant(static_cast<double>(StoredValues::kSurface)));
}

// leafHit() for the lanes' cells. Returns the lanes that have a hit, and its lambda in `met`.
template <class Visits>
M VoxelWalk<Visits>::leaf(const Axis& x, const Axis& y, V out, V& met) const {
    const V zero = hn::Zero(D()), one = constant(1);
    const V in = stdMax(stdMax(x.enterCell(), y.enterCell()), zero);
    const VI cx = hn::DemoteTo(DI(), x.index()), cy = hn::DemoteTo(DI(), y.index());
    if (field_.surface() == Surface::Columns) return exactColumn(heightsAt(field_.heights(), cx, cy), in, out, met);
    const ExactPlaces places{x.within(in),  y.within(in),     x.within(out),
                             y.within(out), hn::Sub(one, in), hn::Sub(one, out)};
    const ExactShare share = exactShare(exactGaps(cornersAt(field_.heights(), grid_, cx, cy), places), in, out);
    met = exactMeeting(share.above, share.below, in, out);
    return share.hit;
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
    V after = hn::Add(out, hn::Max(zero, further));
    const std::uint32_t tested = bitsOf(solid) & active_;
    const std::uint32_t walking = active_;
    std::uint32_t going = walking;
    if (tested != 0) {
        const V leaves = stdMin(stdMin(x.leaveCell(), y.leaveCell()), constant(1));
        after = hn::IfThenElse(solid, hn::Max(leaves, lambda), after);
        V met;
        const std::uint32_t hits = bitsOf(leaf(x, y, leaves, met)) & tested;
        Row<double> at;
        store(met, at);
        going &= ~hits;
        overLanes(hits, [&](std::size_t lane) { end(lane, Hit::at(queue_.rays[ray_[lane]], at[lane])); });
    }
    if constexpr (Visits::kRecords) {
        Visits::visit(ray_, walking, sideX.number, sideY.number, layer, distance, lambda, after);
    }
    const V left = hn::Sub(load(left_), constant(1));
    const std::uint32_t within = bitsOf(hn::Lt(after, load(end_)));
    const std::uint32_t more = bitsOf(hn::Gt(left, zero));
    store(after, lambda_), store(left, left_);
    overLanes(going & ~(within & more), [&](std::size_t lane) {
        end(lane, Hit::none((within >> lane & 1) != 0 ? Outcome::Limit : Outcome::Miss));
    });
    // Idle lanes stay at the start, where loads are valid.
    overLanes(~active_ & ((1U << kLanes) - 1), [&](std::size_t lane) { lambda_[lane] = 0; });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
