// Setup of rays for SIMD walks in float, and storage of their results: shared by the kernels, compiled for each target.
// Frame: methods/float_scene.h.

#if defined(RELIEF_LANE_TRACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_TRACE_INL_H
#undef RELIEF_LANE_TRACE_INL_H
#else
#define RELIEF_LANE_TRACE_INL_H
#endif

#include "relief/simd/double_vectors-inl.h"
#include "relief/simd/lane_rays.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

using DF = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using MF = hn::Mask<DF>;
using MI = hn::Mask<DI>;

inline constexpr std::size_t kLanes = hn::MaxLanes(DF());

// The arithmetic of a walk: multiply-adds are fused where the target can, and reciprocals are approximate. Tests use
// another class, which rounds as the reference does and records the visits.
struct FastArithmetic {
    static constexpr bool kRecords = false;
    static constexpr bool kBeams = true;
    HWY_INLINE static VF mulAdd(VF a, VF b, VF c) { return hn::MulAdd(a, b, c); }
    HWY_INLINE static VF mulSub(VF a, VF b, VF c) { return hn::MulSub(a, b, c); }
    HWY_INLINE static VF negMulAdd(VF a, VF b, VF c) { return hn::NegMulAdd(a, b, c); }
    HWY_INLINE static VF reciprocal(VF a) { return hn::ApproximateReciprocal(a); }
};

// Calls body<address>() for the scene's addressing.
template <class Body>
void forAddress(const FloatScene& scene, const Body& body) {
    switch (scene.address) {
        case Address::Repeat:
            return body.template operator()<Address::Repeat>();
        case Address::Clamp:
            return body.template operator()<Address::Clamp>();
        case Address::Border:
            return body.template operator()<Address::Border>();
    }
}

HWY_INLINE MF asFloat(MI m) {
    return hn::RebindMask(DF(), m);
}
HWY_INLINE MI asInt(MF m) {
    return hn::RebindMask(DI(), m);
}

// Moves the chosen lanes to the front. The permutation is computed once for several vectors.
#if HWY_TARGET <= HWY_AVX3 || HWY_TARGET == HWY_SCALAR
struct Packing {
    explicit Packing(MI chosen) : indices_(hn::Compress(hn::Iota(DI(), 0), chosen)) {}
    template <class V>
    HWY_INLINE V operator()(V v) const {
        const hn::DFromV<V> d;
        return hn::TableLookupLanes(v, hn::IndicesFromVec(d, indices_));
    }

  private:
    VI indices_;
};
#else
// Faster than Compress, for which g++ 12 copies its table to the stack at every call.
struct Packing {
    explicit Packing(MI chosen) {
        std::uint8_t bits[8];
        hn::StoreMaskBits(DI(), chosen, bits);
        const hn::Rebind<std::uint8_t, DI> bytes;
        indices_ = hn::PromoteTo(DI(), hn::LoadU(bytes, kPackedLanes[bits[0]].data()));
    }
    template <class V>
    HWY_INLINE V operator()(V v) const {
        const hn::DFromV<V> d;
        return hn::TableLookupLanes(v, hn::IndicesFromVec(d, indices_));
    }

  private:
    VI indices_;
};
#endif

// Moves the chosen lanes to the front of `to`, which has room for a whole vector. Faster than CompressStore, which is
// microcode on some processors (Zen 4 and 5: over a hundred cycles).
HWY_INLINE void packLanes(VI v, const Packing& packing, std::int32_t* to) {
    hn::Store(packing(v), DI(), to);
}

// Stores the candidate cells of the rays in the chosen lanes, which the leaf resolves, and under repeat their n.
template <Address kAddress>
HWY_INLINE void noteCandidates(LaneRays& rays, MI chosen, VI slots, VI cellX, VI cellY, VI placeX, VI placeY) {
    HWY_ALIGN std::int32_t slot[kLanes], cells[2][kLanes], places[2][kLanes];
    const Packing packing(chosen);
    const std::size_t count = hn::CountTrue(DI(), chosen);
    packLanes(slots, packing, slot);
    packLanes(cellX, packing, cells[0]);
    packLanes(cellY, packing, cells[1]);
    if constexpr (kAddress == Address::Repeat) {
        packLanes(placeX, packing, places[0]);
        packLanes(placeY, packing, places[1]);
    }
    for (std::size_t n = 0; n < count; ++n) {
        const auto i = static_cast<std::size_t>(slot[n]);
        rays.x.hitCell[i] = cells[0][n];
        rays.y.hitCell[i] = cells[1][n];
        if constexpr (kAddress == Address::Repeat) {
            rays.x.hitPlace[i] = places[0][n];
            rays.y.hitPlace[i] = places[1][n];
        }
    }
}
// The candidates' periods, from their n.
template <Address kAddress>
void periodsOfHits(const FloatScene& scene, std::size_t count, LaneAxisRays& rays) {
    if constexpr (kAddress != Address::Repeat) return;
    const DI di;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const VI along = hn::Add(hn::Load(di, rays.first.data() + i), hn::Load(di, rays.hitPlace.data() + i));
        const MF back = hn::Lt(hn::Load(DF(), rays.run.data() + i), hn::Zero(DF()));
        const VI real = hn::IfThenElse(asInt(back), hn::Sub(hn::Set(di, scene.mirror - 1), along), along);
        hn::Store(hn::Sub(real, hn::Load(di, rays.hitCell.data() + i)), di, rays.hitPeriod.data() + i);
    }
}

HWY_INLINE void noteEnd(LaneRays& rays, MI chosen, VI slots, LaneEnd end) {
    HWY_ALIGN std::int32_t slot[kLanes];
    const std::size_t count = hn::CountTrue(DI(), chosen);
    packLanes(slots, Packing(chosen), slot);
    for (std::size_t n = 0; n < count; ++n)
        rays.end[static_cast<std::size_t>(slot[n])] = static_cast<std::int32_t>(end);
}

// -------------------------------------------------------------------------------------------------------- set-up

// Origins of kHalfLanes rays, reduced to the first period where the axis wraps.
template <Address kAddress>
HWY_INLINE VD reducedOrigins(const GridAxis& axis, const double* origins) {
    const DD d;
    const VD s = hn::LoadU(d, origins);
    if constexpr (kAddress == Address::Repeat) {
        const MD inside = hn::And(hn::Ge(s, hn::Zero(d)), hn::Lt(s, hn::Set(d, axis.texels)));
        if (HWY_UNLIKELY(!hn::AllTrue(d, inside))) {
            HWY_ALIGN double reduced[kHalfLanes];
            hn::Store(s, d, reduced);
            // What is not finite stays so: such rays are left to the fallback.
            for (double& value : reduced) {
                if (std::isfinite(value)) value = reduceToPeriod(value, axis.texels);
            }
            return hn::Load(d, reduced);
        }
    }
    return s;
}

// fit: float can walk the ray. gone: under border the ray entered the map, and certainly left it before the walk
// begins.
struct Fitness {
    MD fit, gone;
};

// One axis of the rays [i, i + kHalfLanes): positions, in double.
template <Address kAddress>
HWY_INLINE Fitness setUpPlaces(const FloatScene& scene, const GridAxis& axis, const double* origins, const double* runs,
                               double begin, std::size_t i, LaneAxisRays& out) {
    const DD d;
    const DHF df;
    const DHI di;
    const VD s = reducedOrigins<kAddress>(axis, origins + i);
    const VD run = hn::LoadU(d, runs + i);
    const VD zero = hn::Zero(d);
    const VD start = hn::Add(s, hn::Set(d, axis.shift));
    const VD place = hn::Add(start, hn::Mul(hn::Set(d, begin), run));
    const MD mirrored = hn::Lt(run, zero);
    const VD line = hn::IfThenElse(mirrored, hn::Ceil(place), hn::Floor(place));
    const VD first = hn::IfThenElse(mirrored, hn::Sub(hn::Set(d, scene.mirror), line), line);
    const VD share = hn::IfThenElse(mirrored, hn::Sub(line, place), hn::Sub(place, line));
    const VD absRun = hn::Abs(run);
    MD good = hn::And(hn::Lt(hn::Abs(first), hn::Set(d, kFloatPlaces)), hn::Le(absRun, hn::Set(d, kFloatRun)));
    // A smaller run would lose its sign in float. RayAxis treats the smallest runs as parallel.
    good = hn::And(good, hn::Or(hn::Ge(absRun, hn::Set(d, 1e-30)), hn::Eq(run, zero)));
    // A ray that hardly moves and begins next to a line could begin on the wrong side of it.
    if (begin > 0) {
        good = hn::AndNot(hn::And(hn::Lt(absRun, hn::Set(d, kLeastRun)), hn::Lt(share, hn::Set(d, kLeastRun))), good);
    }
    const VD low = hn::IfThenElse(mirrored, hn::Set(d, scene.mirror - axis.cells), zero);
    const VD cells = hn::Set(d, axis.cells);
    VD cell;
    if constexpr (kAddress == Address::Repeat) {
        cell = hn::Sub(first, hn::Mul(hn::Floor(hn::Div(hn::Sub(first, low), cells)), cells));
    } else {
        cell = hn::Min(hn::Max(first, low), hn::Add(low, hn::Sub(cells, hn::Set(d, 1.0))));
    }
    MD gone = hn::MaskFromVec(zero);
    if constexpr (kAddress == Address::Border) {
        // No margin is needed. begin == 0: the position is the start itself, so `left` and inside(start) exclude each
        // other. begin > 0: every hit is at least kStartSlack later, and by then a ray whose position was rounded
        // beyond the rim has crossed it.
        const VD rimLow = hn::Set(d, axis.low), rimHigh = hn::Set(d, axis.high);
        const auto inside = [&](VD at) { return hn::And(hn::Gt(at, rimLow), hn::Lt(at, rimHigh)); };
        const MD left = hn::Or(hn::Lt(place, rimLow), hn::Gt(place, rimHigh));
        gone = hn::And(hn::And(good, inside(start)), left);
        good = hn::And(good, hn::Or(gone, hn::And(inside(start), inside(place))));
        const VD rim =
            hn::IfThenElse(mirrored, hn::Sub(start, hn::Set(d, axis.low)), hn::Sub(hn::Set(d, axis.high), start));
        hn::StoreU(hn::DemoteTo(df, hn::IfThenElseZero(good, rim)), df, out.rim.data() + i);
    }
    const auto whole = [&](VD v) { return hn::DemoteTo(di, hn::IfThenElseZero(good, v)); };
    hn::StoreU(whole(first), di, out.first.data() + i);
    hn::StoreU(whole(cell), di, out.cell.data() + i);
    hn::StoreU(hn::Zero(di), di, out.hitCell.data() + i);
    hn::StoreU(hn::Zero(di), di, out.hitPlace.data() + i);
    hn::StoreU(hn::DemoteTo(df, hn::IfThenElseZero(good, run)), df, out.run.data() + i);
    hn::StoreU(hn::DemoteTo(df, hn::IfThenElseZero(good, share)), df, out.base.data() + i);
    return {good, gone};
}

// One axis of inverses and margins, in float. Returns the margin of its crossings.
template <Address kAddress>
HWY_INLINE VF setUpCrossings(VF start, std::size_t i, LaneAxisRays& out) {
    const DF d;
    const VF run = hn::Abs(hn::Load(d, out.run.data() + i));
    const VF inverse = hn::Div(hn::Set(d, 1.0F), hn::Max(run, hn::Set(d, 1e-30F)));
    const VF margin = hn::Mul(hn::Set(d, kCrossingMargin), hn::Add(inverse, hn::Set(d, 1.0F)));
    const VF share = hn::Load(d, out.base.data() + i);
    hn::Store(inverse, d, out.inverse.data() + i);
    // Converted from texels to lambda; up to lambda 1 the error is less than the margin.
    if constexpr (kAddress == Address::Border) {
        const VF rim = hn::Mul(hn::Load(d, out.rim.data() + i), inverse);
        hn::Store(hn::Min(rim, hn::Set(d, 1e30F)), d, out.rim.data() + i);
    }
    hn::Store(hn::Add(hn::Sub(start, hn::Mul(share, inverse)), margin), d, out.base.data() + i);
    return margin;
}

// Both axes of the rays [i, i + kHalfLanes), and the results of those that float cannot walk or need not.
template <Address kAddress>
HWY_INLINE void setUpRays(const FloatScene& scene, const double* s0, const double* t0, const double* a, const double* b,
                          double begin, std::size_t i, LaneRays& rays) {
    const DHI di;
    const DD d;
    const Fitness x = setUpPlaces<kAddress>(scene, scene.grid.x, s0, a, begin, i, rays.x);
    const Fitness y = setUpPlaces<kAddress>(scene, scene.grid.y, t0, b, begin, i, rays.y);
    const auto code = [&](LaneEnd which) { return hn::Set(d, static_cast<double>(which)); };
    const VD kept = hn::IfThenElseZero(hn::Or(x.gone, y.gone), code(LaneEnd::Miss));
    const VD end = hn::IfThenElse(hn::And(x.fit, y.fit), kept, code(LaneEnd::Scalar));
    hn::StoreU(hn::DemoteTo(di, end), di, rays.end.data() + i);
}

// Sets up the rays.count rays, whose group starts are in rays.start. The arrays are padded to whole vectors with rays
// that are not walked.
template <Address kAddress>
void setUpLanes(const FloatScene& scene, const double* s0, const double* t0, const double* a, const double* b,
                LaneRays& rays) {
    const std::size_t count = rays.count;
    const auto setUp = [&](const double* s, const double* t, const double* ra, const double* rb, std::size_t from,
                           std::size_t to, LaneRays& out) {
        for (std::size_t i = from; i < to; i += kHalfLanes) {
            setUpRays<kAddress>(scene, s, t, ra, rb, out.start[i / kLaneGroup], i, out);
        }
    };
    const std::size_t whole = count - count % kHalfLanes;
    setUp(s0, t0, a, b, 0, whole, rays);
    const std::size_t filled = hwy::RoundUpTo(count, kLanes);
    if (whole < filled) {
        // The remainder is set up from padded copies.
        std::array<std::array<double, 2 * kLanes>, 4> rest{};
        const double* const columns[] = {s0, t0, a, b};
        for (std::size_t c = 0; c < rest.size(); ++c)
            std::copy(columns[c] + whole, columns[c] + count, rest[c].begin());
        const auto place = [&](std::size_t c) { return rest[c].data() - whole; };
        setUp(place(0), place(1), place(2), place(3), whole, filled, rays);
        for (std::size_t i = count; i < filled; ++i) rays.end[i] = static_cast<std::int32_t>(LaneEnd::Scalar);
    }
    const DF d;
    for (std::size_t i = 0; i < filled; i += kLanes) {
        const VF start = hn::Set(d, static_cast<float>(rays.start[i / kLaneGroup]));
        hn::Store(start, d, rays.begin.data() + i);
        const VF margins =
            hn::Add(setUpCrossings<kAddress>(start, i, rays.x), setUpCrossings<kAddress>(start, i, rays.y));
        hn::Store(hn::Mul(hn::Set(d, 2.0F), margins), d, rays.tie.data() + i);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
