// The packets of the SIMD cone walk (cone_packets-inl.h): which rays form them, and their state, as a structure of
// arrays. Compiled for each target.

#if defined(RELIEF_CONE_PACKET_SLOTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_PACKET_SLOTS_INL_H
#undef RELIEF_CONE_PACKET_SLOTS_INL_H
#else
#define RELIEF_CONE_PACKET_SLOTS_INL_H
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "relief/simd/cone_slots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

inline constexpr std::size_t kChunkPackets = kLaneChunk / kLanes;
// Largest distance, in cells on either axis, between the first cells of a packet's rays.
inline constexpr float kLongestPacket = 64;
// Largest distance between them in v at the same u, in cells; larger on maps that do not fit L2, where the steps of a
// single ray wait for memory.
inline constexpr float kWidestPacket = 0.65F, kWidestOnLargeMaps = 1.1F;
// Largest slope of a packet's rays, in cells of v per cell of u.
inline constexpr float kSteepestPacket = 1.2F;
// Packets may begin at any ray. After kMostWide packets in a row that are too wide, the start of the next one is
// searched for ray by ray, at most kMostSearches times per chunk.
inline constexpr std::size_t kMostWide = 2, kMostSearches = 3;
// Vectors of fewer lanes form no packets, which would cost more than they save.
inline constexpr std::size_t kLeastPacket = 16;
// Largest number of a slice's cells in which a packet tests its rays; beyond it the single walk takes them over.
inline constexpr float kMostCells = 8;
// Times 1 + 1 / run: how much later than its rays a packet leaves a slice, in lambda; covers the rounding of positions
// of up to kLongestPacket cells. These margins: margins.md.
inline constexpr float kPacketMargin = 0x1p-15F;
// Cells in v, and per cell in u, by which a packet is wider than its rays.
inline constexpr float kPacketPlace = 0x1p-10F, kPacketSlope = 0x1p-20F;

using PacketColumn = std::array<float, kChunkPackets + kLanes>;

// Rays on one axis. A ray crosses line n at (n - ahead) * inverse + base, or slightly before; line `ahead` is its
// first.
struct PacketRayAxis {
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
    // v at U = 0; v per U; lambda at U = 0, late by its margin.
    alignas(64) std::array<float, kLaneSlots> place, slope, late;
    // Results of rays: LaneEnd, cell, its period.
    alignas(64) std::array<std::int32_t, kLaneSlots> end, cellX, cellY, periodX, periodY;
    // Packets that are walked. Their rays cross line U at lambda latest + U * slowest at the latest, and are there
    // between low + U * lowSlope and high + U * highSlope in v. `shorter`: slices by which jumps are shortened.
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
    // By packet: bits of the rays that are walked on, of those within its bounds, and of those that have ended.
    std::array<std::uint64_t, kChunkPackets + 1> walking, bounded, ended;
    std::array<std::uint32_t, kChunkPackets + 1> first;  // index in the chunk of the first ray
    std::array<CellTest, kMostTests> tests;
    RayBits left;  // the rays that the single walk has to walk
};

// Forms packets of the rays of a chunk that run in one quadrant.
template <Address kAddress, class Arithmetic>
class PacketSlots {
  public:
    PacketSlots(const FloatScene& scene, const PackedCones& cones, std::uint32_t quadrant, const double* const* given,
                LaneRays& rays, PacketColumns& columns)
        : scene_(scene),
          map_(cones, false),
          frames_{EntryFrame<kAddress>(scene.grid.x), EntryFrame<kAddress>(scene.grid.y)},
          widest_(map_.prefetchesNodes ? kWidestOnLargeMaps : kWidestPacket),
          given_(given),
          rays_(rays),
          columns_(columns) {
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

    // Number of rays that the single walk does not have to walk.
    std::size_t taken() const { return taken_; }

  protected:
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
            float least = widest_;
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
    // Returns false if one of the rays from `from` on is outside the map or has no usual run, or if they begin too far
    // apart; then `out` must not be used.
    HWY_INLINE bool entry(std::size_t a, std::size_t from, Entry& out) const {
        const DD d;
        const DHF dhf;
        const EntryFrame<kAddress>& frame = frames_[a];
        MD usual = hn::FirstN(d, kHalfLanes);
        std::array<VD, kHalves> at;
        std::array<hn::Vec<DHF>, kHalves> run, cell, share;
        VD least = hn::Inf(d);
        for (std::size_t h = 0; h < kHalves; ++h) {
            const VD signedRun = hn::LoadU(d, given_[2 + a] + from + h * kHalfLanes);
            const VD absRun = hn::Abs(signedRun);
            const VD start = hn::Add(hn::LoadU(d, given_[a] + from + h * kHalfLanes), hn::Set(d, frame.axis.shift));
            const VD along = hn::Add(start, hn::Mul(hn::Set(d, scene_.start), signedRun));
            usual =
                hn::And(usual, hn::And(hn::Gt(absRun, hn::Set(d, kLeastRun)), hn::Lt(absRun, hn::Set(d, kFloatRun))));
            usual = hn::And(usual, hn::And(hn::Gt(hn::Min(start, along), hn::Set(d, frame.low)),
                                           hn::Lt(hn::Max(start, along), hn::Set(d, frame.high))));
            at[h] = back_[a] ? hn::Sub(hn::Set(d, frame.axis.cells), along) : along;
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
        out.cell = joined(DF(), cell[0], cell[1]);
        out.share = joined(DF(), share[0], share[1]);
        out.run = joined(DF(), run[0], run[1]);
        out.inverse = hn::Div(hn::Set(DF(), 1.0F), out.run);
        return hn::AllTrue(DF(), hn::Lt(out.cell, hn::Set(DF(), kLongestPacket)));
    }

    static float lowest(VF v) { return hn::GetLane(hn::MinOfLanes(DF(), v)); }
    static float most(VF v) { return hn::GetLane(hn::MaxOfLanes(DF(), v)); }

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
        prefetchRays(rays_, given_, from);
        Entry axes[2];
        if (!entry(0, from, axes[0]) || !entry(1, from, axes[1])) return Fit::Wide;
        // All packets of a chunk have the axis of the first.
        if (formed_ == 0) u_ = hn::GetLane(axes[1].run) > hn::GetLane(axes[0].run) ? 1 : 0, v_ = 1 - u_;
        const Entry &u = axes[u_], &v = axes[v_];
        const VF slope = hn::Mul(v.run, u.inverse), atU = hn::Add(u.cell, u.share), place = placeOf(axes);
        if (!(most(place) - lowest(place) < widest_)) {
            HWY_ALIGN float places[2 * kLanes];
            hn::Store(place, df, places);
            hn::Store(hn::Set(df, 1e30F), df, places + kLanes);
            // Along a side of a square of 16 rays there are three distances between neighbours.
            const VF apart = hn::Abs(hn::Sub(hn::LoadU(df, places + 1), place));
            return 3 * lowest(apart) < widest_ ? Fit::Wide : Fit::Never;
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

    // Sets whether some of the rays from `from` on are left to the single walk.
    HWY_INLINE void mark(std::size_t from, std::uint64_t who, bool left) {
        const std::size_t word = from / 64, bit = from % 64;
        const auto set = [&](std::uint64_t& to, std::uint64_t bits) { to = left ? to | bits : to & ~bits; };
        set(columns_.left[word], who << bit);
        if (bit + kLanes > 64) set(columns_.left[word + 1], who >> (64 - bit));
    }

    // Sets a packet's bounds to those of some of its rays.
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

    const FloatScene& scene_;
    WalkMap map_;
    EntryFrame<kAddress> frames_[2];
    float widest_;  // kWidestPacket or kWidestOnLargeMaps
    const double* const* given_;
    LaneRays& rays_;
    PacketColumns& columns_;
    bool back_[2];
    float cells_[2];
    std::int32_t count_[2];
    std::size_t corners_[2][4];  // of a cell's nodes, those at (0, 0), (1, 0), (0, 1), (1, 1) in u and v, by u_
    std::size_t tests_ = 0, used_ = 0, formed_ = 0, taken_ = 0;  // numbers of tests, slots, packets, rays
    std::size_t u_ = 0, v_ = 1;                                  // axes: 0 for x, 1 for y
    std::int32_t stride_[2];  // entries to the next cell in the direction of the rays
    std::int32_t first_;      // index of the entry from which they count
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
