#include "relief/distance_walk_lanes.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "relief/distance_walk.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/distance_walk_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "relief/lanes/double_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// RayAxis of the rays in a vector.
struct WalkAxisRows {
    Row<double> start{}, run{}, inverse{};
    Row<double> first{};  // the cell at lambda = 0, counted on over the periods

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

    HWY_INLINE V cell() const { return cell_; }
    HWY_INLINE V index() const { return hn::Sub(cell_, base_); }
    HWY_INLINE V enterCell() const { return enter(cell_); }
    HWY_INLINE V leaveCell() const { return leave(cell_, hn::Add(cell_, constant(1))); }
    // Out of the cells [low, high) of the period.
    HWY_INLINE V leaveCells(V low, V high) const { return leave(hn::Add(base_, low), hn::Add(base_, high)); }
    // leaf_detail::within.
    HWY_INLINE V within(V lambda) const {
        const V x = hn::Add(start_, hn::Mul(lambda, run_));
        return hn::Min(hn::Max(hn::Sub(x, cell_), hn::Zero(D())), constant(1));
    }

  private:
    // GridAxis::edge of cells counted on over the periods.
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

    // RayAxis::cellAt: a guess, and steps until it is right.
    HWY_INLINE void findCell(V first, V lambda) {
        constexpr int kRepairs = 4;
        const V zero = hn::Zero(D()), one = constant(1), last = constant(grid_.cells - 1);
        const V place = hn::Floor(hn::Add(start_, hn::Mul(lambda, run_)));
        const V guess = grid_.wraps ? place : hn::Min(hn::Max(place, zero), last);
        cell_ = hn::IfThenElse(hn::Or(still_, hn::Not(hn::Gt(lambda, zero))), first, guess);
        const V ahead = hn::IfThenElse(forward_, one, constant(-1));
        // Where there is no neighbour the cell stays as it is.
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

// A vector of rays on their way.
class VoxelWalk : public VectorOfRays<VoxelWalk> {
  public:
    explicit VoxelWalk(RayQueue<DistanceWalk>& queue)
        : queue_(queue),
          walk_(queue.search),
          field_(walk_.field()),
          grid_(walk_.grid()),
          map_(*walk_.distanceMap()),
          values_(std::get<std::vector<float>>(map_.values.codes()).data()) {}

    bool fill(std::size_t lane);
    void step();

  private:
    using Axis = WalkAxisLanes;
    // Cells of a voxel's along one axis.
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
    HWY_INLINE M mayHit(const Axis& x, const Axis& y, V out) const;
    std::optional<double> leaf(std::size_t lane, double cellX, double cellY) const;
    void end(std::size_t lane, const Hit& hit) {
        queue_.hits.set(ray_[lane], hit);
        active_ &= ~(1U << lane);
    }

    RayQueue<DistanceWalk>& queue_;
    const DistanceWalk& walk_;
    const HeightField& field_;
    const CellGrid& grid_;
    const DistanceMap& map_;
    const float* values_;
    WalkAxisRows x_, y_;
    Row<double> lambda_{}, end_{}, metric_{}, plane_{}, served_{}, left_{};
    std::array<std::size_t, kLanes> ray_{};
};

bool VoxelWalk::fill(std::size_t lane) {
    while (queue_.next < queue_.last) {
        const std::size_t i = queue_.next++;
        const ViewRay viewRay = queue_.rays[i];
        if (!viewRay.finite()) {
            queue_.hits.set(i, Hit::none(Outcome::Miss));
            continue;
        }
        const GridRay ray(grid_, viewRay);
        // A slab of no thickness looked at from above has no length to share out.
        if (!ray.inDomain() || !(walk_.perLambda(ray) > 0)) {
            queue_.left.push_back(i);
            continue;
        }
        if (ray.entersOutside(grid_)) {
            queue_.hits.set(i, Hit::none(Outcome::Miss));
            continue;
        }
        x_.set(lane, grid_.x, ray.x);
        y_.set(lane, grid_.y, ray.y);
        lambda_[lane] = 0;
        end_[lane] = ray.end(grid_);
        metric_[lane] = walk_.perLambda(ray);
        plane_[lane] = azimuthSector(ray.x.run, ray.y.run, map_.parameters.sectors) * map_.layers();
        served_[lane] = walk_.serves(ray) ? 1 : 0;
        left_[lane] = walk_.records(ray);
        ray_[lane] = i;
        active_ |= 1U << lane;
        return true;
    }
    return false;
}

// DistanceWalk::voxelAt.
V VoxelWalk::layerAt(V lambda) const {
    const V zero = hn::Zero(D()), one = constant(1), layers = constant(map_.layers());
    const V guess = hn::Sub(hn::Ceil(hn::Mul(hn::Sub(one, lambda), layers)), one);
    const V layer = hn::Min(hn::Max(guess, zero), constant(map_.layers() - 1.0));
    const M lower = hn::And(hn::Gt(layer, zero), hn::Le(floorOf(layer), lambda));
    return hn::Sub(layer, hn::IfThenElseZero(lower, one));
}

// A mark for rays that the map does not serve.
V VoxelWalk::distanceOf(V bx, V by, V layer) const {
    const V plane = hn::Add(load(plane_), layer);
    const V row = hn::Add(hn::Mul(plane, constant(map_.ny())), by);
    const V number = hn::Add(hn::Mul(row, constant(map_.nx())), bx);
    const V stored = hn::PromoteTo(D(), hn::GatherIndex(DF(), values_, hn::DemoteTo(DI(), number)));
    const M served = hn::Gt(load(served_), hn::Zero(D()));
    return hn::IfThenElse(served, stored, constant(static_cast<double>(StoredValues::kSurface)));
}

// Whether the leaf may find a hit in the cells: the surface comes as near to the ray as rounding could matter.
M VoxelWalk::mayHit(const Axis& x, const Axis& y, V out) const {
    const V zero = hn::Zero(D()), one = constant(1), nearly = constant(-kExclusionMargin);
    const VI cx = hn::DemoteTo(DI(), x.index()), cy = hn::DemoteTo(DI(), y.index());
    const FloatImage& heights = field_.heights();
    const auto heightsAt = [&](VI i, VI j) {
        const VI at = hn::Add(hn::Mul(j, whole(heights.width())), i);
        return hn::PromoteTo(D(), hn::GatherIndex(DF(), heights.data(), at));
    };
    const V leaves = hn::Min(out, one), zOut = hn::Sub(one, leaves);
    if (field_.surface() == Surface::Columns) return hn::Ge(hn::Sub(heightsAt(cx, cy), zOut), nearly);
    const auto nodes = [&](const GridAxis& axis, VI k) {
        const VI last = whole(axis.texels - 1), next = hn::Add(k, whole(1));
        if (axis.wraps) return std::array{k, hn::IfThenZeroElse(hn::Eq(k, last), next)};
        return std::array{hn::Max(hn::Sub(k, whole(1)), whole(0)), hn::Min(k, last)};
    };
    const auto i = nodes(grid_.x, cx), j = nodes(grid_.y, cy);
    const V h00 = heightsAt(i[0], j[0]), h10 = heightsAt(i[1], j[0]);
    const V h01 = heightsAt(i[0], j[1]), h11 = heightsAt(i[1], j[1]);
    // The bilinear surface is nowhere above its highest node.
    const M high = hn::Ge(hn::Sub(hn::Max(hn::Max(h00, h10), hn::Max(h01, h11)), zOut), nearly);
    if (hn::AllFalse(D(), high)) return high;
    const V enters = hn::Max(hn::Max(x.enterCell(), y.enterCell()), zero);
    const auto lerp = [&](V u, V v) {
        const V upper = hn::Add(h00, hn::Mul(u, hn::Sub(h10, h00)));
        const V lower = hn::Add(h01, hn::Mul(u, hn::Sub(h11, h01)));
        return hn::Add(upper, hn::Mul(v, hn::Sub(lower, upper)));
    };
    const V uIn = x.within(enters), vIn = y.within(enters), uOut = x.within(leaves), vOut = y.within(leaves);
    const V bend =
        hn::Mul(hn::Mul(hn::Sub(uOut, uIn), hn::Sub(vOut, vIn)), hn::Sub(hn::Sub(h11, h10), hn::Sub(h01, h00)));
    const V fIn = hn::Sub(lerp(uIn, vIn), hn::Sub(one, enters)), fOut = hn::Sub(lerp(uOut, vOut), zOut);
    // Between its ends the parabola is above the line through them by a quarter of its bend at most.
    const V arch = hn::Mul(hn::Max(hn::Neg(bend), zero), constant(0.25));
    return hn::And(high, hn::Ge(hn::Add(hn::Max(fIn, fOut), arch), nearly));
}

std::optional<double> VoxelWalk::leaf(std::size_t lane, double cellX, double cellY) const {
    const auto cellOf = [](const GridAxis& grid, double cell) {
        const double base = grid.wraps ? std::floor((cell + 0.5) / grid.cells) * grid.cells : 0;
        return AxisCell{static_cast<int>(cell - base), static_cast<std::int64_t>(base)};
    };
    const GridRay ray(grid_, queue_.rays[ray_[lane]]);
    return walk_.leaf(ray, cellOf(grid_.x, cellX), cellOf(grid_.y, cellY));
}

void VoxelWalk::step() {
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
    std::uint32_t going = active_;
    if (tested != 0) {
        const V leaves = hn::Min(hn::Min(x.leaveCell(), y.leaveCell()), constant(1));
        after = hn::IfThenElse(solid, hn::Max(leaves, lambda), after);
        const std::uint32_t asked = bitsOf(mayHit(x, y, leaves)) & tested;
        if (asked != 0) {
            Row<double> cellX, cellY;
            store(x.cell(), cellX), store(y.cell(), cellY);
            overLanes(asked, [&](std::size_t lane) {
                const auto hit = leaf(lane, cellX[lane], cellY[lane]);
                if (!hit) return;
                going &= ~(1U << lane);
                end(lane, Hit::at(queue_.rays[ray_[lane]], *hit));
            });
        }
    }
    const V left = hn::Sub(load(left_), constant(1));
    const std::uint32_t within = bitsOf(hn::Lt(after, load(end_)));
    const std::uint32_t more = bitsOf(hn::Gt(left, zero));
    store(after, lambda_), store(left, left_);
    overLanes(going & ~(within & more), [&](std::size_t lane) {
        end(lane, Hit::none((within >> lane & 1) != 0 ? Outcome::Limit : Outcome::Miss));
    });
    // Idle lanes stay at the start: a place to read.
    overLanes(~active_ & ((1U << kLanes) - 1), [&](std::size_t lane) { lambda_[lane] = 0; });
}

void walkAll(const DistanceWalk& walk, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
             std::vector<std::size_t>& left) {
    RayQueue<DistanceWalk> queue{walk, rays, hits, first, last, left};
    goInTurn<VoxelWalk>(queue);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(walkAll);

std::vector<std::size_t> walkInLanes(const DistanceWalk& walk, const RayBlock& rays, std::size_t first,
                                     std::size_t last, HitBlock& hits) {
    std::vector<std::size_t> left;
    const auto* values = std::get_if<std::vector<float>>(&walk.distanceMap()->values.codes());
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (values == nullptr || values->size() > kMost || walk.field().heights().size() > kMost) {
        left.resize(last - first);
        std::iota(left.begin(), left.end(), first);
        return left;
    }
    HWY_DYNAMIC_DISPATCH(walkAll)(walk, rays, first, last, hits, left);
    return left;
}

}  // namespace relief
#endif
