// The cone walk of many rays: all take a step, one vector after the other; those that wait for the leaf wait in place
// until half of them do. The steps of a pass know nothing of each other, so the processor has several vectors' reads
// in flight, and branches are taken for whole passes. Compiled for each target.

#if defined(RELIEF_CONE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_WALK_INL_H
#undef RELIEF_CONE_WALK_INL_H
#else
#define RELIEF_CONE_WALK_INL_H
#endif

#include <hwy/cache_control.h>

#include "relief/lanes/cone_slots-inl.h"
#include "relief/lanes/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// No crossing: beyond all.
inline constexpr float kNever = 1e30F;

template <Address kAddress, Surface kSurface>
class ConeKernel : WalkSlots<kAddress> {
    using Slots = WalkSlots<kAddress>;
    using Slots::columns_;
    using Slots::compact;
    using Slots::df_;
    using Slots::di_;
    using Slots::end_;
    using Slots::fill;
    using Slots::map_;
    using Slots::next_;
    using Slots::rays_;
    using Slots::realCell;
    using Slots::scene_;
    using Slots::used_;
    using Slots::waiting_;
    using Slots::walking_;
    using typename Slots::Grid;
    using typename Slots::Map;

  public:
    using Slots::Slots;

    void run() {
        fill();
        while (walking_ + waiting_ > 0 || next_ < end_) {
            if (waiting_ >= walking_) {
                leavesOfAll();
            } else {
                stepOfAll();
            }
            const std::size_t idle = used_ - walking_ - waiting_;
            if (idle >= kLanes && 4 * idle >= used_) {
                compact();
                fill();
            }
        }
        compact();
    }

  private:
    struct Axis : LaneAxisState {
        VI n, next, last;
        VF cross;  // lambda at which the cell is left
    };
    struct Stay {
        Axis x, y;
        VF tie, rim, first, out;
    };

    HWY_INLINE static Axis load(const Grid& grid, const WalkAxis& from, std::size_t i) {
        const DF df;
        const DI di;
        Axis out;
        out.n = hn::Load(di, from.n.data() + i);
        out.next = hn::Add(out.n, hn::Set(di, 1));
        out.last = hn::Load(di, from.last.data() + i);
        out.inverse = hn::Load(df, from.inverse.data() + i);
        out.base = hn::Load(df, from.base.data() + i);
        out.run = hn::Load(df, from.run.data() + i);
        out.mirrored = hn::FirstN(df, grid.mirrored ? kLanes : 0);
        out.cross = hn::MulAdd(hn::ConvertTo(df, out.next), out.inverse, out.base);
        if constexpr (kAddress == Address::Clamp) {
            out.cross = hn::IfThenElse(asFloat(hn::Eq(out.n, out.last)), hn::Set(df, kNever), out.cross);
        }
        return out;
    }
    HWY_INLINE static Stay stay(const Map& map, const WalkColumns& columns, std::size_t i) {
        const DF df;
        Stay out;
        out.x = load(map.x, columns.x, i);
        out.y = load(map.y, columns.y, i);
        out.tie = hn::Load(df, columns.tie.data() + i);
        out.rim = hn::Set(df, 1.0F);
        if constexpr (kAddress == Address::Border) out.rim = hn::Load(df, columns.rim.data() + i);
        out.first = hn::Min(out.x.cross, out.y.cross);
        out.out = hn::Min(out.first, out.rim);
        return out;
    }

    HWY_INLINE static VF depthOf(const Map& map, VI bits) {
        const DF df;
        const DI di;
        return hn::MulAdd(hn::ConvertTo(df, hn::And(bits, hn::Set(di, static_cast<std::int32_t>(kConeDepths)))),
                          hn::Set(df, map.unit), hn::Set(df, map.top));
    }

    // A cone step of all that walk.
    void stepOfAll() {
        // Copies, for vectors that are stored might be those members.
        const Map map = map_;
        WalkColumns& columns = columns_;
        std::size_t waiting = 0;
        for (std::size_t i = 0, end = used_; i < end; i += kLanes) waiting += step(map, columns, i);
        waiting_ += waiting;
        walking_ -= waiting;
    }

    // Returns how many came to a leaf.
    HWY_INLINE std::size_t step(const Map& map, WalkColumns& columns, std::size_t i) {
        const DF df;
        const DI di;
        const VI state = hn::Load(di, columns.state.data() + i);
        const MF walking = asFloat(hn::Eq(state, hn::Set(di, kWalking)));
        const Stay at = stay(map, columns, i);
        // Ended rays are within the map still: their words may be read.
        const VI word = hn::GatherIndex(di, map.words, hn::Load(di, columns.index.data() + i));
        const MF above = hn::Lt(at.out, depthOf(map, word));
        const MF leaf = hn::AndNot(above, walking);
        const MF on = hn::And(above, walking);
        hn::Store(hn::IfThenElse(asInt(leaf), hn::Set(di, kAtLeaf), state), di, columns.state.data() + i);
        // The ray meets the cone; the approximate reciprocal's error and all rounding is in the factor.
        const VF apex = depthOf(map, hn::ShiftRight<10>(word));
        const VF steepness = hn::MulAdd(hn::BitCast(df, word), hn::Max(at.x.run, at.y.run), hn::Set(df, 1.0F));
        const VF share = hn::Mul(hn::ApproximateReciprocal(steepness), hn::Set(df, 1 - 0x1p-10F));
        const VF jump = hn::MulAdd(hn::Max(hn::Sub(apex, at.out), hn::Zero(df)), share, at.out);
        moveOn(map, columns, i, at, on, jump);
        if (map.large) prefetch(map, columns.index.data() + i);
        return hn::CountTrue(df, leaf);
    }

    HWY_INLINE static VI nextCell(const Axis& axis, const WalkAxis& column, std::size_t i, MF move, VF jump) {
        const DF df;
        const DI di;
        // Down to a whole number (place is half a cell less), for numbers below 2^22: no overflow to mend.
        constexpr float kWhole = 0x1.8p23F;
        const VF place = hn::MulSub(jump, axis.run, hn::Load(df, column.place.data() + i));
        const VI whole = hn::Sub(hn::BitCast(di, hn::Add(place, hn::Set(df, kWhole))),
                                 hn::Set(di, std::bit_cast<std::int32_t>(kWhole)));
        return hn::Max(hn::IfThenElse(asInt(move), axis.next, axis.n), whole);
    }

    HWY_INLINE static void prefetch(const Map& map, const std::int32_t* index) {
        for (std::size_t k = 0; k < kLanes; ++k) hwy::Prefetch(map.words + index[k]);
    }

    // To the cell where the jump ends, the next one at least.
    HWY_INLINE void moveOn(const Map& map, WalkColumns& columns, std::size_t i, const Stay& at, MF who, VF jump) {
        const DF df;
        const DI di;
        const VI nextX = nextCell(at.x, columns.x, i, hn::Le(at.x.cross, at.y.cross), jump);
        const VI nextY = nextCell(at.y, columns.y, i, hn::Le(at.y.cross, at.x.cross), jump);
        const MF near = hn::Lt(hn::Abs(hn::Sub(at.x.cross, at.y.cross)), at.tie);
        const MF atRim = hn::Ge(hn::Add(at.first, at.tie), at.rim);
        const MF beyond = asFloat(hn::Or(hn::Gt(nextX, at.x.last), hn::Gt(nextY, at.y.last)));
        const MF rare = hn::And(who, hn::Or(hn::Or(near, atRim), beyond));
        if (HWY_UNLIKELY(!hn::AllFalse(df, rare))) return moveWithCare(i, who, jump);
        const MI whoI = asInt(who);
        const VI along = hn::IfThenElseZero(whoI, hn::Sub(nextX, at.x.n));
        const VI across = hn::IfThenElseZero(whoI, hn::Sub(nextY, at.y.n));
        hn::Store(hn::Add(at.x.n, along), di, columns.x.n.data() + i);
        hn::Store(hn::Add(at.y.n, across), di, columns.y.n.data() + i);
        VI index = hn::Load(di, columns.index.data() + i);
        index = map.x.mirrored ? hn::Sub(index, along) : hn::Add(index, along);
        index = hn::Add(index, hn::Mul(across, hn::Set(di, map.y.stride)));
        hn::Store(index, di, columns.index.data() + i);
    }
    HWY_INLINE void store(WalkColumn<std::int32_t>& column, std::size_t i, MF who, VI value) const {
        hn::BlendedStore(value, asInt(who), di_, column.data() + i);
    }

    // The same where a ray is near a corner or the rim, or leaves the map.
    HWY_NOINLINE void moveWithCare(std::size_t i, MF who, VF jump) {
        const Stay at = stay(map_, columns_, i);
        const MF near = hn::And(hn::Lt(hn::Abs(hn::Sub(at.x.cross, at.y.cross)), at.tie),
                                hn::Lt(jump, hn::Add(hn::Max(at.x.cross, at.y.cross), at.tie)));
        const MF atRim = hn::Ge(hn::Add(at.first, at.tie), at.rim);
        const MF down = hn::Ge(at.rim, hn::Set(df_, 1.0F));
        MF bad = hn::And(hn::And(who, down), hn::Ge(at.out, hn::Set(df_, 1.0F)));
        if constexpr (kAddress == Address::Border) {
            // Beyond the rim for sure; or which comes first, rim or line, cannot be told.
            const MF leaving = hn::And(who, hn::AndNot(down, atRim));
            const MF gone = hn::And(leaving, hn::Gt(hn::Max(at.first, jump), hn::Add(at.rim, at.tie)));
            end(i, gone, LaneEnd::Miss);
            bad = hn::Or(bad, hn::AndNot(gone, leaving));
            who = hn::AndNot(gone, who);
        }
        // Too near a corner to tell which neighbour comes first, and the jump does not pass it: both must be skipped.
        const MF both = hn::And(who, near);
        const MF clear = hn::And(sideClear(i, at, both, true), sideClear(i, at, both, false));
        bad = hn::And(who, hn::Or(bad, hn::AndNot(clear, both)));
        end(i, bad, LaneEnd::Scalar);
        who = hn::AndNot(bad, who);
        const MF moveX = hn::Or(both, hn::Le(at.x.cross, at.y.cross));
        const MF moveY = hn::Or(both, hn::Le(at.y.cross, at.x.cross));
        arrive(i, who, at.x, columns_.x, map_.x, nextCell(at.x, columns_.x, i, moveX, jump));
        // Without those that have ended on the other axis.
        const VI state = hn::Load(di_, columns_.state.data() + i);
        who = hn::And(who, asFloat(hn::Eq(state, hn::Set(di_, kWalking))));
        arrive(i, who, at.y, columns_.y, map_.y, nextCell(at.y, columns_.y, i, moveY, jump));
    }

    HWY_INLINE void arrive(std::size_t i, MF who, const Axis& axis, WalkAxis& column, const Grid& grid, VI next) {
        const MI whoI = asInt(who);
        VI last = axis.last;
        MI beyond = hn::And(whoI, hn::Gt(next, last));
        VI moved = hn::IfThenElseZero(whoI, hn::Sub(next, axis.n));
        if constexpr (kAddress == Address::Repeat) {
            const VI period = hn::Set(di_, grid.last + 1 - grid.low);
            VI back = hn::Zero(di_);
            while (!hn::AllFalse(di_, beyond)) {
                last = hn::IfThenElse(beyond, hn::Add(last, period), last);
                back = hn::IfThenElse(beyond, hn::Add(back, period), back);
                beyond = hn::And(whoI, hn::Gt(next, last));
            }
            hn::Store(last, di_, column.last.data() + i);
            moveIndex(i, grid, hn::Sub(moved, back));
        } else {
            if constexpr (kAddress == Address::Border) end(i, asFloat(beyond), LaneEnd::Miss);
            moved = hn::IfThenElse(beyond, hn::Sub(last, axis.n), moved);
            moveIndex(i, grid, moved);
        }
        hn::Store(hn::Add(axis.n, moved), di_, column.n.data() + i);
    }
    HWY_INLINE void moveIndex(std::size_t i, const Grid& grid, VI cells) {
        const VI index = hn::Load(di_, columns_.index.data() + i);
        hn::Store(hn::Add(index, hn::Mul(cells, hn::Set(di_, grid.stride))), di_, columns_.index.data() + i);
    }

    // Whether the neighbour along one axis alone is surely above the surface until the corner is passed.
    HWY_INLINE MF sideClear(std::size_t i, const Stay& at, MF who, bool alongX) const {
        const Grid& grid = alongX ? map_.x : map_.y;
        const Axis& axis = alongX ? at.x : at.y;
        const MI beyond = hn::Eq(axis.n, axis.last);
        std::int32_t ahead = 0;  // cells from the last one
        if constexpr (kAddress == Address::Repeat) ahead = grid.low - grid.last;
        const VI step = hn::IfThenElse(beyond, hn::Set(di_, ahead * grid.stride), hn::Set(di_, grid.stride));
        const VI index = hn::Add(hn::Load(di_, columns_.index.data() + i), step);
        const VF own = depthOf(map_, hn::GatherIndex(di_, map_.words, hn::IfThenElseZero(asInt(who), index)));
        const MF clear = hn::Lt(hn::Add(at.out, hn::Add(at.tie, at.tie)), own);
        if constexpr (kAddress == Address::Clamp) return hn::Or(clear, asFloat(beyond));
        if constexpr (kAddress == Address::Border) return hn::AndNot(asFloat(beyond), clear);
        return clear;
    }

    // Cells whose highest point the ray goes below: is the surface itself below it? Of all that wait for it.
    void leavesOfAll() {
        const Map map = map_;
        WalkColumns& columns = columns_;
        std::size_t on = 0;
        waiting_ = 0;
        alignas(64) WalkColumn<std::int32_t> pairs;
        if constexpr (kSurface == Surface::Bilinear) placesOfNodes(map, columns, pairs);
        for (std::size_t i = 0, end = used_; i < end; i += kLanes) on += leaves(map, columns, i, pairs.data() + i);
        walking_ += on;
    }

    // All of them before the first is looked up: written as vectors, read lane by lane.
    HWY_INLINE void placesOfNodes(const Map& map, const WalkColumns& columns, WalkColumn<std::int32_t>& pairs) const {
        const DI di;
        for (std::size_t i = 0, end = used_; i < end; i += kLanes) {
            const auto cell = [&](const Grid& grid, const WalkAxis& axis) {
                return realCell(grid, hn::Load(di, axis.n.data() + i), hn::Load(di, axis.last.data() + i));
            };
            const VI row = hn::Mul(cell(map.y, columns.y), hn::Set(di, scene_.nodeStride));
            hn::Store(hn::Add(row, cell(map.x, columns.x)), di, pairs.data() + i);
        }
    }

    // Returns how many walk on.
    HWY_INLINE std::size_t leaves(const Map& map, WalkColumns& columns, std::size_t i, const std::int32_t* pair) {
        const DF df;
        const DI di;
        const VI state = hn::Load(di, columns.state.data() + i);
        const MI whoI = hn::Eq(state, hn::Set(di, kAtLeaf));
        const MF who = asFloat(whoI);
        const Stay at = stay(map, columns, i);
        const VI realX = realCell(map.x, at.x.n, at.x.last), realY = realCell(map.y, at.y.n, at.y.last);
        MF below;
        if constexpr (kSurface == Surface::Columns) {
            below = columnBelow(scene_, realX, realY, at.out, at.tie);
        } else {
            const VF nx = hn::ConvertTo(df, at.x.n), ny = hn::ConvertTo(df, at.y.n);
            VF in = hn::Max(hn::MulAdd(nx, at.x.inverse, at.x.base), hn::MulAdd(ny, at.y.inverse, at.y.base));
            in = hn::Min(hn::Max(hn::Sub(in, at.tie), hn::Zero(df)), at.out);
            const auto h = nodesAt(df, scene_.nodes, pair);
            below = patchBelow({h[0], h[2], h[1], h[3]}, at.x, at.y, nx, ny, in, at.out, at.tie);
        }
        const MF on = hn::And(below, who);
        const VI after = hn::IfThenElse(asInt(on), hn::Set(di, kWalking), hn::Set(di, kEnded));
        hn::Store(hn::IfThenElse(whoI, after, state), di, columns.state.data() + i);
        moveOn(map, columns, i, at, on, at.out);
        return hn::CountTrue(df, on);
    }

    HWY_INLINE void end(std::size_t i, MF who, LaneEnd how) {
        if (hn::AllFalse(df_, who)) return;
        walking_ -= hn::CountTrue(df_, who);
        store(columns_.state, i, who, hn::Set(di_, kEnded));
        noteEnd(rays_, asInt(who), hn::Load(di_, columns_.slot.data() + i), how);
    }
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
