#include "relief/lanes/cone_lanes.h"

#include <algorithm>

// Vectors in structures: not for the instruction sets without a fixed width.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/lanes/cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/lanes/cone_beams-inl.h"
#include "relief/lanes/lane_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Vectors of rays in flight together.
inline constexpr std::size_t kConeVectors = 4;
// Jumps end this part of a cell early, and by the rounding of places: the cell that is found is not too far on.
inline constexpr float kShorterJump = 1e-3F;

// One axis, the same for all rays of the quadrant; mirrored where they run backwards.
struct ConeAxis {
    bool mirrored = false;
    std::int32_t low = 0;   // first cell, mirrored
    std::int32_t high = 0;  // one past the last
};

template <Address kAddress, Surface kSurface>
class ConeKernel {
  public:
    ConeKernel(const LaneScene& scene, const PackedCones& cones, std::uint32_t quadrant, LaneRays& rays,
               std::size_t begin, std::size_t end)
        : scene_(scene), rays_(rays), next_(begin), end_(end) {
        words_ = reinterpret_cast<const std::int32_t*>(cones.words[quadrant].data());
        stride_ = cones.nx;
        x_ = axis(scene.grid.x, (quadrant & 1U) != 0);
        y_ = axis(scene.grid.y, (quadrant & 2U) != 0);
        unit_ = static_cast<float>(cones.unit);
        // Rounded up in the product and sum by less than the margin.
        constexpr double kRounding = 0x1p-20;
        top_ = static_cast<float>(1 - cones.highest - kRounding);
    }

    void run() {
        std::array<State, kConeVectors> states;
        for (State& state : states) {
            clear(state);
            refill(state);
        }
        for (bool busy = true; busy;) {
            busy = false;
            for (State& state : states) busy = step(state) || busy;
        }
    }

  private:
    struct Axis : LaneAxisState {
        VI n;      // cells from the start
        VF place;  // n at lambda is lambda * run - place
        VF rim;
    };
    struct State {
        Axis x, y;
        VI slot;
        VF tie;
        MF walking, atLeaf;
        bool some;
    };

    ConeAxis axis(const GridAxis& grid, bool mirrored) const {
        const std::int32_t low = mirrored ? scene_.mirror - grid.cells : 0;
        return {mirrored, low, low + grid.cells};
    }

    HWY_INLINE void clear(State& state) {
        state.slot = hn::Zero(di_);
        state.tie = hn::Zero(df_);
        for (Axis* axis : {&state.x, &state.y}) {
            axis->offset = axis->n = hn::Zero(di_);
            axis->inverse = axis->base = axis->run = axis->place = axis->rim = hn::Zero(df_);
        }
        state.x.mirrored = hn::FirstN(df_, x_.mirrored ? kLanes : 0);
        state.y.mirrored = hn::FirstN(df_, y_.mirrored ? kLanes : 0);
        state.walking = state.atLeaf = hn::MaskFromVec(hn::Zero(df_));
        state.some = false;
    }

    // The lanes in use to the front, new rays behind them.
    HWY_INLINE void refill(State& state) {
        const MF active = hn::Or(state.walking, state.atLeaf);
        const MI activeI = asInt(active);
        const std::size_t kept = hn::CountTrue(df_, active);
        state.some = kept > 0;
        if (next_ >= end_ || kLanes - kept < kRefill) return;
        // As many rays were taken as lanes are kept, at least: the columns begin before.
        const std::size_t from = next_ - kept;
        const std::size_t taken = std::min(kLanes - kept, end_ - next_);
        const MI old = hn::FirstN(di_, kept);
        const MF oldF = asFloat(old);
        const auto keepI = [&](VI v, VI incoming) { return hn::IfThenElse(old, hn::Compress(v, activeI), incoming); };
        const auto keepF = [&](VF v, const std::array<float, kLaneSlots>& column) {
            return hn::IfThenElse(oldF, hn::Compress(v, active), hn::LoadU(df_, column.data() + from));
        };
        take(state.x, rays_.x, keepI, keepF, from);
        take(state.y, rays_.y, keepI, keepF, from);
        state.tie = keepF(state.tie, rays_.tie);
        state.slot = keepI(state.slot, hn::Iota(di_, static_cast<std::int32_t>(from)));
        const VI ends = hn::LoadU(di_, rays_.end.data() + from);
        const MI fresh = hn::AndNot(old, hn::FirstN(di_, kept + taken));
        const MI starting = hn::And(fresh, hn::Eq(ends, hn::Zero(di_)));
        const MI walking = hn::MaskFromVec(hn::Compress(hn::VecFromMask(di_, asInt(state.walking)), activeI));
        state.walking = asFloat(hn::Or(hn::And(walking, old), starting));
        state.atLeaf = asFloat(hn::AndNot(walking, old));
        next_ += taken;
        state.some = true;
    }

    template <class KeepI, class KeepF>
    HWY_INLINE void take(Axis& axis, const LaneAxisRays& rays, const KeepI& keepI, const KeepF& keepF,
                         std::size_t from) const {
        const VI cell = hn::LoadU(di_, rays.cell.data() + from);
        if constexpr (kAddress == Address::Repeat) {
            axis.n = keepI(axis.n, hn::Zero(di_));
            axis.offset = keepI(axis.offset, cell);
        } else {
            const VI first = hn::LoadU(di_, rays.first.data() + from);
            axis.n = keepI(axis.n, hn::Sub(cell, first));
            axis.offset = keepI(axis.offset, first);
        }
        axis.inverse = keepF(axis.inverse, rays.inverse);
        axis.base = keepF(axis.base, rays.base);
        axis.run = hn::Abs(keepF(axis.run, rays.run));
        axis.place = hn::Mul(axis.base, axis.run);
        if constexpr (kAddress == Address::Border) axis.rim = keepF(axis.rim, rays.rim);
    }

    struct Crossing {
        VF lambda;
        MF last;  // clamp, border: there is no cell beyond
    };
    HWY_INLINE Crossing crossing(const ConeAxis& grid, const Axis& ray) const {
        Crossing out;
        out.lambda = hn::MulAdd(hn::Add(hn::ConvertTo(df_, ray.n), hn::Set(df_, 1.0F)), ray.inverse, ray.base);
        if constexpr (kAddress != Address::Repeat) {
            out.last = asFloat(hn::Eq(hn::Add(ray.n, ray.offset), hn::Set(di_, grid.high - 1)));
            VF rim = hn::Set(df_, 1e30F);
            if constexpr (kAddress == Address::Border) {
                rim = hn::MulAdd(ray.inverse, hn::Set(df_, kCrossingMargin),
                                 hn::Add(ray.rim, hn::Set(df_, kCrossingMargin)));
            }
            out.lambda = hn::IfThenElse(out.last, rim, out.lambda);
        } else {
            out.last = hn::MaskFromVec(hn::Zero(df_));
        }
        return out;
    }

    HWY_INLINE VI wordAt(MI who, VI cellX, VI cellY) const {
        const VI index = hn::Add(hn::Mul(realCell(y_, cellY), hn::Set(di_, stride_)), realCell(x_, cellX));
        return hn::GatherIndex(di_, words_, hn::IfThenElseZero(who, index));
    }
    HWY_INLINE VF depthOf(VI bits) const {
        return hn::MulAdd(hn::ConvertTo(df_, hn::And(bits, hn::Set(di_, static_cast<std::int32_t>(kConeDepths)))),
                          hn::Set(df_, unit_), hn::Set(df_, top_));
    }

    // False: no lane has a ray.
    HWY_INLINE bool step(State& state) {
        if (!state.some) return false;
        const std::size_t waiting = hn::CountTrue(df_, state.atLeaf);
        if (waiting >= kLeaves || (waiting > 0 && hn::AllFalse(df_, state.walking))) {
            leaves(state);
            refill(state);
            return state.some;
        }
        const VF oneF = hn::Set(df_, 1.0F);
        const Crossing cx = crossing(x_, state.x);
        const Crossing cy = crossing(y_, state.y);
        const VF out = hn::Min(hn::Min(cx.lambda, cy.lambda), oneF);
        const VI word =
            wordAt(asInt(state.walking), hn::Add(state.x.n, state.x.offset), hn::Add(state.y.n, state.y.offset));
        const VF own = depthOf(word);
        const VF apex = depthOf(hn::ShiftRight<10>(word));
        const MF above = hn::Lt(out, own);
        const MF leaf = hn::AndNot(above, state.walking);
        const MF on = hn::And(above, state.walking);
        state.atLeaf = hn::Or(state.atLeaf, leaf);
        state.walking = on;
        // The ray meets the cone; the approximate reciprocal's error and all rounding is in the factor.
        const VF steepness = hn::MulAdd(hn::BitCast(df_, word), hn::Max(state.x.run, state.y.run), oneF);
        const VF share = hn::Mul(hn::ApproximateReciprocal(steepness), hn::Set(df_, 1 - 0x1p-10F));
        const VF jump = hn::MulAdd(hn::Max(hn::Sub(apex, out), hn::Zero(df_)), share, out);
        moveOn(state, on, cx, cy, out, jump);
        refill(state);
        return state.some;
    }

    // To the cell where the jump ends, the next one at least.
    HWY_INLINE void moveOn(State& state, MF who, const Crossing& cx, const Crossing& cy, VF out, VF jump) {
        MF moveX = hn::Le(cx.lambda, cy.lambda);
        MF moveY = hn::Le(cy.lambda, cx.lambda);
        MF bad = hn::And(who, hn::Ge(out, hn::Set(df_, 1.0F)));
        // Too near a corner to tell which neighbour comes first, and the jump does not pass it: both must be skipped.
        const VF gap = hn::Abs(hn::Sub(cx.lambda, cy.lambda));
        const VF passed = hn::Add(hn::Max(cx.lambda, cy.lambda), state.tie);
        const MF near = hn::And(hn::And(who, hn::Lt(gap, state.tie)), hn::Lt(jump, passed));
        if (HWY_UNLIKELY(!hn::AllFalse(df_, near))) {
            const MF clear =
                hn::And(sideClear(state, near, true, cx.last, out), sideClear(state, near, false, cy.last, out));
            bad = hn::Or(bad, hn::AndNot(clear, near));
            moveX = hn::Or(moveX, near);
            moveY = hn::Or(moveY, near);
        }
        if (HWY_UNLIKELY(!hn::AllFalse(df_, bad))) {
            finish(state, bad, LaneEnd::Scalar);
            who = hn::AndNot(bad, who);
            state.walking = hn::AndNot(bad, state.walking);
        }
        const auto place = [&](const Axis& ray) {
            const VF shorter = hn::MulAdd(ray.run, hn::Set(df_, 8 * kCrossingMargin), hn::Set(df_, kShorterJump));
            return hn::ConvertTo(di_, hn::Sub(hn::MulSub(jump, ray.run, ray.place), shorter));
        };
        const VI nextX = hn::Max(hn::Sub(state.x.n, hn::VecFromMask(di_, asInt(moveX))), place(state.x));
        const VI nextY = hn::Max(hn::Sub(state.y.n, hn::VecFromMask(di_, asInt(moveY))), place(state.y));
        arrive(state, who, state.x, x_, nextX);
        arrive(state, who, state.y, y_, nextY);
    }

    HWY_INLINE void arrive(State& state, MF who, Axis& ray, const ConeAxis& grid, VI next) {
        const MI whoI = asInt(who);
        ray.n = hn::IfThenElse(whoI, next, ray.n);
        const VI last = hn::Set(di_, grid.high - 1);
        MI beyond = hn::And(whoI, hn::Gt(hn::Add(ray.n, ray.offset), last));
        if (HWY_LIKELY(hn::AllFalse(di_, beyond))) return;
        if constexpr (kAddress == Address::Repeat) {
            const VI period = hn::Set(di_, grid.high - grid.low);
            while (!hn::AllFalse(di_, beyond)) {
                ray.offset = hn::IfThenElse(beyond, hn::Sub(ray.offset, period), ray.offset);
                beyond = hn::And(whoI, hn::Gt(hn::Add(ray.n, ray.offset), last));
            }
        } else if constexpr (kAddress == Address::Clamp) {
            ray.n = hn::IfThenElse(beyond, hn::Sub(last, ray.offset), ray.n);
        } else {
            const MF gone = asFloat(beyond);
            finish(state, hn::And(gone, state.walking), LaneEnd::Miss);
            state.walking = hn::AndNot(gone, state.walking);
            ray.n = hn::IfThenElse(beyond, hn::Sub(last, ray.offset), ray.n);
        }
    }

    // Whether the neighbour along one axis alone is surely above the surface until the corner is passed.
    HWY_INLINE MF sideClear(const State& state, MF who, bool alongX, MF last, VF out) const {
        const ConeAxis& grid = alongX ? x_ : y_;
        const VI one = hn::Set(di_, 1);
        VI cellX = hn::Add(state.x.n, state.x.offset), cellY = hn::Add(state.y.n, state.y.offset);
        VI& cell = alongX ? cellX : cellY;
        cell = hn::Add(cell, one);
        const MI beyond = hn::Gt(cell, hn::Set(di_, grid.high - 1));
        if constexpr (kAddress == Address::Repeat) {
            cell = hn::IfThenElse(beyond, hn::Set(di_, grid.low), cell);
        } else {
            cell = hn::IfThenElse(beyond, hn::Sub(cell, one), cell);
        }
        const VF own = depthOf(wordAt(asInt(who), cellX, cellY));
        const MF clear = hn::Lt(hn::Add(out, hn::Add(state.tie, state.tie)), own);
        if constexpr (kAddress == Address::Clamp) return hn::Or(clear, last);
        if constexpr (kAddress == Address::Border) return hn::AndNot(last, clear);
        return clear;
    }

    HWY_INLINE VI realCell(const ConeAxis& grid, VI cell) const {
        return grid.mirrored ? hn::Sub(hn::Set(di_, scene_.mirror - 1), cell) : cell;
    }
    HWY_INLINE VI realCell(const ConeAxis& grid, const Axis& ray) const {
        return realCell(grid, hn::Add(ray.n, ray.offset));
    }

    // Cells whose highest point the ray goes below: is the surface itself below it?
    HWY_INLINE void leaves(State& state) {
        const MF who = state.atLeaf;
        const MI whoI = asInt(who);
        state.atLeaf = hn::MaskFromVec(hn::Zero(df_));
        const Crossing cx = crossing(x_, state.x);
        const Crossing cy = crossing(y_, state.y);
        const VF out = hn::Min(hn::Min(cx.lambda, cy.lambda), hn::Set(df_, 1.0F));
        const VI cellX = hn::IfThenElseZero(whoI, realCell(x_, state.x));
        const VI cellY = hn::IfThenElseZero(whoI, realCell(y_, state.y));
        MF below;
        if constexpr (kSurface == Surface::Columns) {
            below = columnBelow(scene_, cellX, cellY, out, state.tie);
        } else {
            const VF nx = hn::ConvertTo(df_, state.x.n), ny = hn::ConvertTo(df_, state.y.n);
            VF in =
                hn::Max(hn::MulAdd(nx, state.x.inverse, state.x.base), hn::MulAdd(ny, state.y.inverse, state.y.base));
            in = hn::Min(hn::Max(hn::Sub(in, state.tie), hn::Zero(df_)), out);
            below = patchBelow<kAddress>(scene_, state.x, state.y, cellX, cellY, nx, ny, in, out, state.tie);
        }
        finishCandidates(state, hn::AndNot(below, who));
        const MF on = hn::And(below, who);
        state.walking = hn::Or(state.walking, on);
        if (!hn::AllFalse(df_, on)) moveOn(state, on, cx, cy, out, out);
    }

    HWY_INLINE void finishCandidates(const State& state, MF who) {
        if (hn::AllFalse(df_, who)) return;
        noteCandidates(rays_, asInt(who), state.slot, realCell(x_, state.x), realCell(y_, state.y), state.x.n,
                       state.y.n);
    }

    HWY_INLINE void finish(const State& state, MF who, LaneEnd end) { noteEnd(rays_, asInt(who), state.slot, end); }

    // Idle lanes before new rays are taken in, waiting ones before leaves are looked at.
    static constexpr std::size_t kRefill = std::max<std::size_t>(1, kLanes / 4);
    static constexpr std::size_t kLeaves = std::max<std::size_t>(1, kLanes / 2);

    const DF df_{};
    const DI di_{};
    const LaneScene& scene_;
    LaneRays& rays_;
    const std::int32_t* words_ = nullptr;
    ConeAxis x_, y_;
    float unit_ = 0, top_ = 0;
    std::int32_t stride_ = 0;
    std::size_t next_;
    std::size_t end_;
};

template <Address kAddress, Surface kSurface>
void traceConesIn(const LaneScene& scene, const PackedCones& cones, const double* const* columns,
                  const std::size_t* quadrants, HitBlock& hits, std::size_t firstHit, LaneRays& scratch) {
    scratch.start.fill(scene.start);
    if (scratch.count >= kLaneGroup) {
        for (std::uint32_t q = 0; q < 4; ++q) {
            if (quadrants[q + 1] - quadrants[q] == scratch.count)
                leadBeams<kAddress>(scene, cones, q, columns, scratch);
        }
    }
    setUpLanes<kAddress>(scene, columns[0], columns[1], columns[2], columns[3], scratch);
    for (std::uint32_t q = 0; q < 4; ++q) {
        if (quadrants[q] == quadrants[q + 1]) continue;
        ConeKernel<kAddress, kSurface>(scene, cones, q, scratch, quadrants[q], quadrants[q + 1]).run();
    }
    settleLanes<kAddress, kSurface>(scene, columns[0], columns[1], columns[2], columns[3], scratch, hits, firstHit);
}

// The quadrant of all rays; 4: they have not one in common.
std::size_t commonQuadrant(const double* a, const double* b, std::size_t count) {
    const DD d;
    const auto sign = [&](const double* runs) {
        MD every = hn::FirstN(d, kHalfLanes), any = hn::MaskFromVec(hn::Zero(d));
        std::size_t i = 0;
        for (; i + kHalfLanes <= count; i += kHalfLanes) {
            const MD back = hn::Lt(hn::LoadU(d, runs + i), hn::Zero(d));
            every = hn::And(every, back), any = hn::Or(any, back);
        }
        bool all = count >= kHalfLanes ? hn::AllTrue(d, every) : runs[0] < 0;
        bool some = !hn::AllFalse(d, any);
        for (; i < count; ++i) all = all && runs[i] < 0, some = some || runs[i] < 0;
        return all ? 1 : (some ? 2 : 0);
    };
    const int x = sign(a), y = sign(b);
    return x == 2 || y == 2 ? 4 : static_cast<std::size_t>(x + 2 * y);
}

void traceCones(const LaneScene& scene, const PackedCones& cones, const double* const* columns,
                const std::size_t* quadrants, HitBlock& hits, std::size_t firstHit, LaneRays& scratch) {
    const auto with = [&]<Address kAddress>() {
        if (scene.surface == Surface::Bilinear) {
            traceConesIn<kAddress, Surface::Bilinear>(scene, cones, columns, quadrants, hits, firstHit, scratch);
        } else {
            traceConesIn<kAddress, Surface::Columns>(scene, cones, columns, quadrants, hits, firstHit, scratch);
        }
    };
    switch (scene.address) {
        case Address::Repeat:
            return with.template operator()<Address::Repeat>();
        case Address::Clamp:
            return with.template operator()<Address::Clamp>();
        case Address::Border:
            return with.template operator()<Address::Border>();
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(traceCones);
HWY_EXPORT(commonQuadrant);

namespace {

// Rays of a chunk by quadrant of their direction; order[n]: which ray comes n-th.
struct QuadrantOrder {
    std::array<std::size_t, 5> begin{};
    bool sorted = true;
    std::array<std::uint16_t, kLaneChunk> order;
};

void orderByQuadrant(const RayBlock& rays, std::size_t first, std::size_t count, QuadrantOrder& out) {
    const std::size_t common =
        HWY_DYNAMIC_DISPATCH(commonQuadrant)(rays.a.data() + first, rays.b.data() + first, count);
    out.sorted = common < 4;
    for (std::size_t q = 0; q < 5; ++q) out.begin[q] = q <= common ? 0 : count;
    if (out.sorted) return;
    std::array<std::uint8_t, kLaneChunk> quadrant;
    std::array<std::size_t, 4> counts{};
    for (std::size_t i = 0; i < count; ++i) {
        quadrant[i] = static_cast<std::uint8_t>((rays.a[first + i] < 0 ? 1 : 0) + (rays.b[first + i] < 0 ? 2 : 0));
    }
    for (std::size_t i = 0; i < count; ++i) ++counts[quadrant[i]];
    out.begin[0] = 0;
    for (std::size_t q = 0; q < 4; ++q) out.begin[q + 1] = out.begin[q] + counts[q];
    std::array<std::size_t, 4> next{};
    std::copy_n(out.begin.begin(), 4, next.begin());
    for (std::size_t i = 0; i < count; ++i) out.order[next[quadrant[i]]++] = static_cast<std::uint16_t>(i);
}

}  // namespace

void traceConeLanes(const LaneScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first,
                    std::size_t last, HitBlock& hits, LaneRays& scratch) {
    assert(last - first <= kLaneChunk);
    const std::size_t count = last - first;
    if (count == 0) return;
    scratch.count = count;
    static thread_local QuadrantOrder order;
    orderByQuadrant(rays, first, count, order);
    if (order.sorted) {
        const double* const columns[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                         rays.b.data() + first};
        HWY_DYNAMIC_DISPATCH(traceCones)(scene, cones, columns, order.begin.data(), hits, first, scratch);
    } else {
        static thread_local std::array<std::array<double, kLaneChunk>, 4> columns;
        static thread_local HitBlock found(kLaneChunk);
        const std::array<const std::vector<double>*, 4> from{&rays.s0, &rays.t0, &rays.a, &rays.b};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            for (std::size_t n = 0; n < count; ++n) columns[c][n] = (*from[c])[first + order.order[n]];
        }
        const double* const pointers[] = {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()};
        HWY_DYNAMIC_DISPATCH(traceCones)(scene, cones, pointers, order.begin.data(), found, 0, scratch);
        std::array<std::int32_t, kLaneChunk> ends;
        std::copy_n(scratch.end.begin(), count, ends.begin());
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t i = order.order[n];
            hits.lambda[first + i] = found.lambda[n];
            hits.s[first + i] = found.s[n];
            hits.t[first + i] = found.t[n];
            hits.outcome[first + i] = Outcome::Hit;
            scratch.end[i] = ends[n];
        }
    }
    if (scratch.allHit) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (scratch.end[i] == static_cast<std::int32_t>(LaneEnd::Miss)) hits.set(first + i, Hit::none(Outcome::Miss));
    }
}

}  // namespace relief
#endif
