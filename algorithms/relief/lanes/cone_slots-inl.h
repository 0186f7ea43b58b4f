// The slots of the cone walk: what is known of each ray in flight, column by column. Compiled for each target.

#if defined(RELIEF_CONE_SLOTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_SLOTS_INL_H
#undef RELIEF_CONE_SLOTS_INL_H
#else
#define RELIEF_CONE_SLOTS_INL_H
#endif

#include "relief/lanes/lane_trace-inl.h"
#include "relief/maps/packed_cones.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Rays in flight.
inline constexpr std::size_t kWalkSlots = 256;
// Jumps end this part of a cell early, and by the rounding of places: the cell that is found is not too far on.
inline constexpr float kShorterJump = 1e-3F;
// Words of a quadrant that are more than the second cache holds.
inline constexpr std::size_t kLargeMap = 1U << 18U;
// Rays as most are: run at least so far, texels, and begin so far from lines at least, texels; whatever begins
// otherwise is set up with care.
inline constexpr double kLeastRun = 1e-5;
inline constexpr double kOffLine = 1e-9;

// A column; vectors are stored from any place on.
template <class T>
using WalkColumn = std::array<T, kWalkSlots + 2 * kLanes>;
struct WalkAxis {
    alignas(64) WalkColumn<std::int32_t> n;     // cells from the start
    alignas(64) WalkColumn<std::int32_t> last;  // n of the map's last cell (of this period, where it repeats)
    alignas(64) WalkColumn<float> inverse, base, run;
    alignas(64) WalkColumn<float> place;  // n at lambda is lambda * run - place, less half a cell and a little
};
struct WalkColumns {
    WalkAxis x, y;
    alignas(64) WalkColumn<std::int32_t> index;  // of the cell's word
    alignas(64) WalkColumn<float> rim;           // lambda at which the ray has left the map or is at the bottom
    alignas(64) WalkColumn<float> tie;
    alignas(64) WalkColumn<std::int32_t> slot;   // in LaneRays
    alignas(64) WalkColumn<std::int32_t> state;  // of those below

    template <class Body>
    HWY_INLINE void all(const Body& body) {
        for (WalkAxis* axis : {&x, &y}) {
            body(axis->n), body(axis->last);
            body(axis->inverse), body(axis->base), body(axis->run), body(axis->place);
        }
        body(index), body(rim), body(tie), body(slot), body(state);
    }
};
inline constexpr std::int32_t kWalking = 0, kAtLeaf = 1, kEnded = 2;

// The slots of the rays that are walked together: taken in from the rays as they are given, and packed when many have
// ended.
template <Address kAddress>
class WalkSlots {
  public:
    // given: s0, t0, a, b of the chunk; its rays [begin, end) are of the quadrant.
    WalkSlots(const LaneScene& scene, const PackedCones& cones, std::uint32_t quadrant, const double* const* given,
              LaneRays& rays, std::size_t begin, std::size_t end, WalkColumns& columns)
        : scene_(scene),
          given_(given),
          rays_(rays),
          columns_(columns),
          frameX_(scene.grid.x, (quadrant & 1U) != 0, scene.mirror),
          frameY_(scene.grid.y, (quadrant & 2U) != 0, scene.mirror),
          next_(begin),
          end_(end) {
        map_.words = reinterpret_cast<const std::int32_t*>(cones.words[quadrant].data());
        map_.large = cones.words[quadrant].size() >= kLargeMap;
        map_.x = grid(scene.grid.x, (quadrant & 1U) != 0, 1);
        map_.y = grid(scene.grid.y, (quadrant & 2U) != 0, cones.nx);
        map_.unit = static_cast<float>(cones.unit);
        // Rounded up in the product and sum by less than the margin.
        constexpr double kRounding = 0x1p-20;
        map_.top = static_cast<float>(1 - cones.highest - kRounding);
    }

  protected:
    // One axis, the same for all rays of the quadrant; mirrored where they run backwards.
    struct Grid {
        bool mirrored = false;
        std::int32_t low = 0;     // first cell, mirrored
        std::int32_t last = 0;    // last cell
        std::int32_t stride = 0;  // words a cell, mirrored
    };
    // What is the same for all rays.
    struct Map {
        const std::int32_t* words = nullptr;
        Grid x, y;
        float unit = 0, top = 0;
        bool large = false;  // words are fetched before they are needed
    };
    // What the setting up of an axis needs to know: along = sign * origin + offset is mirrored where rays run
    // backwards.
    struct EntryFrame {
        double sign, offset;
        double low, high;  // of the places within the map, or within the first period, with something to spare
        float toRim = 0;   // from the number of the last cell to the map's edge
        EntryFrame(const GridAxis& axis, bool mirrored, std::int32_t mirror)
            : sign(mirrored ? -1 : 1), offset(mirrored ? mirror - axis.shift : axis.shift) {
            constexpr double kInside = 1e-6;
            const bool border = kAddress == Address::Border;
            // Where the map repeats, starts that need not be taken into the first period: s within the texels.
            const double whole = kAddress == Address::Repeat ? axis.texels + axis.shift : axis.cells;
            const double from = border ? axis.low : 0, to = border ? axis.high : whole;
            low = (mirrored ? mirror - to : from) + kInside;
            high = (mirrored ? mirror - from : to) - kInside;
            const double last = (mirrored ? mirror - axis.cells : 0) + axis.cells - 1.0;
            toRim = static_cast<float>(high + kInside - last);
        }
    };
    // An axis of rays where they begin: cell, mirrored, and before addressing; place in the cell; size of the run.
    struct Entry {
        VI cell, first;
        VF share, run;
    };
    Grid grid(const GridAxis& axis, bool mirrored, std::int32_t stride) const {
        const std::int32_t low = mirrored ? scene_.mirror - axis.cells : 0;
        return {mirrored, low, low + axis.cells - 1, mirrored ? -stride : stride};
    }

    // New rays behind those in flight, whole vectors as far as there is room.
    HWY_INLINE void fill() {
        const std::size_t room = (kWalkSlots - used_) / kLanes * kLanes;
        const std::size_t taken = std::min(room, end_ - next_);
        for (std::size_t k = 0; k < taken; k += kLanes) take(next_ + k, used_ + k, std::min(kLanes, taken - k));
        next_ += taken;
        used_ += taken;
        hn::StoreU(hn::Set(di_, kEnded), di_, columns_.state.data() + used_);
    }

    // Rays [from, from + count) of the chunk to the slots from `to` on.
    HWY_INLINE void take(std::size_t from, std::size_t to, std::size_t count) {
        std::array<std::array<double, kLanes>, 4> rest;
        const double* columns[] = {given_[0] + from, given_[1] + from, given_[2] + from, given_[3] + from};
        if (count < kLanes) {
            for (std::size_t c = 0; c < rest.size(); ++c) {
                std::fill(std::copy_n(columns[c], count, rest[c].begin()), rest[c].end(), columns[c][0]);
                columns[c] = rest[c].data();
            }
        }
        const double begin = rays_.start[from / kLaneGroup];
        MI starting = hn::FirstN(di_, count);
        Entry x, y;
        if (HWY_LIKELY(entry(frameX_, columns[0], columns[2], begin, x) &&
                       entry(frameY_, columns[1], columns[3], begin, y))) {
            hn::StoreU(hn::Zero(di_), di_, rays_.end.data() + from);
        } else {
            starting = hn::And(starting, entryWithCare(from, columns, begin, x, y));
        }
        const VF start = hn::Set(df_, static_cast<float>(begin));
        VF rim = hn::Set(df_, 1.0F);
        const VF margins =
            hn::Add(takeAxis(map_.x, frameX_, x, start, to, columns_.x, rays_.x.first.data() + from, rim),
                    takeAxis(map_.y, frameY_, y, start, to, columns_.y, rays_.y.first.data() + from, rim));
        const VI index =
            hn::Add(hn::Mul(realCell(map_.y, y.cell), hn::Set(di_, std::abs(map_.y.stride))), realCell(map_.x, x.cell));
        hn::StoreU(index, di_, columns_.index.data() + to);
        hn::StoreU(rim, df_, columns_.rim.data() + to);
        hn::StoreU(hn::Add(margins, margins), df_, columns_.tie.data() + to);
        hn::StoreU(countedFrom(static_cast<std::int32_t>(from)), di_, columns_.slot.data() + to);
        hn::StoreU(hn::IfThenElse(starting, hn::Set(di_, kWalking), hn::Set(di_, kEnded)), di_,
                   columns_.state.data() + to);
        walking_ += hn::CountTrue(di_, starting);
    }

    // Not Iota of the number: that is written lane by lane.
    HWY_INLINE VI countedFrom(std::int32_t first) const { return hn::Add(hn::Iota(di_, 0), hn::Set(di_, first)); }

    // One axis of rays where they begin. Returns whether all of them are as most rays are: well within the map and away
    // from lines. Otherwise what it leaves is not to be used.
    HWY_INLINE bool entry(const EntryFrame& frame, const double* origins, const double* runs, double begin,
                          Entry& out) const {
        const DD d;
        const DHF df;
        const DHI di;
        MD usual = hn::FirstN(d, kHalfLanes);
        std::array<hn::Vec<DHI>, 2> cell;
        std::array<hn::Vec<DHF>, 2> share, run;
        for (std::size_t h = 0; h < 2; ++h) {
            const std::size_t i = kHalfLanes > 1 ? h * kHalfLanes : 0;
            const VD absRun = hn::Abs(hn::LoadU(d, runs + i));
            const VD at = hn::MulAdd(hn::LoadU(d, origins + i), hn::Set(d, frame.sign), hn::Set(d, frame.offset));
            const VD along = hn::MulAdd(absRun, hn::Set(d, begin), at);
            const VD first = hn::Floor(along);
            const VD part = hn::Sub(along, first);
            const MD runs01 = hn::And(hn::Gt(absRun, hn::Set(d, kLeastRun)), hn::Lt(absRun, hn::Set(d, kLaneRun)));
            const MD within = hn::And(hn::Gt(at, hn::Set(d, frame.low)), hn::Lt(along, hn::Set(d, frame.high)));
            const MD clear = hn::And(hn::Gt(part, hn::Set(d, kOffLine)), hn::Lt(part, hn::Set(d, 1 - kOffLine)));
            usual = hn::And(usual, hn::And(runs01, hn::And(within, clear)));
            cell[h] = hn::DemoteTo(di, first);
            share[h] = hn::DemoteTo(df, part);
            run[h] = hn::DemoteTo(df, absRun);
        }
        out.cell = out.first = joined(di_, cell[0], cell[1]);
        out.share = joined(df_, share[0], share[1]);
        out.run = joined(df_, run[0], run[1]);
        return hn::AllTrue(d, usual);
    }
    template <class D, class Half>
    HWY_INLINE static hn::Vec<D> joined(D d, Half low, Half high) {
#if HWY_TARGET == HWY_SCALAR
        (void)d, (void)high;
        return low;
#else
        return hn::Combine(d, high, low);
#endif
    }

    // The same for any rays: returns which of them lanes can take, and notes what becomes of the others.
    HWY_NOINLINE MI entryWithCare(std::size_t from, const double* const* columns, double begin, Entry& x, Entry& y) {
        const auto column = [&](std::size_t c) { return columns[c] - from; };
        for (std::size_t h = 0; h < kLanes; h += kHalfLanes) {
            setUpRays<kAddress>(scene_, column(0), column(1), column(2), column(3), begin, from + h, rays_);
        }
        const MI fit = hn::Eq(hn::LoadU(di_, rays_.end.data() + from), hn::Zero(di_));
        const auto load = [&](const Grid& grid, const LaneAxisRays& rays, Entry& out) {
            // Rays that are not walked: in a cell of the map, for words are read with those of their vector.
            const VI low = hn::Set(di_, grid.low);
            out.cell = hn::IfThenElse(fit, hn::LoadU(di_, rays.cell.data() + from), low);
            out.first = hn::LoadU(di_, rays.first.data() + from);
            out.share = hn::LoadU(df_, rays.base.data() + from);
            out.run = hn::Abs(hn::LoadU(df_, rays.run.data() + from));
        };
        load(map_.x, rays_.x, x), load(map_.y, rays_.y, y);
        return fit;
    }

    // Returns the axis's margin.
    HWY_INLINE VF takeAxis(const Grid& grid, const EntryFrame& frame, const Entry& in, VF start, std::size_t to,
                           WalkAxis& out, std::int32_t* first, VF& rim) const {
        const VF one = hn::Set(df_, 1.0F);
        const VF inverse = hn::Div(one, hn::Max(in.run, hn::Set(df_, 1e-30F)));
        const VF margin = hn::Mul(hn::Set(df_, kCrossingMargin), hn::Add(inverse, one));
        const VF base = hn::Add(hn::NegMulAdd(in.share, inverse, start), margin);
        // Where the map repeats, n counts from the cell before it is addressed; clamped, from the cell itself.
        if constexpr (kAddress == Address::Repeat) hn::StoreU(in.first, di_, first);
        VI n = hn::Zero(di_), last = hn::Sub(hn::Set(di_, grid.last), in.cell);
        if constexpr (kAddress == Address::Clamp) {
            n = hn::Sub(in.cell, in.first);
            last = hn::Sub(hn::Set(di_, grid.last), in.first);
        }
        if constexpr (kAddress == Address::Border) {
            // The rim is a line like others, `toRim` beyond the last cell's number.
            const VF lines = hn::Add(hn::ConvertTo(df_, last), hn::Set(df_, frame.toRim));
            rim = hn::Min(rim, hn::MulAdd(lines, inverse, base));
        }
        hn::StoreU(n, di_, out.n.data() + to);
        hn::StoreU(last, di_, out.last.data() + to);
        hn::StoreU(inverse, df_, out.inverse.data() + to);
        hn::StoreU(base, df_, out.base.data() + to);
        hn::StoreU(in.run, df_, out.run.data() + to);
        const VF shorter = hn::MulAdd(in.run, hn::Set(df_, 8 * kCrossingMargin), hn::Set(df_, kShorterJump + 0.5F));
        hn::StoreU(hn::MulAdd(base, in.run, shorter), df_, out.place.data() + to);
        return margin;
    }

    // The rays in flight to the front; of ended ones, where they ended.
    HWY_INLINE void compact() {
        alignas(64) WalkColumn<std::int32_t> slots, cellsX, cellsY, placesX, placesY;
        std::size_t to = 0, ended = 0;
        for (std::size_t i = 0; i < used_; i += kLanes) {
            const MI inUse = hn::FirstN(di_, used_ - i);
            const MI kept = hn::And(inUse, hn::Ne(hn::Load(di_, columns_.state.data() + i), hn::Set(di_, kEnded)));
            const VI nx = hn::Load(di_, columns_.x.n.data() + i), ny = hn::Load(di_, columns_.y.n.data() + i);
            const Packing gone(hn::AndNot(kept, inUse));
            const auto note = [&](VI v, WalkColumn<std::int32_t>& column) {
                hn::StoreU(gone(v), di_, column.data() + ended);
            };
            note(hn::Load(di_, columns_.slot.data() + i), slots);
            note(realCell(map_.x, nx, hn::Load(di_, columns_.x.last.data() + i)), cellsX);
            note(realCell(map_.y, ny, hn::Load(di_, columns_.y.last.data() + i)), cellsY);
            if constexpr (kAddress == Address::Repeat) note(nx, placesX), note(ny, placesY);
            const Packing packing(kept);
            columns_.all([&](auto& column) {
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
            rays_.x.hitCell[i] = cellsX[n];
            rays_.y.hitCell[i] = cellsY[n];
            if constexpr (kAddress == Address::Repeat) {
                rays_.x.hitPlace[i] = placesX[n];
                rays_.y.hitPlace[i] = placesY[n];
            }
        }
    }

    HWY_INLINE VI realCell(const Grid& grid, VI cell) const {
        return grid.mirrored ? hn::Sub(hn::Set(di_, scene_.mirror - 1), cell) : cell;
    }
    HWY_INLINE VI realCell(const Grid& grid, VI n, VI last) const {
        return realCell(grid, hn::Add(n, hn::Sub(hn::Set(di_, grid.last), last)));
    }

    const DF df_{};
    const DI di_{};
    const LaneScene& scene_;
    const double* const* given_;
    LaneRays& rays_;
    WalkColumns& columns_;
    Map map_;
    EntryFrame frameX_, frameY_;
    std::size_t next_, end_;
    std::size_t used_ = 0;                   // slots, ended rays included
    std::size_t walking_ = 0, waiting_ = 0;  // rays
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
