// Packets: a vector of neighbouring rays that walks through packed cones as one thick ray. Compiled for each target.
//
// The rays of a packet run in one quadrant and mostly along one axis, u, the other being v. A packet walks from slice
// to slice: slice U is the row of cells between the lines U and U + 1 of u, counted from the packet's first cell. There
// the rays are between two values of v and above one height, which are linear in U. The slice is clear if the highest
// points of its cells within these bounds are lower; a cone that is clear of all rays leads over several slices.
// Otherwise each ray is tested against the cells, whose heights are read once for all rays. A ray that the tests cannot
// exclude has found its candidate and leaves the packet.
//
// So a packet visits more cells than each of its rays, but it reads each once and nothing is gathered. Its bounds only
// exclude, and so does the test of a ray, with the margins of the single walk for wider packets (kPacketMargin); hence
// the candidates, which double decides, are the same.

#if defined(RELIEF_CONE_PACKETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_PACKETS_INL_H
#undef RELIEF_CONE_PACKETS_INL_H
#else
#define RELIEF_CONE_PACKETS_INL_H
#endif

#include "relief/simd/cone_slots-inl.h"
#include "relief/simd/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

inline constexpr std::size_t kChunkPackets = kLaneChunk / kLanes;
// Cells that the rays of a packet may be apart where they begin, and in v at the same u; v per u of the steepest ray.
inline constexpr float kLongestPacket = 64, kWidestPacket = 1.5F, kSteepestPacket = 1.2F;
// Packets begin at any ray. After this number of packets in a row that are too wide, the next one is searched for ray
// by ray, at most so many times in a chunk.
inline constexpr std::size_t kMostWide = 2, kMostSearches = 3;
// Packets of fewer rays cost more than they save.
inline constexpr std::size_t kLeastPacket = 16;
// Packets that touch more cells of a slice are left to the single walk.
inline constexpr float kMostCells = 8;
// Times 1 + 1 / run: how much later than its rays a packet leaves a slice, in lambda; above the error of positions
// of up to kLongestPacket cells.
inline constexpr float kPacketMargin = 0x1p-15F;
// Cells in v, and per cell in u, by which a packet is wider than its rays.
inline constexpr float kPacketPlace = 0x1p-10F, kPacketSlope = 0x1p-20F;

using PacketColumn = std::array<float, kChunkPackets + kLanes>;

struct PacketRayAxis {
    // The ray crosses line n at (n - ahead) * inverse + base, or slightly before; line `ahead` is the first one.
    alignas(64) std::array<float, kLaneSlots> inverse, base, run, ahead;
};

// A cell of a packet's slice in which its rays are to be tested.
struct CellTest {
    std::uint32_t slot;
    float v;
    bool last;  // of the slice
};
inline constexpr std::size_t kMostTests = static_cast<std::size_t>(kMostCells) * kChunkPackets;

struct PacketColumns {
    PacketRayAxis u, v;
    alignas(64) std::array<float, kLaneSlots> tie;
    alignas(64) std::array<float, kLaneSlots> place, slope, late;
    // Results of rays: LaneEnd, cell, its period.
    alignas(64) std::array<std::int32_t, kLaneSlots> end, cellX, cellY, periodX, periodY;
    // Packets that are walked. Their rays cross line U at lambda latest + U * slowest at the latest, and are then
    // between low + U * lowSlope and high + U * highSlope.
    struct Slots {
        alignas(64) PacketColumn at;  // U
        alignas(64) PacketColumn latest, slowest, low, lowSlope, high, highSlope;
        alignas(64) PacketColumn shorter, originU, originV;
        std::array<std::uint32_t, kChunkPackets + kLanes> packet;

        template <class Body>
        HWY_INLINE void all(const Body& body) {
            body(at), body(latest), body(slowest), body(low), body(lowSlope), body(high), body(highSlope);
            body(shorter), body(originU), body(originV), body(packet);
        }
    } slots;
    // By packet:
    // Bits of the rays that are walked on, of those with the packet's bounds, and of those that have ended.
    std::array<std::uint64_t, kChunkPackets + 1> walking, bounded, ended;
    std::array<std::uint32_t, kChunkPackets + 1> first;  // index in the chunk of the first ray
    std::array<CellTest, kMostTests> tests;
    RayBits left;  // the rays that the single walk has to walk
};

template <Address kAddress, Surface kSurface, class Arithmetic>
class PacketWalk {
  public:
    PacketWalk(const FloatScene& scene, const PackedCones& cones, std::uint32_t quadrant, const double* const* given,
               LaneRays& rays, PacketColumns& columns)
        : scene_(scene), map_(cones, false), given_(given), rays_(rays), columns_(columns) {
        back_[0] = (quadrant & 1U) != 0, back_[1] = (quadrant & 2U) != 0;
        first_ = static_cast<std::int32_t>(quadrant) * map_.quadrant;
        for (int a = 0; a < 2; ++a) {
            const GridAxis& axis = a == 0 ? scene.grid.x : scene.grid.y;
            const std::int32_t stride = a == 0 ? 1 : map_.stride;
            cells_[a] = static_cast<float>(axis.cells);
            count_[a] = axis.cells;
            stride_[a] = back_[a] ? -stride : stride;
            if (back_[a]) first_ += (axis.cells - 1) * stride;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t u = k & 1U, v = k >> 1U, x = back_[0] ? 1 : 0, y = back_[1] ? 1 : 0;
            corners_[0][k] = 2 * (u ^ x) + (v ^ y);
            corners_[1][k] = 2 * (v ^ x) + (u ^ y);
        }
    }

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
    // Number of rays that the single walk does not have to walk.
    std::size_t taken() const { return taken_; }

    // Stores the results of the rays that ended in packets.
    void keep() {
        const DI di;
        for (std::size_t p = 0; p < formed_; ++p) {
            const MI who = maskOf(columns_.ended[p]);
            const auto put = [&](const auto& from, auto& to) {
                hn::BlendedStore(hn::Load(di, from.data() + p * kLanes), who, di, to.data() + columns_.first[p]);
            };
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
    static constexpr std::size_t kHalves = kLanes / kHalfLanes;
    static constexpr std::uint64_t kAll = kLanes == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << kLanes) - 1;

    static MI maskOf(std::uint64_t bits) {
        return hn::LoadMaskBits(DI(), reinterpret_cast<const std::uint8_t*>(&bits));
    }
    static std::uint64_t bitsOf(MF mask) {
        std::uint64_t bits = 0;
        hn::StoreMaskBits(DF(), mask, reinterpret_cast<std::uint8_t*>(&bits));
        return bits;
    }

    // Forms packets of the chunk's rays.
    void form() {
        std::size_t wide = 0, searches = 0;
        for (std::size_t from = 0; from + kLanes <= rays_.count;) {
            const Fit fit = setUp(from);
            if (fit == Fit::Never) return;
            from += kLanes;
            wide = fit == Fit::Narrow ? 0 : wide + 1;
            if (wide < kMostWide) continue;
            if (++searches > kMostSearches) return;
            std::size_t best = 0;
            float least = kWidestPacket;
            for (std::size_t n = 1; n < kLanes && from + n + kLanes <= rays_.count; ++n) {
                Entry axes[2];
                if (!entry(0, from + n, axes[0]) || !entry(1, from + n, axes[1])) continue;
                const VF place = placeOf(axes);
                if (const float width = most(place) - lowest(place); width < least) least = width, best = n;
            }
            from += best;
            wide = 0;
        }
    }

    // Fills the slot with the last one.
    HWY_INLINE void remove(std::size_t n) {
        --used_;
        columns_.slots.all([&](auto& column) { column[n] = column[used_]; });
    }

    // One axis of a packet's rays.
    struct Entry {
        VF cell, share, run, inverse;  // cell from the packet's origin
        double origin;
    };
    HWY_INLINE bool entry(int a, std::size_t from, Entry& out) const {
        const DD d;
        const DHF dhf;
        const GridAxis& axis = a == 0 ? scene_.grid.x : scene_.grid.y;
        const bool border = kAddress == Address::Border;
        const double end = kAddress == Address::Repeat ? axis.texels + axis.shift : axis.cells;
        const double lowEnd = border ? axis.low : 0, highEnd = border ? axis.high : end;
        MD usual = hn::FirstN(d, kHalfLanes);
        std::array<VD, kHalves> at;
        std::array<hn::Vec<DHF>, kHalves> run, cell, share;
        VD least = hn::Inf(d);
        for (std::size_t h = 0; h < kHalves; ++h) {
            const VD signedRun = hn::LoadU(d, given_[2 + a] + from + h * kHalfLanes);
            const VD absRun = hn::Abs(signedRun);
            const VD start = hn::Add(hn::LoadU(d, given_[a] + from + h * kHalfLanes), hn::Set(d, axis.shift));
            const VD along = hn::Add(start, hn::Mul(hn::Set(d, scene_.start), signedRun));
            usual =
                hn::And(usual, hn::And(hn::Gt(absRun, hn::Set(d, kLeastRun)), hn::Lt(absRun, hn::Set(d, kFloatRun))));
            usual = hn::And(usual, hn::And(hn::Gt(hn::Min(start, along), hn::Set(d, lowEnd)),
                                           hn::Lt(hn::Max(start, along), hn::Set(d, highEnd))));
            at[h] = back_[a] ? hn::Sub(hn::Set(d, axis.cells), along) : along;
            least = hn::Min(least, at[h]);
            run[h] = hn::DemoteTo(dhf, absRun);
        }
        if (!hn::AllTrue(d, usual)) return false;
        out.origin = std::floor(hn::GetLane(hn::MinOfLanes(d, least)));
        for (std::size_t h = 0; h < kHalves; ++h) {
            const VD whole = hn::Floor(at[h]);
            cell[h] = hn::DemoteTo(dhf, hn::Sub(whole, hn::Set(d, out.origin)));
            share[h] = hn::DemoteTo(dhf, hn::Sub(at[h], whole));
        }
#if HWY_TARGET == HWY_SCALAR
        out.cell = cell[0], out.share = share[0], out.run = run[0];
#else
        out.cell = hn::Combine(DF(), cell[1], cell[0]);
        out.share = hn::Combine(DF(), share[1], share[0]);
        out.run = hn::Combine(DF(), run[1], run[0]);
#endif
        out.inverse = hn::Div(hn::Set(DF(), 1.0F), out.run);
        return hn::AllTrue(DF(), hn::Lt(out.cell, hn::Set(DF(), kLongestPacket)));
    }

    static float lowest(VF v) {
        return hn::GetLane(hn::MinOfLanes(DF(), v));
    }
    static float most(VF v) {
        return hn::GetLane(hn::MaxOfLanes(DF(), v));
    }

    HWY_INLINE void prefetchRays(std::size_t from) const {
        if (from + kRaysAhead + kLanes > rays_.count + rays_.behind) return;
        for (std::size_t c = 0; c < 4; ++c) {
            for (std::size_t i = 0; i < kLanes; i += kLineOfDoubles) {
                __builtin_prefetch(given_[c] + from + kRaysAhead + i, 0, 2);
            }
        }
    }

    // v of the rays at U = 0.
    HWY_INLINE VF placeOf(const Entry* axes) const {
        const Entry &u = axes[u_], &v = axes[v_];
        return Arithmetic::negMulAdd(hn::Add(u.cell, u.share), hn::Mul(v.run, u.inverse), hn::Add(v.cell, v.share));
    }

    // Never: neighbouring rays are so far apart that no packet of the chunk will be narrow.
    enum class Fit : std::uint8_t { Narrow, Wide, Never };

    // Takes the rays from `from` on as a packet if they are close enough.
    HWY_INLINE Fit setUp(std::size_t from) {
        const DF df;
        PacketColumns& c = columns_;
        PacketColumns::Slots& slots = c.slots;
        prefetchRays(from);
        Entry axes[2];
        if (!entry(0, from, axes[0]) || !entry(1, from, axes[1])) return Fit::Wide;
        // All packets of a chunk have the axis of the first.
        if (formed_ == 0) u_ = hn::GetLane(axes[1].run) > hn::GetLane(axes[0].run) ? 1 : 0, v_ = 1 - u_;
        const Entry &u = axes[u_], &v = axes[v_];
        const VF slope = hn::Mul(v.run, u.inverse), atU = hn::Add(u.cell, u.share), place = placeOf(axes);
        if (!(most(place) - lowest(place) < kWidestPacket)) {
            HWY_ALIGN float places[2 * kLanes];
            hn::Store(place, df, places);
            hn::Store(hn::Set(df, 1e30F), df, places + kLanes);
            // A square of 16 rays has three such distances to a side.
            const VF apart = hn::Abs(hn::Sub(hn::LoadU(df, places + 1), place));
            return 3 * lowest(apart) < kWidestPacket ? Fit::Wide : Fit::Never;
        }
        if (!(most(slope) < kSteepestPacket - kPacketSlope)) return Fit::Wide;
        const std::size_t p = formed_, i = p * kLanes;
        const VF start = hn::Set(df, static_cast<float>(scene_.start)), one = hn::Set(df, 1.0F);
        VF margins = hn::Zero(df);
        const auto keepAxis = [&](const Entry& from, PacketRayAxis& to) {
            const VF margin = hn::Mul(hn::Set(df, kCrossingMargin), hn::Add(from.inverse, one));
            margins = hn::Add(margins, margin);
            hn::Store(from.inverse, df, to.inverse.data() + i);
            hn::Store(Arithmetic::mulAdd(hn::Sub(one, from.share), from.inverse, hn::Add(start, margin)), df,
                      to.base.data() + i);
            hn::Store(from.run, df, to.run.data() + i);
            hn::Store(hn::Add(from.cell, one), df, to.ahead.data() + i);
        };
        keepAxis(u, c.u);
        keepAxis(v, c.v);
        hn::Store(hn::Add(margins, margins), df, c.tie.data() + i);
        hn::Store(place, df, c.place.data() + i);
        hn::Store(slope, df, c.slope.data() + i);
        const VF late = hn::Mul(hn::Set(df, kPacketMargin), hn::Add(u.inverse, one));
        hn::Store(Arithmetic::negMulAdd(atU, u.inverse, hn::Add(start, late)), df, c.late.data() + i);
        slots.packet[used_] = static_cast<std::uint32_t>(p);
        bound(used_, hn::FirstN(df, kLanes));
        slots.at[used_] = 0;
        slots.shorter[used_] = 2 * kShorterJump * most(u.run) + 0x1p-8F;
        slots.originU[used_] = static_cast<float>(u.origin), slots.originV[used_] = static_cast<float>(v.origin);
        c.first[p] = static_cast<std::uint32_t>(from);
        c.walking[p] = c.bounded[p] = kAll, c.ended[p] = 0;
        mark(from, kAll, false);
        taken_ += kLanes;
        ++formed_, ++used_;
        return Fit::Narrow;
    }
    // Marks some rays from the given one on as left to the single walk, or not.
    HWY_INLINE void mark(std::size_t from, std::uint64_t who, bool left) {
        const std::size_t word = from / 64, bit = from % 64;
        const auto set = [&](std::uint64_t& to, std::uint64_t bits) { to = left ? to | bits : to & ~bits; };
        set(columns_.left[word], who << bit);
        if (bit + kLanes > 64) set(columns_.left[word + 1], who >> (64 - bit));
    }

    // The bounds of some of a packet's rays.
    HWY_INLINE void bound(std::size_t n, MF who) {
        const DF df;
        PacketColumns& c = columns_;
        PacketColumns::Slots& slots = c.slots;
        const std::size_t i = slots.packet[n] * kLanes;
        const auto load = [&](const std::array<float, kLaneSlots>& from) { return hn::Load(df, from.data() + i); };
        const VF far = hn::Set(df, 1e30F);
        const auto low = [&](VF x) { return lowest(hn::IfThenElse(who, x, far)); };
        const auto high = [&](VF x) { return most(hn::IfThenElse(who, x, hn::Neg(far))); };
        const VF place = load(c.place), slope = load(c.slope);
        slots.latest[n] = high(load(c.late));
        slots.slowest[n] = high(load(c.u.inverse));
        slots.low[n] = low(place) - kPacketPlace, slots.high[n] = high(place) + kPacketPlace;
        slots.lowSlope[n] = std::max(low(slope) - kPacketSlope, 0.0F);
        slots.highSlope[n] = high(slope) + kPacketSlope;
    }

    // Cells of one axis, counted in the direction of the rays, within the map.
    HWY_INLINE static VF wrapped(VF cell, VF cells) {
        return hn::Sub(cell, hn::Mul(hn::Floor(hn::Div(cell, cells)), cells));
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
        const VF cellsU = hn::Set(df, cells_[u_]), cellsV = hn::Set(df, cells_[v_]);
        VF cu = hn::Add(load(slots.originU), at), cv = hn::Add(originV, v);
        MF stop;
        if constexpr (kAddress == Address::Repeat) {
            cu = wrapped(cu, cellsU), cv = wrapped(cv, cellsV);
            // All rays end before.
            stop = hn::Gt(at, hn::Set(df, static_cast<float>(2 * kFloatRun)));
        } else {
            const VF lastU = hn::Sub(cellsU, one), lastV = hn::Sub(cellsV, one);
            cv = hn::Max(cv, zero);
            v = hn::Sub(cv, originV);
            // Under clamp the outermost cells have no end.
            stop = kAddress == Address::Border ? hn::Or(hn::Gt(cu, lastU), hn::Gt(cv, lastV))
                                               : hn::Or(hn::Ge(cu, lastU), hn::Ge(hn::Add(originV, vTop), lastV));
            cu = hn::Min(cu, lastU), cv = hn::Min(cv, lastV);
        }
        stop = hn::And(stop, on);
        if (HWY_UNLIKELY(!hn::AllFalse(df, stop))) {
            forEach(bitsOf(stop),
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
        const VF free = Arithmetic::negMulAdd(kappa, gap, hn::Sub(apexOf(entry), out));
        const VF widening = hn::Mul(kappa, hn::Max(highSlope, one));
        const VF steepness = hn::Mul(hn::Add(widening, slowest), hn::Set(df, kSteeper));
        const VF jump = Arithmetic::mulSub(free, Arithmetic::reciprocal(steepness), load(slots.shorter));
        const MF leads = hn::Ge(jump, zero);
        const VF to = hn::IfThenElse(leads, hn::Add(next, hn::Floor(jump)), next);
        // The cells that are not lower than all rays.
        const VF more = hn::Sub(vTop, v);
        const MF doubtful = hn::AndNot(leads, on), several = hn::And(doubtful, hn::Ge(more, one));
        const MF test0 = hn::AndNot(hn::Lt(out, ownOf(entry)), doubtful);
        const auto higher = [&](MF who, VF cell) {
            if (hn::AllFalse(df, who)) return who;
            cell = kAddress == Address::Repeat ? wrapped(cell, cellsV) : hn::Min(cell, hn::Sub(cellsV, one));
            const VI index = hn::IfThenElseZero(asInt(who), hn::Add(row, indexOf(cell, v_)));
            return hn::AndNot(hn::Lt(out, ownOf(hn::GatherIndex(di, map_.entries, index))), who);
        };
        const MF test1 = higher(several, hn::Add(cv, one));
        const VF two = hn::Set(df, 2.0F);
        const MF test2 = higher(hn::And(several, hn::Ge(more, two)), hn::Add(cv, two));
        const MF test = hn::Or(hn::Or(test0, test1), hn::Or(test2, hn::And(several, hn::Gt(more, two))));
        hn::Store(hn::IfThenElse(hn::AndNot(test, on), to, at), df, slots.at.data() + g);
        if (!hn::AllFalse(df, test))
            note(g, test, {bitsOf(test0), bitsOf(test1), bitsOf(test2)}, v,
                 kAddress == Address::Repeat ? vTop : hn::Min(vTop, hn::Sub(hn::Sub(cellsV, one), originV)));
    }
    HWY_INLINE void note(std::size_t g, MF test, std::array<std::uint64_t, 3> cells, VF v, VF vTop) {
        const DF df;
        PacketColumns& c = columns_;
        HWY_ALIGN float low[kLanes], high[kLanes];
        hn::Store(v, df, low);
        hn::Store(vTop, df, high);
        forEach(bitsOf(test), [&](std::size_t k) {
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

    template <class Body>
    HWY_INLINE static void forEach(std::uint64_t bits, const Body& body) {
        for (; bits != 0; bits &= bits - 1) body(static_cast<std::size_t>(__builtin_ctzll(bits)));
    }

    HWY_INLINE VF ownOf(VI entry) const {
        const DF df;
        const VI bits = hn::And(entry, hn::Set(DI(), static_cast<std::int32_t>(kConeDepths)));
        return Arithmetic::mulAdd(hn::ConvertTo(df, bits), hn::Set(df, map_.unit), hn::Set(df, map_.top));
    }
    HWY_INLINE VF apexOf(VI entry) const {
        const DF df;
        const DI di;
        const VI bits =
            hn::OrAnd(hn::Set(di, kApexBits), entry, hn::Set(di, static_cast<std::int32_t>(kConeDepths << 10)));
        return Arithmetic::mulAdd(hn::BitCast(df, bits), hn::Set(df, map_.unit), hn::Set(df, map_.topOfApex));
    }

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
    // Leaves the rays still walked to the single walk.
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

    const FloatScene& scene_;
    WalkMap map_;
    const double* const* given_;
    LaneRays& rays_;
    PacketColumns& columns_;
    bool back_[2];
    float cells_[2];
    std::int32_t count_[2];
    std::size_t corners_[2][4];  // of a cell's nodes, those at (0, 0), (1, 0), (0, 1), (1, 1) in u and v; if swapped
    std::size_t tests_ = 0, used_ = 0, formed_ = 0, taken_ = 0;  // numbers of tests, slots, packets, rays
    std::size_t u_ = 0, v_ = 1;                                  // axes: 0 for x, 1 for y
    std::int32_t stride_[2];  // entries to the next cell in the direction of the rays
    std::int32_t first_;      // index of the entry from which they count
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
