// The slots of the SIMD cone walk: the state of each ray in flight, as a structure of arrays. Compiled for each target.

#if defined(RELIEF_CONE_SLOTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_SLOTS_INL_H
#undef RELIEF_CONE_SLOTS_INL_H
#else
#define RELIEF_CONE_SLOTS_INL_H
#endif

#include "relief/maps/packed_cones.h"
#include "relief/simd/lane_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Number of rays in flight.
inline constexpr std::size_t kWalkSlots = 256;
// Map sizes, in entries per quadrant. From kLargeMap on, a quadrant does not fit L2, though the entries fetched by
// neighbouring rays do; from kVeryLargeMap on, neither do those.
inline constexpr std::size_t kLargeMap = 1U << 19U, kVeryLargeMap = 1U << 21U;
inline constexpr auto kWholeBits = std::bit_cast<std::int32_t>(kWhole);
// Prefetch distance of ray data, in rays.
inline constexpr std::size_t kRaysAhead = 2 * kLaneChunk;

// A bit for each ray of a chunk.
using RayBits = std::array<std::uint64_t, kLaneChunk / 64 + 1>;

// A column, padded because vectors are stored from any index on.
template <class T>
using WalkColumn = std::array<T, kWalkSlots + 2 * kLanes>;
struct WalkAxis {
    alignas(64) WalkColumn<float> n;  // cells from the start, an integer
    alignas(64)
        WalkColumn<float> last;  // n of the map's last cell (of the current period under repeat); not under border
    alignas(64) WalkColumn<float> inverse, base;  // the ray leaves the cell at lambda = n * inverse + base
    alignas(64) WalkColumn<float> run;
    // n at lambda is lambda * run - place; half a cell and a margin are subtracted
    alignas(64) WalkColumn<float> place;
    // Entries to the next cell, or to the next row in units of 2^kRowShift entries (WalkMap::wide); negative where the
    // ray runs backwards.
    alignas(64) WalkColumn<float> stride;
};
struct WalkColumns {
    WalkAxis x, y;
    alignas(64) WalkColumn<std::int32_t> first;  // index of a cell's entry is first + offset (WalkSlots::offsetTo)
    alignas(64) WalkColumn<float> steep;         // the longer run, times kSteeper
    alignas(64) WalkColumn<float> rim;  // lambda at which the ray has left the map or reached the bottom of the slab
    alignas(64) WalkColumn<float> tie;
    alignas(64) WalkColumn<std::int32_t> slot;   // index in LaneRays
    alignas(64) WalkColumn<std::int32_t> state;  // one of the constants below

    template <Address kAddress, class Body>
    HWY_INLINE void all(const Body& body) {
        for (WalkAxis* axis : {&x, &y}) {
            body(axis->n), body(axis->inverse), body(axis->base);
            body(axis->run), body(axis->place), body(axis->stride);
            if constexpr (kAddress != Address::Border) body(axis->last);
        }
        body(first), body(steep), body(rim), body(tie), body(slot), body(state);
    }
};
inline constexpr std::int32_t kWalking = 0, kAtLeaf = 1, kEnded = 2;

inline constexpr auto kApexBits = std::bit_cast<std::int32_t>(kApexMore);

// Values that are the same for all rays.
struct WalkMap {
    const std::int32_t* entries = nullptr;  // those of each quadrant in turn
    std::int32_t quadrant = 0;              // entries per quadrant
    std::int32_t stride = 0;                // entries per row
    float unit = 0, top = 0;                // depth value d is at lambda top + d unit
    float topOfApex = 0;                    // top minus kApexMore units, for depths read as the float of kApexBits
    bool prefetchesNodes = false, prefetchesEntries = false;  // before they are needed
    bool wide = false;                                        // offsets count rows in units of 2^kRowShift entries

    WalkMap() = default;
    // scattered: the rays are not those of neighbouring pixels, which find entries in the cache that others have
    // fetched.
    WalkMap(const PackedCones& cones, bool scattered) {
        const std::size_t size = cones.quadrantEntries();
        entries = reinterpret_cast<const std::int32_t*>(cones.entries.data());
        quadrant = static_cast<std::int32_t>(size);
        stride = cones.stride;
        unit = static_cast<float>(cones.unit);
        top = static_cast<float>(1 - cones.highest);
        topOfApex = static_cast<float>(1 - cones.highest - static_cast<double>(kApexMore * unit));
        prefetchesNodes = size >= kLargeMap;
        prefetchesEntries = size >= (scattered ? kLargeMap : kVeryLargeMap);
        wide = size >= kWideEntries;
    }
};

// Lambda at which the ray is as high as the cell's highest point, and as the apex of its cone.
template <class Arithmetic>
HWY_INLINE VF ownOf(const WalkMap& map, VI entry) {
    const DF df;
    const VI bits = hn::And(entry, hn::Set(DI(), static_cast<std::int32_t>(kConeDepths)));
    return Arithmetic::mulAdd(hn::ConvertTo(df, bits), hn::Set(df, map.unit), hn::Set(df, map.top));
}
template <class Arithmetic>
HWY_INLINE VF apexOf(const WalkMap& map, VI entry) {
    const DF df;
    const DI di;
    const VI bits = hn::OrAnd(hn::Set(di, kApexBits), entry, hn::Set(di, static_cast<std::int32_t>(kConeDepths << 10)));
    return Arithmetic::mulAdd(hn::BitCast(df, bits), hn::Set(df, map.unit), hn::Set(df, map.topOfApex));
}

// Constants for setting up rays on one axis.
template <Address kAddress>
struct EntryFrame {
    GridAxis axis;
    double low, high;  // range of positions within the map, or within the first period
    float toRim = 0;   // from the line after the last cell to the edge of the map
    explicit EntryFrame(const GridAxis& of) : axis(of) {
        const bool border = kAddress == Address::Border;
        // Under repeat: the range in which starts need no reduction to the first period, since s lies within the
        // texels.
        const double whole = kAddress == Address::Repeat ? axis.texels + axis.shift : axis.cells;
        low = border ? axis.low : 0;
        high = border ? axis.high : whole;
        toRim = static_cast<float>(border ? axis.high - axis.cells : 0);
    }
};

// Joins two halves of a vector.
template <class D, class Half>
HWY_INLINE hn::Vec<D> joined(D d, Half low, Half high) {
#if HWY_TARGET == HWY_SCALAR
    (void)d, (void)high;
    return low;
#else
    return hn::Combine(d, high, low);
#endif
}

// Prefetches the rays that are taken kRaysAhead after `from`. given: the columns of the chunk. They are read once and
// in order, but column by column and in chunks, which the hardware prefetcher does not predict.
HWY_INLINE void prefetchRays(const LaneRays& rays, const double* const* given, std::size_t from) {
    if (from + kRaysAhead + kLanes > rays.count + rays.behind) return;
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t i = 0; i < kLanes; i += kLineOfDoubles) {
            __builtin_prefetch(given[c] + from + kRaysAhead + i, 0, 2);  // to L2
        }
    }
}

// The slots of the rays that are walked together. Rays are taken in the given order, and slots are compacted when many
// rays have ended.
template <Address kAddress, class Arithmetic>
class WalkSlots {
  public:
    // given: s0, t0, a, b of the chunk's rays. resumes: the rays resume in the cells rays.{x,y}.hitCell or after them
    // (rays.within).
    WalkSlots(const FloatScene& scene, const WalkMap& map, const double* const* given, LaneRays& rays, bool resumes,
              WalkColumns& columns)
        : scene_(scene),
          given_(given),
          rays_(rays),
          columns_(columns),
          map_(map),
          frameX_(scene.grid.x),
          frameY_(scene.grid.y),
          resumes_(resumes),
          end_(rays.count) {}

    // Walks only some of the rays.
    void only(const RayBits& left) { left_ = &left; }

  protected:
    // Starts of rays on one axis: cell of the map; cell before addressing; distance to the next line; absolute value of
    // the run, and whether it is backwards.
    struct Entry {
        VI cell, first;
        VF ahead, run;
        MF back;
    };

    // Bits of a vector of rays.
    HWY_INLINE std::uint64_t leftOf(std::size_t from) const {
        const std::uint64_t bits = (*left_)[from / 64] >> from % 64;
        return kLanes < 64 ? bits & ((std::uint64_t{1} << kLanes) - 1) : bits;
    }

    // Appends new rays to those in flight, in whole vectors as far as there is room. Rays that resume are taken only
    // when all others have ended.
    HWY_INLINE void fill() {
        const std::size_t room = resumes_ && used_ > 0 ? 0 : (kWalkSlots - used_) / kLanes;
        for (std::size_t n = 0; n < room && next_ < end_; next_ = std::min(next_ + kLanes, end_)) {
            if (left_ != nullptr && leftOf(next_) == 0) continue;
            const std::size_t count = std::min(kLanes, end_ - next_);
            take(next_, used_, count);
            used_ += count;
            ++n;
        }
        hn::StoreU(hn::Set(di_, kEnded), di_, columns_.state.data() + used_);
        // The entries of the two vectors beyond the last are fetched, and the state of the first of them.
        const std::size_t behind = hwy::RoundUpTo(used_, kLanes);
        hn::Store(hn::Set(di_, kEnded), di_, columns_.state.data() + behind);
        for (const std::size_t i : {behind, behind + kLanes}) {
            for (WalkAxis* axis : {&columns_.x, &columns_.y}) {
                hn::Store(hn::Zero(df_), df_, axis->n.data() + i);
                hn::Store(hn::Zero(df_), df_, axis->stride.data() + i);
                if constexpr (kAddress != Address::Border) hn::Store(hn::Zero(df_), df_, axis->last.data() + i);
            }
            hn::Store(hn::Set(di_, -kWholeBits), di_, columns_.first.data() + i);
        }
    }

    // Entries from the ray's first cell to the cell (nx, ny), plus kWholeBits. Except under border they count from the
    // map's last cell, because the walk may begin outside the map or continue in the next period.
    template <bool kWide>
    HWY_INLINE static VI offsetTo(const WalkColumns& columns, std::size_t i, VF nx, VF ny) {
        const DF df;
        const DI di;
        const auto cells = [&](VF n, const WalkAxis& axis) {
            return kAddress == Address::Border ? n : hn::Sub(n, hn::LoadU(df, axis.last.data() + i));
        };
        const VF strideX = hn::LoadU(df, columns.x.stride.data() + i);
        const VF strideY = hn::LoadU(df, columns.y.stride.data() + i);
        const VF x = hn::MulAdd(cells(nx, columns.x), strideX, hn::Set(df, kWhole));
        if constexpr (!kWide) return hn::BitCast(di, hn::MulAdd(cells(ny, columns.y), strideY, x));
        const VF y = hn::MulAdd(cells(ny, columns.y), strideY, hn::Set(df, kWhole));
        const VI units = hn::Sub(hn::BitCast(di, y), hn::Set(di, kWholeBits));
        return hn::Add(hn::BitCast(di, x), hn::ShiftLeft<kRowShift>(units));
    }
    // Index of the entry of the cell (nx, ny).
    template <bool kWide>
    HWY_INLINE static VI entryIndexOf(const WalkColumns& columns, std::size_t i, VF nx, VF ny) {
        return hn::Add(hn::Load(DI(), columns.first.data() + i), offsetTo<kWide>(columns, i, nx, ny));
    }

    // Takes the rays [from, from + count) of the chunk into the slots from `to` on.
    HWY_INLINE void take(std::size_t from, std::size_t to, std::size_t count) {
        std::array<std::array<double, kLanes>, 4> rest;
        const double* columns[] = {given_[0] + from, given_[1] + from, given_[2] + from, given_[3] + from};
        if (count < kLanes) {
            for (std::size_t c = 0; c < rest.size(); ++c) {
                std::fill(std::copy_n(columns[c], count, rest[c].begin()), rest[c].end(), columns[c][0]);
                columns[c] = rest[c].data();
            }
        }
        prefetchRays(rays_, given_, from);
        const double begin = rays_.start[from / kLaneGroup];
        MI starting = hn::FirstN(di_, count);
        if (left_ != nullptr) {
            const std::uint64_t bits = leftOf(from);
            starting = hn::And(starting, hn::LoadMaskBits(di_, reinterpret_cast<const std::uint8_t*>(&bits)));
        }
        Entry x, y;
        if (HWY_LIKELY(!resumes_ && entry(frameX_, columns[0], columns[2], begin, x) &&
                       entry(frameY_, columns[1], columns[3], begin, y))) {
            hn::StoreU(hn::Zero(di_), di_, rays_.end.data() + from);
        } else {
            starting = hn::And(starting, generalEntry(from, columns, begin, x, y));
        }
        const VF start = hn::Set(df_, static_cast<float>(begin));
        VF rim = hn::Set(df_, 1.0F);
        const VF margins =
            hn::Add(takeAxis(frameX_, x, start, from, to, 1, columns_.x, rays_.x, rim),
                    takeAxis(frameY_, y, start, from, to, map_.wide ? map_.stride >> kRowShift : map_.stride,
                             columns_.y, rays_.y, rim));
        const auto ofQuadrant = [&](MF back, std::int32_t entries) {
            return hn::IfThenElseZero(asInt(back), hn::Set(di_, entries));
        };
        const VI quadrant = hn::Add(ofQuadrant(x.back, map_.quadrant), ofQuadrant(y.back, 2 * map_.quadrant));
        const VI index = hn::Add(hn::Add(hn::Mul(y.cell, hn::Set(di_, map_.stride)), x.cell), quadrant);
        const VF nx = hn::LoadU(df_, columns_.x.n.data() + to), ny = hn::LoadU(df_, columns_.y.n.data() + to);
        const VI offset = map_.wide ? offsetTo<true>(columns_, to, nx, ny) : offsetTo<false>(columns_, to, nx, ny);
        hn::StoreU(hn::Sub(index, offset), di_, columns_.first.data() + to);
        if (map_.prefetchesEntries) prefetch<1>(map_.entries, index);
        hn::StoreU(hn::Mul(hn::Max(x.run, y.run), hn::Set(df_, kSteeper)), df_, columns_.steep.data() + to);
        hn::StoreU(rim, df_, columns_.rim.data() + to);
        hn::StoreU(hn::Add(margins, margins), df_, columns_.tie.data() + to);
        hn::StoreU(countedFrom(static_cast<std::int32_t>(from)), di_, columns_.slot.data() + to);
        hn::StoreU(hn::IfThenElse(starting, hn::Set(di_, kWalking), hn::Set(di_, kEnded)), di_,
                   columns_.state.data() + to);
        walking_ += hn::CountTrue(di_, starting);
    }

    // Prefetches into L2 only, since on its way into L1 each cache line would occupy one of few fill buffers. kSize:
    // elements per index.
    template <std::size_t kSize, class T>
    HWY_INLINE static void prefetch(const T* memory, VI which) {
        HWY_ALIGN std::int32_t numbers[kLanes];
        hn::Store(which, DI(), numbers);
        for (std::size_t k = 0; k < kLanes; ++k) {
            __builtin_prefetch(memory + kSize * static_cast<std::size_t>(numbers[k]), 0, 2);
        }
    }

    // Faster than Iota(di_, first), which is built lane by lane.
    HWY_INLINE VI countedFrom(std::int32_t first) const { return hn::Add(hn::Iota(di_, 0), hn::Set(di_, first)); }

    // Sets up the starts of rays on one axis for the common case: strictly inside the map, not on a line, a run between
    // kLeastRun and kFloatRun. Returns false if one of the rays is different; then `out` must not be used.
    HWY_INLINE bool entry(const EntryFrame<kAddress>& frame, const double* origins, const double* runs, double begin,
                          Entry& out) const {
        const DD d;
        const DHF df;
        const DHI di;
        MD usual = hn::FirstN(d, kHalfLanes);
        std::array<hn::Vec<DHI>, 2> cell;
        std::array<hn::Vec<DHF>, 2> share, run;
        for (std::size_t h = 0; h < 2; ++h) {
            const std::size_t i = kHalfLanes > 1 ? h * kHalfLanes : 0;
            const VD signedRun = hn::LoadU(d, runs + i);
            const VD absRun = hn::Abs(signedRun);
            const VD at = hn::Add(hn::LoadU(d, origins + i), hn::Set(d, frame.axis.shift));
            // The same bits as in setUpPlaces().
            const VD along = hn::Add(at, hn::Mul(hn::Set(d, begin), signedRun));
            const VD first = hn::Floor(along);
            const VD part = hn::Sub(along, first);
            const MD back = hn::Lt(signedRun, hn::Zero(d));
            const VD behind = hn::IfThenElse(back, hn::Sub(hn::Add(first, hn::Set(d, 1.0)), along), part);
            const MD runs01 = hn::And(hn::Gt(absRun, hn::Set(d, kLeastRun)), hn::Lt(absRun, hn::Set(d, kFloatRun)));
            const MD within = hn::And(hn::Gt(hn::Min(at, along), hn::Set(d, frame.low)),
                                      hn::Lt(hn::Max(at, along), hn::Set(d, frame.high)));
            const MD clear = hn::Gt(part, hn::Zero(d));
            usual = hn::And(usual, hn::And(runs01, hn::And(within, clear)));
            cell[h] = hn::DemoteTo(di, first);
            share[h] = hn::DemoteTo(df, behind);
            run[h] = hn::DemoteTo(df, signedRun);
        }
        out.cell = out.first = joined(di_, cell[0], cell[1]);
        const VF signedRun = joined(df_, run[0], run[1]);
        out.back = hn::Lt(signedRun, hn::Zero(df_));
        out.run = hn::Abs(signedRun);
        out.ahead = hn::Sub(hn::Set(df_, 1.0F), joined(df_, share[0], share[1]));
        return hn::AllTrue(d, usual);
    }
    // The same for any rays. Returns the rays that float can walk, and stores what becomes of the others.
    HWY_NOINLINE MI generalEntry(std::size_t from, const double* const* columns, double begin, Entry& x, Entry& y) {
        const auto column = [&](std::size_t c) { return columns[c] - from; };
        const auto candidate = [&](const LaneAxisRays& rays) { return hn::LoadU(di_, rays.hitCell.data() + from); };
        const VI candidateX = candidate(rays_.x), candidateY = candidate(rays_.y);
        for (std::size_t h = 0; h < kLanes; h += kHalfLanes) {
            setUpRays<kAddress>(scene_, column(0), column(1), column(2), column(3), begin, from + h, rays_);
        }
        const MI fit = hn::Eq(hn::LoadU(di_, rays_.end.data() + from), hn::Zero(di_));
        const auto load = [&](const LaneAxisRays& rays, Entry& out) {
            const VF run = hn::LoadU(df_, rays.run.data() + from);
            out.back = hn::Lt(run, hn::Zero(df_));
            out.run = hn::Abs(run);
            out.ahead = hn::Sub(hn::Set(df_, 1.0F), hn::LoadU(df_, rays.base.data() + from));
            // Rays that are not walked get a valid cell, since entries are fetched for whole vectors.
            const auto turned = [&](const auto& cells) {
                const VI cell = hn::LoadU(di_, cells.data() + from);
                const VI real = hn::IfThenElse(asInt(out.back), hn::Sub(hn::Set(di_, scene_.mirror - 1), cell), cell);
                return hn::IfThenElseZero(fit, real);
            };
            out.cell = turned(rays.cell), out.first = turned(rays.first);
        };
        load(rays_.x, x), load(rays_.y, y);
        if (resumes_) x.cell = hn::IfThenElseZero(fit, candidateX), y.cell = hn::IfThenElseZero(fit, candidateY);
        return fit;
    }

    // n of the cell in which the walk begins: 0, or that of the cell in which it resumes.
    HWY_INLINE VI beginning(const Entry& in, std::size_t from, const LaneAxisRays& rays) const {
        if (kAddress != Address::Clamp && !resumes_) return hn::Zero(di_);
        VI cell = in.cell;
        if (kAddress == Address::Repeat) cell = hn::Add(cell, hn::LoadU(di_, rays.hitPeriod.data() + from));
        const VI forth = hn::Sub(cell, in.first);
        return hn::IfThenElse(asInt(in.back), hn::Neg(forth), forth);
    }

    // Stores one axis of the slots. Returns the margin of its crossings.
    HWY_INLINE VF takeAxis(const EntryFrame<kAddress>& frame, const Entry& in, VF start, std::size_t from,
                           std::size_t to, std::int32_t stride, WalkAxis& out, LaneAxisRays& rays, VF& rim) const {
        const VF one = hn::Set(df_, 1.0F);
        const VF inverse = hn::Div(one, hn::Max(in.run, hn::Set(df_, 1e-30F)));
        const VF margin = hn::Mul(hn::Set(df_, kCrossingMargin), hn::Add(inverse, one));
        const VF base = Arithmetic::mulAdd(in.ahead, inverse, hn::Add(start, margin));
        const VF n = hn::ConvertTo(df_, beginning(in, from, rays));
        const VI last = hn::Set(di_, frame.axis.cells - 1);
        const VF lines = hn::ConvertTo(df_, hn::IfThenElse(asInt(in.back), in.cell, hn::Sub(last, in.cell)));
        const VF lastN = hn::Add(n, lines);
        if constexpr (kAddress == Address::Border) {
            // The rim is a line like others, `toRim` beyond the line after the last cell.
            rim = hn::Min(rim, Arithmetic::mulAdd(hn::Add(lastN, hn::Set(df_, frame.toRim)), inverse, base));
        } else {
            hn::StoreU(lastN, df_, out.last.data() + to);
        }
        hn::StoreU(in.first, di_, rays.cell.data() + from);
        hn::StoreU(n, df_, out.n.data() + to);
        hn::StoreU(inverse, df_, out.inverse.data() + to);
        hn::StoreU(base, df_, out.base.data() + to);
        hn::StoreU(in.run, df_, out.run.data() + to);
        // base belongs to the next line.
        const VF shorter = Arithmetic::mulAdd(in.run, hn::Set(df_, kShorterJump), hn::Set(df_, kShorterJump - 0.5F));
        hn::StoreU(Arithmetic::mulAdd(base, in.run, shorter), df_, out.place.data() + to);
        const VF entries = hn::Set(df_, static_cast<float>(stride));
        hn::StoreU(hn::IfThenElse(in.back, hn::Neg(entries), entries), df_, out.stride.data() + to);
        return margin;
    }

    // Moves the rays in flight to the front, and stores the final positions of those that have ended.
    HWY_INLINE void compact() {
        alignas(64) WalkColumn<std::int32_t> slots, forthX, forthY;
        std::size_t to = 0, ended = 0;
        for (std::size_t i = 0; i < used_; i += kLanes) {
            const MI inUse = hn::FirstN(di_, used_ - i);
            const MI kept = hn::And(inUse, hn::Ne(hn::Load(di_, columns_.state.data() + i), hn::Set(di_, kEnded)));
            const Packing gone(hn::AndNot(kept, inUse));
            const auto note = [&](VI v, WalkColumn<std::int32_t>& column) {
                hn::StoreU(gone(v), di_, column.data() + ended);
            };
            const auto forth = [&](const WalkAxis& axis) {
                const VF back = hn::And(hn::Load(df_, axis.stride.data() + i), hn::SignBit(df_));
                return hn::ConvertTo(di_, hn::Xor(hn::Load(df_, axis.n.data() + i), back));
            };
            note(hn::Load(di_, columns_.slot.data() + i), slots);
            note(forth(columns_.x), forthX);
            note(forth(columns_.y), forthY);
            const Packing packing(kept);
            columns_.template all<kAddress>([&](auto& column) {
                using T = typename std::remove_reference_t<decltype(column)>::value_type;
                const hn::ScalableTag<T> d;
                hn::StoreU(packing(hn::Load(d, column.data() + i)), d, column.data() + to);
            });
            const std::size_t here = hn::CountTrue(di_, kept);
            to += here;
            ended += std::min(kLanes, used_ - i) - here;
        }
        used_ = to;
        for (std::size_t n = 0; n < ended; ++n) {
            const auto i = static_cast<std::size_t>(slots[n]);
            rays_.x.hitPlace[i] = forthX[n];
            rays_.y.hitPlace[i] = forthY[n];
        }
    }

    // The candidates' cells, from their distances to the first cell.
    HWY_INLINE void cellsOfHits() {
        for (LaneAxisRays* axis : {&rays_.x, &rays_.y}) {
            const VI cells = hn::Set(di_, (axis == &rays_.x ? frameX_ : frameY_).axis.cells);
            for (std::size_t i = 0; i < end_; i += kLanes) {
                VI cell = hn::Add(hn::Load(di_, axis->cell.data() + i), hn::Load(di_, axis->hitPlace.data() + i));
                if constexpr (kAddress == Address::Repeat) {
                    // For integers below 2^22 the rounded quotient never crosses an integer.
                    const VF quotient = hn::Div(hn::ConvertTo(df_, cell), hn::ConvertTo(df_, cells));
                    const VI period = hn::Mul(hn::ConvertTo(di_, hn::Floor(quotient)), cells);
                    hn::Store(period, di_, axis->hitPeriod.data() + i);
                    cell = hn::Sub(cell, period);
                }
                hn::Store(cell, di_, axis->hitCell.data() + i);
            }
        }
    }

    const DF df_{};
    const DI di_{};
    const FloatScene& scene_;
    const double* const* given_;
    LaneRays& rays_;
    WalkColumns& columns_;
    WalkMap map_;
    EntryFrame<kAddress> frameX_, frameY_;
    bool resumes_;
    const RayBits* left_ = nullptr;  // rays to be walked; null: all
    std::size_t next_ = 0, end_;
    std::size_t used_ = 0;                   // slots in use, including those of ended rays
    std::size_t walking_ = 0, waiting_ = 0;  // numbers of rays
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
