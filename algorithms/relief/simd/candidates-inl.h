// Candidate intersections are resolved: SIMD version, in double, of the leaf for the candidate cells that a walk has
// found. Shared by the kernels; compiled for each target.

#if defined(RELIEF_CANDIDATES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CANDIDATES_INL_H
#undef RELIEF_CANDIDATES_INL_H
#else
#define RELIEF_CANDIDATES_INL_H
#endif

#include "relief/simd/exact_leaf-inl.h"
#include "relief/simd/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// One axis of candidates: RayAxis, and the candidate cell.
struct ExactAxis {
    VD start, run;
    VD inverse;  // set by invert()
    MD forward, still;
    VD base;  // first cell of the cell's period
    VD index;
};

template <Address kAddress>
HWY_INLINE ExactAxis exactAxis(const GridAxis& axis, const double* origins, const double* runs,
                               const LaneAxisRays& lanes, std::size_t i) {
    const DD d;
    const DHI di;
    ExactAxis out;
    const VD zero = hn::Zero(d);
    const VD s = reducedOrigins<kAddress>(axis, origins);
    const VD given = hn::LoadU(d, runs);
    out.start = hn::Add(s, hn::Set(d, axis.shift));
    out.run = hn::IfThenZeroElse(hn::Lt(hn::Abs(given), hn::Set(d, 1e-300)), given);
    out.still = hn::Eq(out.run, zero);
    out.forward = hn::Gt(out.run, zero);
    out.index = hn::PromoteTo(d, hn::LoadU(di, lanes.hitCell.data() + i));
    out.base = zero;
    if constexpr (kAddress == Address::Repeat) {
        out.base = hn::PromoteTo(d, hn::LoadU(di, lanes.hitPeriod.data() + i));
    }
    return out;
}

HWY_INLINE void invert(ExactAxis& axis) {
    axis.inverse = hn::IfThenZeroElse(axis.still, hn::Div(hn::Set(DD(), 1.0), axis.run));
}

template <Address kAddress>
HWY_INLINE VD exactEdge(const GridAxis& axis, const ExactAxis& ray, VD k) {
    const DD d;
    if constexpr (kAddress == Address::Repeat) return hn::Add(ray.base, k);
    VD edge = hn::IfThenElse(hn::Le(k, hn::Zero(d)), hn::Set(d, axis.low), k);
    return hn::IfThenElse(hn::Ge(k, hn::Set(d, axis.cells)), hn::Set(d, axis.high), edge);
}

// True for candidates that move along the axis and whose cell does not touch an edge of the map, as most do. For these,
// plainAxis() and plainInterval() return the same bits as the general functions.
HWY_INLINE MD isPlain(const GridAxis& axis, const double* runs, const LaneAxisRays& lanes, std::size_t i) {
    const DD d;
    const VD index = hn::PromoteTo(d, hn::LoadU(DHI(), lanes.hitCell.data() + i));
    const MD inside = hn::And(hn::Gt(index, hn::Zero(d)), hn::Lt(index, hn::Set(d, axis.cells - 1.0)));
    return hn::And(inside, hn::Ge(hn::Abs(hn::LoadU(d, runs)), hn::Set(d, 1e-300)));
}
HWY_INLINE ExactAxis plainAxis(const GridAxis& axis, const double* origins, const double* runs,
                               const LaneAxisRays& lanes, std::size_t i) {
    const DD d;
    ExactAxis out;
    out.start = hn::Add(hn::LoadU(d, origins), hn::Set(d, axis.shift));
    out.run = hn::LoadU(d, runs);
    out.index = hn::PromoteTo(d, hn::LoadU(DHI(), lanes.hitCell.data() + i));
    out.base = hn::Zero(d);
    out.forward = hn::Gt(out.run, out.base);
    out.still = hn::MaskFromVec(out.base);
    return out;
}
HWY_INLINE void plainInterval(const ExactAxis& ray, VD& in, VD& out) {
    const VD upper = hn::Add(ray.index, hn::Set(DD(), 1.0));
    const VD atLower = hn::Mul(hn::Sub(ray.index, ray.start), ray.inverse);
    const VD atUpper = hn::Mul(hn::Sub(upper, ray.start), ray.inverse);
    in = hn::IfThenElse(ray.forward, atLower, atUpper);
    out = hn::IfThenElse(ray.forward, atUpper, atLower);
}

// RayAxis::enter and leave, with the same bits.
template <Address kAddress>
HWY_INLINE void exactInterval(const GridAxis& axis, const ExactAxis& ray, VD& in, VD& out) {
    const DD d;
    const VD lower = exactEdge<kAddress>(axis, ray, ray.index);
    const VD upper = exactEdge<kAddress>(axis, ray, hn::Add(ray.index, hn::Set(d, 1.0)));
    const VD infinite = hn::Inf(d);
    const auto at = [&](VD edge) { return hn::Mul(hn::Sub(edge, ray.start), ray.inverse); };
    in = hn::IfThenElse(ray.still, hn::Neg(infinite), at(hn::IfThenElse(ray.forward, lower, upper)));
    out = hn::IfThenElse(ray.still, infinite, at(hn::IfThenElse(ray.forward, upper, lower)));
}

// Heights of the texels (i, j) and (i + 1, j); where possible both in one element of a gather.
HWY_INLINE void heightPairs(const FloatScene& scene, VD i, VD j, VD& first, VD& second) {
    const DD d;
    const DHF df;
    const hn::RebindToSigned<DD> d64;
    const VD at = hn::Add(hn::Mul(j, hn::Set(d, scene.stride)), i);
#if HWY_TARGET <= HWY_AVX2
    const auto bytes = hn::ShiftLeft<2>(hn::PromoteTo(d64, hn::DemoteTo(DHI(), at)));
    const auto pairs = hn::GatherOffset(d64, reinterpret_cast<const std::int64_t*>(scene.heights), bytes);
    const hn::RebindToUnsigned<DD> du;
    const hn::Rebind<std::uint32_t, DD> dhu;
    const auto words = hn::BitCast(du, pairs);
    const auto half = [&](auto wide) { return hn::PromoteTo(d, hn::BitCast(df, hn::TruncateTo(dhu, wide))); };
    first = half(words);
    second = half(hn::ShiftRight<32>(words));
#else
    (void)d64;
    const auto index = hn::DemoteTo(DHI(), at);
    first = hn::PromoteTo(d, hn::GatherIndex(df, scene.heights, index));
    second = hn::PromoteTo(d, hn::GatherIndex(df, scene.heights + 1, index));
#endif
}

// leaf_detail::within().
HWY_INLINE VD within(const ExactAxis& axis, VD lambda) {
    const VD place = hn::Add(axis.start, hn::Mul(lambda, axis.run));
    const VD v = hn::Sub(place, hn::Add(axis.base, axis.index));
    return stdMin(stdMax(v, hn::Zero(DD())), hn::Set(DD(), 1.0));
}

// Lambda at which candidates enter and leave their cells on each axis, not clamped to [0, 1].
struct ExactInterval {
    VD inX, outX, inY, outY;
};

// Entry and exit of the interval clamped to [0, 1], with the semantics of std::max and std::min.
HWY_INLINE VD entryOf(const ExactInterval& interval) {
    return stdMax(stdMax(interval.inX, interval.inY), hn::Zero(DD()));
}
HWY_INLINE VD exitOf(const ExactInterval& interval) {
    return stdMin(stdMin(interval.outX, interval.outY), hn::Set(DD(), 1.0));
}

// For scenes whose heights are not gathered.
HWY_NOINLINE inline ExactNodes exactNodesApart(const FloatScene& scene, VD i0, VD i1, VD j0, VD j1) {
    const DD d;
    const DHI di;
    const auto all = hn::Not(hn::MaskFromVec(hn::Zero(di)));
    const FourHeights<DHF> four = fourHeights(DHF(), scene, all, hn::DemoteTo(di, i0), hn::DemoteTo(di, i1),
                                              hn::DemoteTo(di, j0), hn::DemoteTo(di, j1));
    ExactNodes out;
    out.h00 = hn::PromoteTo(d, four.h00), out.h10 = hn::PromoteTo(d, four.h10);
    out.h01 = hn::PromoteTo(d, four.h01), out.h11 = hn::PromoteTo(d, four.h11);
    return out;
}
HWY_INLINE VD exactHeight(const FloatScene& scene, VD i, VD j) {
    const DD d;
    if (HWY_UNLIKELY(!scene.gathered)) return exactNodesApart(scene, i, i, j, j).h00;
    const VD at = hn::Add(hn::Mul(j, hn::Set(d, scene.stride)), i);
    return hn::PromoteTo(d, hn::GatherIndex(DHF(), scene.heights, hn::DemoteTo(DHI(), at)));
}

// pair: index of each cell's four heights in scene.nodes, if that is not null.
template <Address kAddress>
HWY_INLINE ExactNodes exactNodes(const FloatScene& scene, VD cellX, VD cellY, const std::int32_t* pair) {
    const DD d;
    const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
    ExactNodes out;
    if (scene.nodes != nullptr) {
        const auto h = nodesAt(DHF(), scene.nodes, pair);
        out.h00 = hn::PromoteTo(d, h[0]), out.h01 = hn::PromoteTo(d, h[1]);
        out.h10 = hn::PromoteTo(d, h[2]), out.h11 = hn::PromoteTo(d, h[3]);
        return out;
    }
    const auto nodes = [&](const GridAxis& axis, VD cell, VD& before, VD& after) {
        if constexpr (kAddress == Address::Repeat) {
            before = cell;
            after = hn::Add(cell, one);
            after = hn::IfThenZeroElse(hn::Eq(after, hn::Set(d, axis.texels)), after);
        } else {
            before = hn::Max(hn::Sub(cell, one), zero);
            after = hn::Min(cell, hn::Set(d, axis.texels - 1.0));
        }
    };
    VD i0, i1, j0, j1;
    nodes(scene.grid.x, cellX, i0, i1);
    nodes(scene.grid.y, cellY, j0, j1);
    if (HWY_UNLIKELY(!scene.gathered)) return exactNodesApart(scene, i0, i1, j0, j1);
    if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(i1, hn::Add(i0, one))))) {
        heightPairs(scene, i0, j0, out.h00, out.h10);
        heightPairs(scene, i0, j1, out.h01, out.h11);
    } else {
        out.h00 = exactHeight(scene, i0, j0), out.h10 = exactHeight(scene, i1, j0);
        out.h01 = exactHeight(scene, i0, j1), out.h11 = exactHeight(scene, i1, j1);
    }
    return out;
}

// leafHit() for the candidates of a chunk, in four stages, each kApart rays behind the previous one. The stages are
// long dependency chains of roots and quotients; in this way those of different rays overlap.
template <Address kAddress, Surface kSurface>
class CandidateResolver {
  public:
    CandidateResolver(const FloatScene& scene, const double* const* given, std::size_t count, LaneRays& rays)
        : scene_(scene), given_(given), count_(count), rays_(rays) {
        const std::size_t rest = count % kHalfLanes;
        for (std::size_t c = 0; c < rest_.size() && rest > 0; ++c) {
            std::fill(std::copy_n(given[c] + count - rest, rest, rest_[c].begin()), rest_[c].end(), 0.0);
        }
        const DI dv;
        // Lanes beyond the last ray need some cell of the map, since its heights are fetched.
        for (LaneAxisRays* axis : {&rays.x, &rays.y}) hn::StoreU(hn::Zero(dv), dv, axis->hitCell.data() + count);
        if (scene.nodes == nullptr) return;
        // All indices are computed before the first is used: they are stored as vectors and loaded lane by lane, which
        // stalls soon after the store.
        for (std::size_t i = 0; i < count; i += kLanes) {
            const VI row = hn::Mul(hn::Load(dv, rays.y.hitCell.data() + i), hn::Set(dv, scene.nodeStride));
            hn::Store(hn::Add(row, hn::Load(dv, rays.x.hitCell.data() + i)), dv, pairs_.data() + i);
        }
    }

    void run(HitBlock& hits, std::size_t firstHit) {
        const std::size_t end = hwy::RoundUpTo(count_, kHalfLanes);
        for (std::size_t i = 0; i < end + 3 * kApart; i += kHalfLanes) {
            const auto from = [&](std::size_t parts) { return i - parts * kApart; };
            const auto due = [&](std::size_t parts) { return i >= parts * kApart && from(parts) < end; };
            if (due(0)) {
                prefetchHits(i + kPrefetched, hits, firstHit);
                intervals(i);
            }
            if (due(1)) gaps(from(1));
            if (due(2)) shares(from(2));
            if (due(3)) finishHits(from(3), hits, firstHit);
        }
    }

  private:
    // Rays between two stages. The rows hold the rays in flight and fit into L1.
    static constexpr std::size_t kApart = 16, kUnderWay = 4 * kApart;
    static constexpr std::size_t kPrefetched = 192;
    using Row = std::array<double, kUnderWay>;
    static constexpr std::size_t kOriginX = 0, kOriginY = 1, kRunX = 2, kRunY = 3;
    static_assert(kHalfLanes <= kApart && kApart % kHalfLanes == 0);

    HWY_INLINE static void keep(VD v, std::size_t i, Row& row) { hn::Store(v, DD(), row.data() + i % kUnderWay); }
    HWY_INLINE static VD kept(std::size_t i, const Row& row) { return hn::Load(DD(), row.data() + i % kUnderWay); }

    // Prefetches the places of later rays' hits, also those of the next chunk, because they are written without having
    // been read.
    HWY_INLINE void prefetchHits(std::size_t from, HitBlock& hits, std::size_t firstHit) const {
        if (firstHit + from + kHalfLanes > hits.size()) return;
        for (auto* column : {&hits.lambda, &hits.s, &hits.t}) __builtin_prefetch(column->data() + firstHit + from, 1);
    }

    // Column c of the given rays from ray i on, as a whole vector.
    HWY_INLINE const double* column(std::size_t c, std::size_t i) const {
        return HWY_LIKELY(i + kHalfLanes <= count_) ? given_[c] + i : rest_[c].data();
    }
    HWY_INLINE bool plain(std::size_t i) const {
        if constexpr (kAddress == Address::Repeat) return false;
        return hn::AllTrue(DD(), hn::And(isPlain(scene_.grid.x, column(kRunX, i), rays_.x, i),
                                         isPlain(scene_.grid.y, column(kRunY, i), rays_.y, i)));
    }
    HWY_INLINE void axes(std::size_t i, bool plain, ExactAxis& x, ExactAxis& y) const {
        const GridAxis &gridX = scene_.grid.x, &gridY = scene_.grid.y;
        const double *originX = column(kOriginX, i), *originY = column(kOriginY, i);
        const double *runX = column(kRunX, i), *runY = column(kRunY, i);
        if (HWY_LIKELY(plain)) {
            x = plainAxis(gridX, originX, runX, rays_.x, i);
            y = plainAxis(gridY, originY, runY, rays_.y, i);
        } else {
            x = exactAxis<kAddress>(gridX, originX, runX, rays_.x, i);
            y = exactAxis<kAddress>(gridY, originY, runY, rays_.y, i);
        }
    }
    HWY_INLINE ExactInterval intervalOf(std::size_t i, ExactAxis& x, ExactAxis& y) const {
        const bool isPlain = plain(i);
        axes(i, isPlain, x, y);
        invert(x), invert(y);
        ExactInterval interval;
        if (HWY_LIKELY(isPlain)) {
            plainInterval(x, interval.inX, interval.outX);
            plainInterval(y, interval.inY, interval.outY);
        } else {
            exactInterval<kAddress>(scene_.grid.x, x, interval.inX, interval.outX);
            exactInterval<kAddress>(scene_.grid.y, y, interval.inY, interval.outY);
        }
        return interval;
    }

    // An axis as stored for the stage gaps().
    struct AxisRows {
        alignas(64) Row start, run, index;
        alignas(64) Row base;  // only under repeat
    };
    HWY_INLINE static void keepAxis(const ExactAxis& axis, std::size_t i, AxisRows& rows) {
        keep(axis.start, i, rows.start);
        keep(axis.run, i, rows.run);
        keep(axis.index, i, rows.index);
        if constexpr (kAddress == Address::Repeat) keep(axis.base, i, rows.base);
    }
    HWY_INLINE static ExactAxis keptAxis(std::size_t i, const AxisRows& rows) {
        ExactAxis axis;
        axis.start = kept(i, rows.start);
        axis.run = kept(i, rows.run);
        axis.index = kept(i, rows.index);
        axis.base = kAddress == Address::Repeat ? kept(i, rows.base) : hn::Zero(DD());
        return axis;
    }

    HWY_INLINE void intervals(std::size_t i) {
        ExactAxis x, y;
        const ExactInterval interval = intervalOf(i, x, y);
        keep(entryOf(interval), i, in_);
        keep(exitOf(interval), i, out_);
        if constexpr (kSurface == Surface::Bilinear) keepAxis(x, i, x_), keepAxis(y, i, y_);
    }

    HWY_INLINE void gaps(std::size_t i) {
        if constexpr (kSurface == Surface::Bilinear) {
            const ExactAxis x = keptAxis(i, x_), y = keptAxis(i, y_);
            const ExactNodes nodes = exactNodes<kAddress>(scene_, x.index, y.index, pairs_.data() + i);
            const VD in = kept(i, in_), out = kept(i, out_), one = hn::Set(DD(), 1.0);
            const ExactPlaces places{within(x, in),  within(y, in),    within(x, out),
                                     within(y, out), hn::Sub(one, in), hn::Sub(one, out)};
            const ExactGaps gaps = exactGaps(nodes, places);
            keep(gaps.in, i, gapIn_);
            keep(gaps.out, i, gapOut_);
            keep(gaps.bend, i, bend_);
        }
    }

    HWY_INLINE void shares(std::size_t i) {
        if constexpr (kSurface == Surface::Bilinear) {
            const ExactGaps gaps{kept(i, gapIn_), kept(i, gapOut_), kept(i, bend_)};
            const ExactShare share = exactShare(gaps, kept(i, in_), kept(i, out_));
            keep(share.above, i, above_);
            keep(share.below, i, below_);
            hn::StoreMaskBits(DD(), share.hit, hit_.data() + i % kUnderWay);
        }
    }

    HWY_INLINE void finishHits(std::size_t i, HitBlock& hits, std::size_t firstHit) {
        const DD d;
        const DHI di;
        const VD in = kept(i, in_), out = kept(i, out_);
        VD lambda;
        MD hit;
        if constexpr (kSurface == Surface::Bilinear) {
            lambda = exactMeeting(kept(i, above_), kept(i, below_), in, out);
            hit = hn::LoadMaskBits(d, hit_.data() + i % kUnderWay);
        } else {
            const auto cell = [&](const LaneAxisRays& axis) {
                return hn::PromoteTo(d, hn::LoadU(di, axis.hitCell.data() + i));
            };
            hit = exactColumn(exactHeight(scene_, cell(rays_.x), cell(rays_.y)), in, out, lambda);
        }
        const VD end = hn::PromoteTo(d, hn::LoadU(di, rays_.end.data() + i));
        const MD candidate = hn::Eq(end, hn::Zero(d));
        if (HWY_UNLIKELY(!hn::AllTrue(d, hn::And(hit, candidate)))) noteOthers(i, end, hn::AndNot(hit, candidate));
        const auto place = [&](std::size_t origin, std::size_t run) {
            return hn::Add(hn::LoadU(d, column(origin, i)), hn::Mul(lambda, hn::LoadU(d, column(run, i))));
        };
        give(lambda, i, hits.lambda.data() + firstHit);
        give(place(kOriginX, kRunX), i, hits.s.data() + firstHit);
        give(place(kOriginY, kRunY), i, hits.t.data() + firstHit);
    }
    HWY_INLINE void give(VD v, std::size_t i, double* to) const {
        if (HWY_LIKELY(i + kHalfLanes <= count_)) return hn::StoreU(v, DD(), to + i);
        HWY_ALIGN double values[kHalfLanes];
        hn::Store(v, DD(), values);
        std::copy_n(values, count_ - i, to + i);
    }

    // Appends the rays from ray i on that are not hits to rays.others.
    HWY_NOINLINE void noteOthers(std::size_t i, VD end, MD rejected) {
        const DD d;
        HWY_ALIGN double ends[kHalfLanes];
        hn::Store(hn::IfThenElse(rejected, hn::Set(d, static_cast<double>(LaneEnd::FalseCandidate)), end), d, ends);
        for (std::size_t n = 0; n < std::min(kHalfLanes, count_ - i); ++n) {
            if (ends[n] == 0) continue;
            rays_.others[rays_.othersCount++] = {static_cast<std::uint32_t>(i + n), static_cast<LaneEnd>(ends[n])};
        }
    }

    const FloatScene& scene_;
    const double* const* given_;
    const std::size_t count_;
    LaneRays& rays_;
    std::array<std::array<double, kHalfLanes>, 4> rest_{};
    alignas(64) std::array<std::int32_t, kLaneSlots> pairs_;
    AxisRows x_, y_;
    alignas(64) Row in_, out_, gapIn_, gapOut_, bend_, above_, below_;
    // The bits of each vector's mask, stored at the index of its first ray. Loading a mask reads eight bytes.
    std::array<std::uint8_t, kUnderWay + 8> hit_;
};

// Resolves the candidates among the chunk's rays and writes their hits from index firstHit on. Rays that are not hits
// are appended to rays.others; a candidate that the leaf rejects becomes LaneEnd::FalseCandidate.
template <Address kAddress, Surface kSurface>
HWY_NOINLINE void resolveCandidates(const FloatScene& scene, const double* const* given, LaneRays& rays, HitBlock& hits,
                                    std::size_t firstHit) {
    CandidateResolver<kAddress, kSurface>(scene, given, rays.count, rays).run(hits, firstHit);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
