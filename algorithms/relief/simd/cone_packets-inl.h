// Packets: neighbouring rays, one vector of them, that walk through packed cones as one thick ray. Compiled for each
// target; used where vectors have kLeastPacket lanes.
//
// The rays of a packet are in one quadrant. u is the axis along which they mostly run, v the other. A packet walks from
// slice to slice: slice U is the row of cells between the lines U and U + 1 of u, counted from the packet's first cell.
// In it the rays are between two values of v and above one height, both linear in U. The slice is clear if its cells
// between these bounds are lower; a cone that is clear of all rays leads over several slices. Otherwise each ray is
// tested against each cell that is not lower, whose heights are read once for all rays. A ray that the test cannot
// exclude leaves the packet with this cell as its candidate.
//
// So a packet visits more cells than each of its rays, but gathers none. Its bounds only exclude cells, as the single
// walk does, and it visits the cells of each ray in their order. Hence the first candidate that the leaf accepts is the
// ray's hit.

#if defined(RELIEF_CONE_PACKETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_PACKETS_INL_H
#undef RELIEF_CONE_PACKETS_INL_H
#else
#define RELIEF_CONE_PACKETS_INL_H
#endif

#include "relief/simd/cone_packet_slots-inl.h"
#include "relief/simd/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

template <Address kAddress, Surface kSurface, class Arithmetic>
class PacketWalk : PacketSlots<kAddress, Arithmetic> {
    using Slots = PacketSlots<kAddress, Arithmetic>;
    using Slots::back_;
    using Slots::bitsOf;
    using Slots::bound;
    using Slots::cells_;
    using Slots::columns_;
    using Slots::corners_;
    using Slots::count_;
    using Slots::first_;
    using Slots::form;
    using Slots::formed_;
    using Slots::map_;
    using Slots::mark;
    using Slots::maskOf;
    using Slots::rays_;
    using Slots::remove;
    using Slots::scene_;
    using Slots::stride_;
    using Slots::taken_;
    using Slots::tests_;
    using Slots::u_;
    using Slots::used_;
    using Slots::v_;

  public:
    using Slots::Slots;
    using Slots::taken;

    void run() {
        PacketColumns& c = columns_;
        c.left.fill(~std::uint64_t{0});
        form();
        while (used_ > 0) {
            c.slots.all(
                [&](auto& column) { std::fill_n(column.begin() + static_cast<std::ptrdiff_t>(used_), kLanes, 0); });
            tests_ = 0;
            for (std::size_t g = 0; g < used_; g += kLanes) step(g);
            for (std::size_t n = 0; n < tests_; ++n) testCell(c.tests[n]);
            for (std::size_t n = 0; n < tests_; ++n) {
                if (c.tests[n].last) moveOn(c.tests[n].slot);
            }
            for (std::size_t n = used_; n-- > 0;) {
                if (c.walking[c.slots.packet[n]] == 0) remove(n);
            }
        }
    }
    // Stores the results of the rays that ended in packets.
    void keep() {
        const DI di;
        for (std::size_t p = 0; p < formed_; ++p) {
            const MI who = maskOf(columns_.ended[p]);
            const auto put = [&](const auto& from, auto& to) {
                hn::BlendedStore(hn::Load(di, from.data() + p * kLanes), who, di, to.data() + columns_.first[p]);
            };
            if constexpr (Arithmetic::kRecords) Arithmetic::leavePacket(columns_, p, kAddress == Address::Repeat);
            put(columns_.end, rays_.end);
            put(columns_.cellX, rays_.x.hitCell);
            put(columns_.cellY, rays_.y.hitCell);
            if constexpr (kAddress == Address::Repeat) {
                put(columns_.periodX, rays_.x.hitPeriod);
                put(columns_.periodY, rays_.y.hitPeriod);
            }
        }
    }

  private:
    // Returns cells of one axis, counted in the direction of the rays, reduced to the first period.
    HWY_INLINE static VF wrapped(VF cell, VF cells) {
        return hn::Sub(cell, hn::Mul(hn::Floor(hn::Div(cell, cells)), cells));
    }

    // Brings the first cell (cu, cv) of each packet's slice into the map; v is moved as cv is. at: number of the slice.
    // vTop: the last cell, like v from originV. Returns the packets that end here: under border their rays have left
    // the map; otherwise the single walk takes them over.
    HWY_INLINE MF address(VF& cu, VF& cv, VF& v, VF at, VF originV, VF vTop) const {
        const DF df;
        const VF cellsU = hn::Set(df, cells_[u_]), cellsV = hn::Set(df, cells_[v_]);
        if constexpr (kAddress == Address::Repeat) {
            cu = wrapped(cu, cellsU), cv = wrapped(cv, cellsV);
            // All rays end before, at the latest at the bottom of the slab.
            return hn::Gt(at, hn::Set(df, static_cast<float>(2 * kFloatRun)));
        } else {
            const VF one = hn::Set(df, 1.0F), lastU = hn::Sub(cellsU, one), lastV = hn::Sub(cellsV, one);
            cv = hn::Max(cv, hn::Zero(df));
            v = hn::Sub(cv, originV);
            // Under clamp the outermost cells have no end.
            const MF stop = kAddress == Address::Border
                                ? hn::Or(hn::Gt(cu, lastU), hn::Gt(cv, lastV))
                                : hn::Or(hn::Ge(cu, lastU), hn::Ge(hn::Add(originV, vTop), lastV));
            cu = hn::Min(cu, lastU), cv = hn::Min(cv, lastV);
            return stop;
        }
    }

    // A step of the packets in the slots from g on. Notes the cells in which rays must be tested.
    HWY_INLINE void step(std::size_t g) {
        const DF df;
        const DI di;
        PacketColumns::Slots& slots = columns_.slots;
        const auto load = [&](const PacketColumn& from) { return hn::Load(df, from.data() + g); };
        MF on = hn::FirstN(df, std::min(kLanes, used_ - g));
        const VF one = hn::Set(df, 1.0F), zero = hn::Zero(df);
        const VF at = load(slots.at), next = hn::Add(at, one), slowest = load(slots.slowest);
        const VF out = Arithmetic::mulAdd(next, slowest, load(slots.latest));
        const VF originV = load(slots.originV), highSlope = load(slots.highSlope);
        VF v = hn::Floor(Arithmetic::mulAdd(at, load(slots.lowSlope), load(slots.low)));
        const VF highV = Arithmetic::mulAdd(next, highSlope, load(slots.high));
        const VF vTop = hn::Floor(highV);
        const VF cellsV = hn::Set(df, cells_[v_]);
        VF cu = hn::Add(load(slots.originU), at), cv = hn::Add(originV, v);
        const MF stop = hn::And(address(cu, cv, v, at, originV, vTop), on);
        if (HWY_UNLIKELY(!hn::AllFalse(df, stop))) {
            overLanes(bitsOf(stop),
                      [&](std::size_t k) { kAddress == Address::Border ? miss(slots.packet[g + k]) : handOn(g + k); });
            on = hn::AndNot(stop, on);
        }
        const auto indexOf = [&](VF along, std::size_t a) {
            return hn::Mul(hn::ConvertTo(di, along), hn::Set(di, stride_[a]));
        };
        const VI row = hn::Add(indexOf(cu, u_), hn::Set(di, first_));
        const VI entry = hn::GatherIndex(di, map_.entries, hn::Add(row, indexOf(cv, v_)));
        const VF kappa = hn::BitCast(df, entry);
        const VF gap = hn::Max(hn::Sub(highV, hn::Add(v, one)), zero);
        const VF free = Arithmetic::negMulAdd(kappa, gap, hn::Sub(apexOf<Arithmetic>(map_, entry), out));
        const VF widening = hn::Mul(kappa, hn::Max(highSlope, one));
        const VF steepness = hn::Mul(hn::Add(widening, slowest), hn::Set(df, kSteeper));
        const VF jump = Arithmetic::mulSub(free, Arithmetic::reciprocal(steepness), load(slots.shorter));
        const MF leads = hn::Ge(jump, zero);
        const VF to = hn::IfThenElse(leads, hn::Add(next, hn::Floor(jump)), next);
        // The cells that are not lower than all rays.
        const VF more = hn::Sub(vTop, v);
        const MF doubtful = hn::AndNot(leads, on), several = hn::And(doubtful, hn::Ge(more, one));
        const MF test0 = hn::AndNot(hn::Lt(out, ownOf<Arithmetic>(map_, entry)), doubtful);
        const auto higher = [&](MF who, VF cell) {
            if (hn::AllFalse(df, who)) return who;
            cell = kAddress == Address::Repeat ? wrapped(cell, cellsV) : hn::Min(cell, hn::Sub(cellsV, one));
            const VI index = hn::IfThenElseZero(asInt(who), hn::Add(row, indexOf(cell, v_)));
            return hn::AndNot(hn::Lt(out, ownOf<Arithmetic>(map_, hn::GatherIndex(di, map_.entries, index))), who);
        };
        const MF test1 = higher(several, hn::Add(cv, one));
        const VF two = hn::Set(df, 2.0F);
        const MF test2 = higher(hn::And(several, hn::Ge(more, two)), hn::Add(cv, two));
        const MF test = hn::Or(hn::Or(test0, test1), hn::Or(test2, hn::And(several, hn::Gt(more, two))));
        hn::Store(hn::IfThenElse(hn::AndNot(test, on), to, at), df, slots.at.data() + g);
        if (hn::AllFalse(df, test)) return;
        note(g, test, {bitsOf(test0), bitsOf(test1), bitsOf(test2)}, v,
             kAddress == Address::Repeat ? vTop : hn::Min(vTop, hn::Sub(hn::Sub(cellsV, one), originV)));
    }
    // Lists the cells in which rays must be tested. cells: the packets for which the first, the second and the third
    // cell of the slice must be; later cells, up to vTop, always must be.
    HWY_INLINE void note(std::size_t g, MF test, std::array<std::uint64_t, 3> cells, VF v, VF vTop) {
        const DF df;
        PacketColumns& c = columns_;
        HWY_ALIGN float low[kLanes], high[kLanes];
        hn::Store(v, df, low);
        hn::Store(vTop, df, high);
        overLanes(bitsOf(test), [&](std::size_t k) {
            const auto slot = static_cast<std::uint32_t>(g + k);
            if (high[k] - low[k] >= kMostCells) return handOn(slot);
            const std::size_t before = tests_;
            const auto add = [&](float n) { c.tests[tests_++] = {slot, n, false}; };
            float n = low[k];
            for (const std::uint64_t bits : cells) {
                if ((bits >> k & 1U) != 0 && n <= high[k]) add(n);
                n += 1;
            }
            for (; n <= high[k]; n += 1) add(n);
            if (tests_ == before) {
                c.slots.at[slot] += 1;
            } else {
                c.tests[tests_ - 1].last = true;
            }
        });
    }

    // Ends the rays still walked as misses.
    void miss(std::size_t p) {
        const DI di;
        const MI who = maskOf(columns_.walking[p]);
        hn::BlendedStore(hn::Set(di, static_cast<std::int32_t>(LaneEnd::Miss)), who, di,
                         columns_.end.data() + p * kLanes);
        // A valid cell, since the heights of all rays' cells are fetched.
        hn::BlendedStore(hn::Zero(di), who, di, columns_.cellX.data() + p * kLanes);
        hn::BlendedStore(hn::Zero(di), who, di, columns_.cellY.data() + p * kLanes);
        columns_.ended[p] |= columns_.walking[p];
        columns_.walking[p] = 0;
    }
    // Hands the rays still walked over to the single walk.
    void handOn(std::size_t n) {
        PacketColumns& c = columns_;
        const std::size_t p = c.slots.packet[n];
        mark(c.first[p], c.walking[p], true);
        taken_ -= static_cast<std::size_t>(__builtin_popcountll(c.walking[p]));
        c.walking[p] = 0;
    }

    // Tests the rays of a packet against a cell of its slice.
    HWY_INLINE void testCell(const CellTest& test) {
        const DF df;
        const DI di;
        PacketColumns& c = columns_;
        const std::size_t n = test.slot, p = c.slots.packet[n], i = p * kLanes;
        const VF one = hn::Set(df, 1.0F), zero = hn::Zero(df);
        const auto load = [&](const std::array<float, kLaneSlots>& from) { return hn::Load(df, from.data() + i); };
        const VF tie = load(c.tie);
        const auto axis = [&](const PacketRayAxis& from) {
            LaneAxisState out;
            out.inverse = load(from.inverse), out.base = load(from.base), out.run = load(from.run);
            return out;
        };
        const LaneAxisState u = axis(c.u), v = axis(c.v);
        const VF nU = hn::Sub(hn::Set(df, c.slots.at[n]), load(c.u.ahead)),
                 nV = hn::Sub(hn::Set(df, test.v), load(c.v.ahead));
        const auto line = [&](const LaneAxisState& of, VF n) { return Arithmetic::mulAdd(n, of.inverse, of.base); };
        const VF in = hn::Max(line(u, nU), line(v, nV));
        const VF out = hn::Min(hn::Min(line(u, hn::Add(nU, one)), line(v, hn::Add(nV, one))), one);
        const VF early = hn::Max(hn::Sub(in, tie), zero);
        const Place placeU = placeOf(u_, c.slots.originU[n] + c.slots.at[n]);
        const Place placeV = placeOf(v_, c.slots.originV[n] + test.v);
        const Place &x = u_ == 0 ? placeU : placeV, &y = u_ == 0 ? placeV : placeU;
        const std::size_t cell =
            static_cast<std::size_t>(y.cell) * static_cast<std::size_t>(map_.stride) + static_cast<std::size_t>(x.cell);
        MF below;
        if constexpr (kSurface == Surface::Columns) {
            below = hn::Lt(hn::Set(df, scene_.heights[cell]), hn::Sub(one, out));
        } else {
            const float* h = scene_.nodes + 2 * cell;
            const auto& corner = corners_[u_];
            const Patch patch{hn::Set(df, h[corner[0]]), hn::Set(df, h[corner[1]]), hn::Set(df, h[corner[2]]),
                              hn::Set(df, h[corner[3]])};
            below = patchBelow<Arithmetic, true>(patch, u, v, nU, nV, hn::Min(early, out), out, tie);
        }
        const MF found = hn::And(asFloat(maskOf(c.walking[p])), hn::AndNot(below, hn::Le(early, out)));
        // Float cannot decide whether a ray enters the cell if it is in it for less than the margins.
        const MF unsure = hn::Le(out, hn::Add(in, tie));
        const VI end = hn::IfThenElseZero(asInt(unsure), hn::Set(di, static_cast<std::int32_t>(LaneEnd::Ambiguous)));
        const MI who = asInt(found);
        hn::BlendedStore(end, who, di, c.end.data() + i);
        hn::BlendedStore(hn::Set(di, x.cell), who, di, c.cellX.data() + i);
        hn::BlendedStore(hn::Set(di, y.cell), who, di, c.cellY.data() + i);
        if constexpr (kAddress == Address::Repeat) {
            hn::BlendedStore(hn::Set(di, x.period), who, di, c.periodX.data() + i);
            hn::BlendedStore(hn::Set(di, y.period), who, di, c.periodY.data() + i);
        }
        c.walking[p] &= ~bitsOf(found);
    }
    // A cell of the map and its period, from the number in the direction of the rays.
    struct Place {
        std::int32_t cell, period;
    };
    HWY_INLINE Place placeOf(std::size_t a, float number) const {
        Place out{static_cast<std::int32_t>(number), 0};
        const std::int32_t cells = count_[a];
        if constexpr (kAddress == Address::Repeat) {
            out.period = (out.cell >= 0 ? out.cell / cells : -((cells - 1 - out.cell) / cells)) * cells;
            out.cell -= out.period;
        }
        if (back_[a]) out.cell = cells - 1 - out.cell, out.period = -out.period;
        return out;
    }

    // Moves a packet to the next slice after tests.
    HWY_INLINE void moveOn(std::size_t n) {
        PacketColumns& c = columns_;
        const std::size_t p = c.slots.packet[n];
        const std::uint64_t walking = c.walking[p];
        c.slots.at[n] += 1;
        if (walking == c.bounded[p]) return;
        c.ended[p] |= c.bounded[p] & ~walking;
        c.bounded[p] = walking;
        if (walking != 0) bound(n, asFloat(maskOf(walking)));
    }
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
