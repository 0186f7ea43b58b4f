// What SIMD walks from cell to cell in double have in common: the cells of the rays of a vector, the leaf and the
// advance. One ray per lane. Compiled for each target.

#if defined(RELIEF_CELL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CELL_LANES_INL_H
#undef RELIEF_CELL_LANES_INL_H
#else
#define RELIEF_CELL_LANES_INL_H
#endif

#include <algorithm>
#include <limits>

#include "relief/cell_grid.h"
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

// A vector of rays in flight from cell to cell. Walk: as for VectorOfRays; its take() calls begin(), its step() ends
// with moveOn().
template <class Walk, class Search>
class CellWalk : public VectorOfRays<Walk, Search> {
  protected:
    CellWalk(RayQueue<Search>& queue, const HeightField& field, const CellGrid& grid)
        : VectorOfRays<Walk, Search>(queue), field_(field), grid_(grid) {}

    // Sets up a lane for ray `number` of the block, which may take `steps` steps. Returns false if the ray enters
    // outside; its hit is set.
    bool begin(std::size_t lane, std::size_t number, const GridRay& ray, double steps) {
        if (queue_.segments == nullptr && ray.entersOutside(grid_)) {
            queue_.hits.set(number, Hit::none(Outcome::Miss));
            return false;
        }
        const Segment segment = queue_.segmentOf(number);
        x_.set(lane, grid_.x, ray.x);
        y_.set(lane, grid_.y, ray.y);
        lambda_[lane] = segment.in;
        end_[lane] = std::min(segment.out, ray.end(grid_));
        left_[lane] = steps;
        return true;
    }

    // Ends a step: the rays in `tested` cells hit there or leave the cell, the others advance to `after`. Returns where
    // the rays advance to.
    HWY_INLINE V moveOn(const WalkAxisLanes& x, const WalkAxisLanes& y, V lambda, M tested, V after) {
        const std::uint32_t tests = bitsOf(tested) & active_;
        std::uint32_t going = active_;
        if (tests != 0) {
            const V leaves = stdMin(stdMin(x.leaveCell(), y.leaveCell()), constant(1));
            after = hn::IfThenElse(tested, hn::Max(leaves, lambda), after);
            V met;
            const std::uint32_t hits = bitsOf(leaf(x, y, leaves, met)) & tests;
            Row<double> at;
            store(met, at);
            going &= ~hits;
            overLanes(hits, [&](std::size_t lane) { end(lane, Hit::at(queue_.rays[ray_[lane]], at[lane])); });
        }
        const V left = hn::Sub(load(left_), constant(1));
        const std::uint32_t within = bitsOf(hn::Lt(after, load(end_)));
        const std::uint32_t more = bitsOf(hn::Gt(left, hn::Zero(D())));
        store(after, lambda_), store(left, left_);
        overLanes(going & ~(within & more), [&](std::size_t lane) {
            end(lane, Hit::none((within >> lane & 1) != 0 ? Outcome::Limit : Outcome::Miss));
        });
        // Idle lanes stay at the start, where loads are valid.
        overLanes(~active_ & ((1U << kLanes) - 1), [&](std::size_t lane) { lambda_[lane] = 0; });
        return after;
    }

    using Rays = VectorOfRays<Walk, Search>;
    using Rays::active_;
    using Rays::queue_;
    using Rays::ray_;
    const HeightField& field_;
    const CellGrid& grid_;
    WalkAxisRows x_, y_;
    Row<double> lambda_{}, end_{}, left_{};

  private:
    // leafHit() for the lanes' cells. Returns the lanes that have a hit, and its lambda in `met`.
    HWY_INLINE M leaf(const WalkAxisLanes& x, const WalkAxisLanes& y, V out, V& met) const {
        const V zero = hn::Zero(D()), one = constant(1);
        const V in = stdMax(stdMax(x.enterCell(), y.enterCell()), zero);
        const VI cx = hn::DemoteTo(DI(), x.index()), cy = hn::DemoteTo(DI(), y.index());
        if (field_.surface() == Surface::Columns) {
            return exactColumn(heightsAt(field_.heights(), cx, cy), in, out, met);
        }
        const ExactPlaces places{x.within(in),  y.within(in),     x.within(out),
                                 y.within(out), hn::Sub(one, in), hn::Sub(one, out)};
        const ExactShare share = exactShare(exactGaps(cornersAt(field_.heights(), grid_, cx, cy), places), in, out);
        met = exactMeeting(share.above, share.below, in, out);
        return share.hit;
    }
    void end(std::size_t lane, const Hit& hit) {
        queue_.hits.set(ray_[lane], hit);
        active_ &= ~(1U << lane);
    }
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
