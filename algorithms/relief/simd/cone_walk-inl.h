// The SIMD cone walk of many rays. All rays take a step, one vector after the other; rays that need a leaf test wait in
// place until half of the rays do. The steps of a pass are independent, so the processor has memory accesses of several
// vectors in flight, and branches are taken for whole passes. Compiled for each target.

#if defined(RELIEF_CONE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_WALK_INL_H
#undef RELIEF_CONE_WALK_INL_H
#else
#define RELIEF_CONE_WALK_INL_H
#endif

#include "relief/simd/cone_slots-inl.h"
#include "relief/simd/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Lambda of a line that is never crossed.
inline constexpr float kNever = 1e30F;

template <Address kAddress, Surface kSurface, class Arithmetic>
class ConeKernel : WalkSlots<kAddress, Arithmetic> {
    using Slots = WalkSlots<kAddress, Arithmetic>;
    using Slots::cellsOfHits;
    using Slots::columns_;
    using Slots::compact;
    using Slots::df_;
    using Slots::di_;
    using Slots::end_;
    using Slots::fill;
    using Slots::frameX_;
    using Slots::frameY_;
    using Slots::map_;
    using Slots::next_;
    using Slots::rays_;
    using Slots::resumes_;
    using Slots::scene_;
    using Slots::used_;
    using Slots::waiting_;
    using Slots::walking_;

  public:
    using Slots::only;
    using Slots::Slots;

    void run() {
        map_.wide ? walk<true>() : walk<false>();
        cellsOfHits();
    }

  private:
    // Position of a ray on one axis.
    struct Axis {
        VF n;
        VF cross;  // lambda at which the ray leaves the cell
    };
    struct CellExit {
        Axis x, y;
        VF tie, rim, first, out;
    };

    template <bool kWide>
    void walk() {
        fillAndResume<kWide>();
        while (walking_ + waiting_ > 0 || next_ < end_) {
            if (waiting_ >= walking_) {
                leavesOfAll<kWide>();
            } else {
                stepOfAll<kWide>();
            }
            const std::size_t idle = used_ - walking_ - waiting_;
            if (idle == used_ || (idle >= kLanes && 4 * idle >= used_)) {
                compact();
                fillAndResume<kWide>();
            }
        }
        compact();
    }

    // Takes new rays. Those that resume after their cell move out of it.
    template <bool kWide>
    HWY_INLINE void fillAndResume() {
        const std::size_t before = used_;
        fill();
        if (HWY_LIKELY(!resumes_)) return;
        for (std::size_t i = before; i < used_; i += kLanes) {
            const VI within = hn::GatherIndex(di_, rays_.within.data(), hn::Load(di_, columns_.slot.data() + i));
            const MI walking = hn::Eq(hn::Load(di_, columns_.state.data() + i), hn::Set(di_, kWalking));
            const MF who = asFloat(hn::And(walking, hn::Eq(within, hn::Zero(di_))));
            const CellExit at = cellExit(columns_, i);
            moveOn<kWide>(map_, columns_, i, at.x, at.y, who, at.out);
        }
    }

    HWY_INLINE static Axis load(const WalkAxis& from, std::size_t i) {
        const DF df;
        Axis out;
        out.n = hn::Load(df, from.n.data() + i);
        out.cross =
            Arithmetic::mulAdd(out.n, hn::Load(df, from.inverse.data() + i), hn::Load(df, from.base.data() + i));
        if constexpr (kAddress == Address::Clamp) {
            const MF last = hn::Eq(out.n, hn::Load(df, from.last.data() + i));
            out.cross = hn::IfThenElse(last, hn::Set(df, kNever), out.cross);
        }
        return out;
    }
    HWY_INLINE static CellExit cellExit(const WalkColumns& columns, std::size_t i) {
        const DF df;
        CellExit out;
        out.x = load(columns.x, i);
        out.y = load(columns.y, i);
        out.tie = hn::Load(df, columns.tie.data() + i);
        out.rim = hn::Load(df, columns.rim.data() + i);
        out.first = hn::Min(out.x.cross, out.y.cross);
        out.out = hn::Min(out.first, out.rim);
        return out;
    }

    // The data of a step, fetched while the vector before is processed.
    struct Fetched {
        Axis x, y;
        VF out;  // lambda at which the ray leaves the cell, or before that the map or the slab
        VI entry;
    };
    template <bool kWide>
    HWY_INLINE static Fetched fetch(const WalkMap& map, const WalkColumns& columns, std::size_t i) {
        Fetched out;
        out.x = load(columns.x, i), out.y = load(columns.y, i);
        // Ended rays are still within the map, and vectors beyond the last have index 0, so that their entries may be
        // fetched.
        out.entry =
            hn::GatherIndex(DI(), map.entries, Slots::template entryIndexOf<kWide>(columns, i, out.x.n, out.y.n));
        out.out = hn::Min(out.x.cross, out.y.cross);
        return out;
    }

    // The destination of a step, computed while the vector before moves.
    struct Planned {
        Axis x, y;
        VF jump;
        MF on;
    };

    // A cone step of all walking rays. The stages (fetch, plan, move) of a vector form a dependency chain; processing
    // three vectors in different stages overlaps these chains.
    template <bool kWide>
    HWY_NOINLINE void stepOfAll() {
        // Local copies, since the compiler must assume that vector stores change members.
        const WalkMap map = map_;
        WalkColumns& columns = columns_;
        std::size_t waiting = 0;
        Fetched fetched = fetch<kWide>(map, columns, kLanes);
        Planned now = plan(map, columns, 0, fetch<kWide>(map, columns, 0), waiting);
        for (std::size_t i = 0, end = used_; i < end; i += kLanes) {
            const Fetched later = fetch<kWide>(map, columns, i + 2 * kLanes);
            const Planned next = plan(map, columns, i + kLanes, fetched, waiting);
            moveOn<kWide>(map, columns, i, now.x, now.y, now.on, now.jump);
            now = next;
            fetched = later;
        }
        waiting_ += waiting;
        walking_ -= waiting;
    }

    // Plans the step of a vector; adds the number of rays that need a leaf test to `waiting`. At the rim and at the
    // bottom of the slab the exit is too late here, which only causes additional leaf tests; moveOn() accounts for it.
    HWY_INLINE static Planned plan(const WalkMap& map, WalkColumns& columns, std::size_t i, const Fetched& at,
                                   std::size_t& waiting) {
        const DF df;
        const DI di;
        const VI state = hn::Load(di, columns.state.data() + i);
        const MF walking = asFloat(hn::Eq(state, hn::Set(di, kWalking)));
        if constexpr (Arithmetic::kRecords) Arithmetic::visit(columns, i, at.x.n, at.y.n, at.entry, walking);
        const MF above = hn::Lt(at.out, ownOf<Arithmetic>(map, at.entry));
        const MF leaf = hn::AndNot(above, walking);
        hn::Store(hn::IfThenElse(asInt(leaf), hn::Set(di, kAtLeaf), state), di, columns.state.data() + i);
        waiting += hn::CountTrue(df, leaf);
        // Where the ray meets the cone.
        const VF apex = apexOf<Arithmetic>(map, at.entry);
        const VF steepness = Arithmetic::mulAdd(hn::BitCast(df, at.entry), hn::Load(df, columns.steep.data() + i),
                                                hn::Set(df, kSteeper));
        const VF free = hn::Max(hn::Sub(apex, at.out), hn::Zero(df));
        Planned out;
        out.x = at.x, out.y = at.y;
        out.on = hn::And(above, walking);
        out.jump = Arithmetic::mulAdd(free, Arithmetic::reciprocal(steepness), at.out);
        return out;
    }

    HWY_INLINE static VF nextCell(VF n, const WalkAxis& column, std::size_t i, MF moves, VF jump) {
        const DF df;
        // Rounds down: half a cell has been subtracted in `place`.
        const VF place =
            Arithmetic::mulSub(jump, hn::Load(df, column.run.data() + i), hn::Load(df, column.place.data() + i));
        const VF whole = hn::Sub(hn::Add(place, hn::Set(df, kWhole)), hn::Set(df, kWhole));
        return hn::Max(hn::IfThenElse(moves, hn::Add(n, hn::Set(df, 1.0F)), n), whole);
    }

    // Moves to the cell where the jump ends, but at least to the next one. The jump ends no earlier than the ray leaves
    // the cell.
    template <bool kWide>
    HWY_INLINE void moveOn(const WalkMap& map, WalkColumns& columns, std::size_t i, const Axis& x, const Axis& y,
                           MF who, VF jump) {
        const DF df;
        const MF alongX = hn::Le(x.cross, y.cross);
        const VF nextX = nextCell(x.n, columns.x, i, alongX, jump);
        const VF nextY = nextCell(y.n, columns.y, i, hn::Not(alongX), jump);
        // Rare: near a corner, or near the rim.
        const VF toCorner = hn::Abs(hn::Sub(x.cross, y.cross));
        const VF toRim = hn::Sub(hn::Load(df, columns.rim.data() + i), jump);
        MF rare = hn::Le(hn::Min(toCorner, toRim), hn::Load(df, columns.tie.data() + i));
        if constexpr (kAddress != Address::Border) {
            const auto beyond = [&](VF next, const WalkAxis& axis) {
                return hn::Gt(next, hn::Load(df, axis.last.data() + i));
            };
            rare = hn::Or(rare, hn::Or(beyond(nextX, columns.x), beyond(nextY, columns.y)));
        }
        if (HWY_UNLIKELY(!hn::AllFalse(df, hn::And(who, rare)))) {
            moveNearCorner<kWide>(i, who, jump);
        } else if (!map.prefetchesEntries) {
            storeWhere(who, nextX, x.n, columns.x.n.data() + i);
            storeWhere(who, nextY, y.n, columns.y.n.data() + i);
        } else {
            // Whole vectors are stored, because a load cannot be forwarded from a masked store.
            const VF nx = hn::IfThenElse(who, nextX, x.n), ny = hn::IfThenElse(who, nextY, y.n);
            hn::Store(nx, df, columns.x.n.data() + i);
            hn::Store(ny, df, columns.y.n.data() + i);
            Slots::template prefetch<1>(map.entries, Slots::template entryIndexOf<kWide>(columns, i, nx, ny));
        }
    }
    // before: the stored values.
    HWY_INLINE static void storeWhere(MF who, VF next, VF before, float* to) {
        const DF df;
#if HWY_TARGET <= HWY_AVX3
        (void)before;
        hn::BlendedStore(next, who, df, to);
#else
        hn::Store(hn::IfThenElse(who, next, before), df, to);
#endif
    }

    // The same for rays that are near a corner or the rim, or leave the map.
    template <bool kWide>
    HWY_NOINLINE void moveNearCorner(std::size_t i, MF who, VF jump) {
        const CellExit at = cellExit(columns_, i);
        const MF near = hn::And(hn::Lt(hn::Abs(hn::Sub(at.x.cross, at.y.cross)), at.tie),
                                hn::Lt(jump, hn::Add(hn::Max(at.x.cross, at.y.cross), at.tie)));
        const MF atRim = hn::Ge(hn::Add(at.first, at.tie), at.rim);
        const MF down = hn::Ge(at.rim, hn::Set(df_, 1.0F));
        MF bad = hn::And(hn::And(who, down), hn::Ge(at.out, hn::Set(df_, 1.0F)));
        if constexpr (kAddress == Address::Border) {
            // The ray is certainly beyond the rim; or float cannot decide whether rim or line comes first.
            const MF far = hn::Gt(hn::Max(at.first, jump), hn::Add(at.rim, at.tie));
            const MF leaving = hn::And(who, hn::AndNot(down, hn::Or(atRim, far)));
            const MF gone = hn::And(leaving, far);
            end(i, gone, LaneEnd::Miss);
            bad = hn::Or(bad, hn::AndNot(gone, leaving));
            who = hn::AndNot(gone, who);
        }
        // The ray passes too close to a corner to decide which neighbour comes first, and the jump does not pass the
        // corner. So both neighbours must be skipped.
        const MF both = hn::And(who, near);
        const MF clear = hn::And(cornerWithinCells(at.tie, hn::Load(df_, columns_.x.inverse.data() + i),
                                                   hn::Load(df_, columns_.y.inverse.data() + i)),
                                 hn::And(sideClear<kWide>(i, at, both, true), sideClear<kWide>(i, at, both, false)));
        bad = hn::And(who, hn::Or(bad, hn::AndNot(clear, both)));
        end(i, bad, LaneEnd::Ambiguous);
        who = hn::AndNot(bad, who);
        const MF moveX = hn::Or(both, hn::Le(at.x.cross, at.y.cross));
        const MF moveY = hn::Or(both, hn::Le(at.y.cross, at.x.cross));
        const VF nx = within(i, who, at.x, frameX_, columns_.x, rays_.x, nextCell(at.x.n, columns_.x, i, moveX, jump));
        // Excludes rays that have ended on the other axis.
        const VI state = hn::Load(di_, columns_.state.data() + i);
        who = hn::And(who, asFloat(hn::Eq(state, hn::Set(di_, kWalking))));
        const VF ny = within(i, who, at.y, frameY_, columns_.y, rays_.y, nextCell(at.y.n, columns_.y, i, moveY, jump));
        hn::Store(nx, df_, columns_.x.n.data() + i);
        hn::Store(ny, df_, columns_.y.n.data() + i);
    }

    // n of the last cell on this axis.
    HWY_INLINE VF lastOf(std::size_t i, const EntryFrame<kAddress>& frame, const WalkAxis& column,
                         const LaneAxisRays& rays) const {
        if constexpr (kAddress != Address::Border) return hn::Load(df_, column.last.data() + i);
        const VI cell = hn::GatherIndex(di_, rays.cell.data(), hn::Load(di_, columns_.slot.data() + i));
        const MF back = hn::Lt(hn::Load(df_, column.stride.data() + i), hn::Zero(df_));
        const VI last = hn::Sub(hn::Set(di_, frame.axis.cells - 1), cell);
        return hn::ConvertTo(df_, hn::IfThenElse(asInt(back), cell, last));
    }

    // The next cell's n within the map. Under repeat the period of the column advances; under border a ray that leaves
    // the map ends.
    HWY_INLINE VF within(std::size_t i, MF who, const Axis& axis, const EntryFrame<kAddress>& frame, WalkAxis& column,
                         const LaneAxisRays& rays, VF next) {
        VF last = lastOf(i, frame, column, rays);
        MF beyond = hn::And(who, hn::Gt(next, last));
        next = hn::IfThenElse(who, next, axis.n);
        if constexpr (kAddress == Address::Repeat) {
            const VF period = hn::Set(df_, static_cast<float>(frame.axis.cells));
            VF back = hn::Zero(df_);
            while (!hn::AllFalse(df_, beyond)) {
                back = hn::IfThenElse(beyond, hn::Add(back, period), back);
                beyond = hn::And(who, hn::Gt(next, hn::Add(last, back)));
            }
            hn::Store(hn::Add(last, back), df_, column.last.data() + i);
            return next;
        }
        if constexpr (kAddress == Address::Border) {
            end(i, beyond, LaneEnd::Miss);
            return hn::IfThenElse(beyond, axis.n, next);
        }
        return hn::IfThenElse(beyond, last, next);
    }

    // Returns the rays that are certainly above the neighbour along one axis until they have passed the corner.
    template <bool kWide>
    HWY_INLINE MF sideClear(std::size_t i, const CellExit& at, MF who, bool alongX) const {
        const EntryFrame<kAddress>& frame = alongX ? frameX_ : frameY_;
        const WalkAxis& column = alongX ? columns_.x : columns_.y;
        const MF beyond = hn::Eq((alongX ? at.x : at.y).n, lastOf(i, frame, column, alongX ? rays_.x : rays_.y));
        const MI backwards = asInt(hn::Lt(hn::Load(df_, column.stride.data() + i), hn::Zero(df_)));
        const VI entries = hn::Set(di_, alongX ? 1 : map_.stride);
        const VI stride = hn::IfThenElse(backwards, hn::Neg(entries), entries);
        VI step = stride;  // there is no step from the last cell; under repeat it leads to the first one
        if constexpr (kAddress == Address::Repeat) {
            const VI back = hn::Mul(stride, hn::Set(di_, 1 - frame.axis.cells));
            step = hn::IfThenElse(asInt(beyond), back, stride);
        }
        const MI there = asInt(kAddress == Address::Repeat ? who : hn::AndNot(beyond, who));
        const VI index = hn::Add(Slots::template entryIndexOf<kWide>(columns_, i, at.x.n, at.y.n), step);
        const VF own = ownOf<Arithmetic>(map_, hn::GatherIndex(di_, map_.entries, hn::IfThenElseZero(there, index)));
        const MF clear = hn::Lt(hn::Add(at.out, hn::Add(at.tie, at.tie)), own);
        if constexpr (kAddress == Address::Clamp) return hn::Or(clear, beyond);
        if constexpr (kAddress == Address::Border) return hn::AndNot(beyond, clear);
        return clear;
    }

    // Leaf tests of all waiting rays: whether the surface is certainly below the ray in a cell whose highest point is
    // not.
    template <bool kWide>
    HWY_NOINLINE void leavesOfAll() {
        const WalkMap map = map_;
        WalkColumns& columns = columns_;
        std::size_t on = 0;
        waiting_ = 0;
        // All indices are computed before the first is used: they are stored as vectors and loaded lane by lane, which
        // stalls soon after the store.
        alignas(64) WalkColumn<std::int32_t> cells;
        for (std::size_t i = 0, end = used_; i < end; i += kLanes) {
            // Only for waiting rays: the data of other rays need not be in the cache.
            const MI who = hn::Eq(hn::Load(di_, columns.state.data() + i), hn::Set(di_, kAtLeaf));
            const VI cell = hn::IfThenElseZero(who, cellNumber<kWide>(map, columns, i));
            hn::Store(cell, di_, cells.data() + i);
            if (kSurface == Surface::Bilinear && map.prefetchesNodes) Slots::template prefetch<2>(scene_.nodes, cell);
        }
        for (std::size_t i = 0, end = used_; i < end; i += kLanes) {
            on += leaves<kWide>(map, columns, i, cells.data() + i);
        }
        walking_ += on;
    }

    // Index of the cell's entry within its quadrant, which is also that of its nodes and of its column's height.
    template <bool kWide>
    HWY_INLINE static VI cellNumber(const WalkMap& map, const WalkColumns& columns, std::size_t i) {
        const DF df;
        const DI di;
        const auto ofQuadrant = [&](const WalkAxis& axis, std::int32_t entries) {
            const MF back = hn::Lt(hn::Load(df, axis.stride.data() + i), hn::Zero(df));
            return hn::IfThenElseZero(asInt(back), hn::Set(di, entries));
        };
        const VI first = hn::Add(ofQuadrant(columns.x, map.quadrant), ofQuadrant(columns.y, 2 * map.quadrant));
        const VF nx = hn::Load(df, columns.x.n.data() + i), ny = hn::Load(df, columns.y.n.data() + i);
        return hn::Sub(Slots::template entryIndexOf<kWide>(columns, i, nx, ny), first);
    }

    // Tests a vector's waiting rays. Returns how many of them walk on.
    template <bool kWide>
    HWY_INLINE std::size_t leaves(const WalkMap& map, WalkColumns& columns, std::size_t i, const std::int32_t* cells) {
        const DF df;
        const DI di;
        const VI state = hn::Load(di, columns.state.data() + i);
        const MI whoI = hn::Eq(state, hn::Set(di, kAtLeaf));
        const MF who = asFloat(whoI);
        const CellExit at = cellExit(columns, i);
        MF below;
        if constexpr (kSurface == Surface::Columns) {
            below = columnBelow(scene_, hn::Load(di, cells), at.out);
        } else {
            const LaneAxisState x = leafAxis(columns.x, i), y = leafAxis(columns.y, i);
            VF in =
                hn::Max(Arithmetic::mulAdd(at.x.n, x.inverse, x.base), Arithmetic::mulAdd(at.y.n, y.inverse, y.base));
            in = hn::Min(hn::Max(hn::Sub(in, at.tie), hn::Zero(df)), at.out);
            const auto h = nodesAt(df, scene_.nodes, cells);
            below = patchBelow<Arithmetic>({h[0], h[2], h[1], h[3]}, x, y, at.x.n, at.y.n, in, at.out, at.tie);
        }
        const MF on = hn::And(below, who);
        const VI after = hn::IfThenElse(asInt(on), hn::Set(di, kWalking), hn::Set(di, kEnded));
        hn::Store(hn::IfThenElse(whoI, after, state), di, columns.state.data() + i);
        moveOn<kWide>(map, columns, i, at.x, at.y, on, at.out);
        return hn::CountTrue(df, on);
    }
    // The axis as the float leaf uses it: relative to the line before the cell.
    HWY_INLINE static LaneAxisState leafAxis(const WalkAxis& from, std::size_t i) {
        const DF df;
        LaneAxisState out;
        out.inverse = hn::Load(df, from.inverse.data() + i);
        out.base = hn::Sub(hn::Load(df, from.base.data() + i), out.inverse);
        out.run = hn::Load(df, from.run.data() + i);
        out.mirrored = hn::Lt(hn::Load(df, from.stride.data() + i), hn::Zero(df));
        return out;
    }

    HWY_INLINE void end(std::size_t i, MF who, LaneEnd how) {
        if (hn::AllFalse(df_, who)) return;
        walking_ -= hn::CountTrue(df_, who);
        const VI state = hn::Load(di_, columns_.state.data() + i);
        hn::Store(hn::IfThenElse(asInt(who), hn::Set(di_, kEnded), state), di_, columns_.state.data() + i);
        noteEnd(rays_, asInt(who), hn::Load(di_, columns_.slot.data() + i), how);
    }
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
