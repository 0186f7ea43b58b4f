// The hits of the candidates that a walk has found, by the leaf in lanes of double. Shared by the kernels, compiled for
// each target.

#if defined(RELIEF_LANE_SETTLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_SETTLE_INL_H
#undef RELIEF_LANE_SETTLE_INL_H
#else
#define RELIEF_LANE_SETTLE_INL_H
#endif

#include "relief/lanes/exact_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// leafHit() for the candidates of a chunk, in four parts, each some rays behind the part before it: the parts are long
// chains, of roots and quotients, and those of different rays then overlap.
template <Address kAddress, Surface kSurface>
class Settling {
  public:
    Settling(const LaneScene& scene, const double* const* given, std::size_t count, LaneRays& rays)
        : scene_(scene), given_(given), count_(count), rays_(rays) {
        const std::size_t rest = count % kHalfLanes;
        for (std::size_t c = 0; c < rest_.size() && rest > 0; ++c) {
            std::fill(std::copy_n(given[c] + count - rest, rest, rest_[c].begin()), rest_[c].end(), 0.0);
        }
        const DI dv;
        // Lanes behind the last ray: in some cell of the map, for its heights are read.
        for (LaneAxisRays* axis : {&rays.x, &rays.y}) hn::StoreU(hn::Zero(dv), dv, axis->hitCell.data() + count);
        if (scene.nodes == nullptr) return;
        // First all of them: written as vectors, read lane by lane.
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
                askForHits(i + kAsked, hits, firstHit);
                stays(i);
            }
            if (due(1)) gaps(from(1));
            if (due(2)) shares(from(2));
            if (due(3)) meet(from(3), hits, firstHit);
        }
    }

  private:
    // Rays between the parts; rows hold those that are under way, and stay in the first cache.
    static constexpr std::size_t kApart = 16, kUnderWay = 4 * kApart;
    static constexpr std::size_t kAsked = 192;
    using Row = std::array<double, kUnderWay>;
    static constexpr std::size_t kOriginX = 0, kOriginY = 1, kRunX = 2, kRunY = 3;
    static_assert(kHalfLanes <= kApart && kApart % kHalfLanes == 0);

    HWY_INLINE static void keep(VD v, std::size_t i, Row& row) { hn::Store(v, DD(), row.data() + i % kUnderWay); }
    HWY_INLINE static VD kept(std::size_t i, const Row& row) { return hn::Load(DD(), row.data() + i % kUnderWay); }

    // The places of later rays' hits, of the next chunk's as well: they are written without having been read.
    HWY_INLINE void askForHits(std::size_t from, HitBlock& hits, std::size_t firstHit) const {
        if (firstHit + from + kHalfLanes > hits.size()) return;
        for (auto* column : {&hits.lambda, &hits.s, &hits.t}) __builtin_prefetch(column->data() + firstHit + from, 1);
    }

    // The given column c from ray i on, a whole vector.
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
    HWY_INLINE ExactStay stayOf(std::size_t i, ExactAxis& x, ExactAxis& y) const {
        const bool isPlain = plain(i);
        axes(i, isPlain, x, y);
        invert(x), invert(y);
        ExactStay stay;
        if (HWY_LIKELY(isPlain)) {
            plainStay(x, stay.inX, stay.outX);
            plainStay(y, stay.inY, stay.outY);
        } else {
            exactStay<kAddress>(scene_.grid.x, x, stay.inX, stay.outX);
            exactStay<kAddress>(scene_.grid.y, y, stay.inY, stay.outY);
        }
        return stay;
    }

    // An axis as the gaps need it.
    struct AxisRows {
        alignas(64) Row start, run, index;
        alignas(64) Row base;  // where the map repeats
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

    HWY_INLINE void stays(std::size_t i) {
        ExactAxis x, y;
        const ExactStay stay = stayOf(i, x, y);
        keep(entryOf(stay), i, in_);
        keep(exitOf(stay), i, out_);
        if constexpr (kSurface == Surface::Bilinear) keepAxis(x, i, x_), keepAxis(y, i, y_);
    }

    HWY_INLINE void gaps(std::size_t i) {
        if constexpr (kSurface == Surface::Bilinear) {
            const ExactAxis x = keptAxis(i, x_), y = keptAxis(i, y_);
            const ExactNodes nodes = exactNodes<kAddress>(scene_, x.index, y.index, pairs_.data() + i);
            const ExactGaps gaps = exactGaps(nodes, x, y, kept(i, in_), kept(i, out_));
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

    HWY_INLINE void meet(std::size_t i, HitBlock& hits, std::size_t firstHit) {
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

    // Those from ray i on that are no hits.
    HWY_NOINLINE void noteOthers(std::size_t i, VD end, MD refused) {
        const DD d;
        HWY_ALIGN double ends[kHalfLanes];
        hn::Store(hn::IfThenElse(refused, hn::Set(d, static_cast<double>(LaneEnd::Refused)), end), d, ends);
        for (std::size_t n = 0; n < std::min(kHalfLanes, count_ - i); ++n) {
            if (ends[n] == 0) continue;
            rays_.others[rays_.othersCount++] = {static_cast<std::uint32_t>(i + n), static_cast<LaneEnd>(ends[n])};
        }
    }

    const LaneScene& scene_;
    const double* const* given_;
    const std::size_t count_;
    LaneRays& rays_;
    std::array<std::array<double, kHalfLanes>, 4> rest_{};
    alignas(64) std::array<std::int32_t, kLaneSlots> pairs_;
    AxisRows x_, y_;
    alignas(64) Row in_, out_, gapIn_, gapOut_, bend_, above_, below_;
    // A mask's bits where its vector begins; eight bytes are read of it.
    std::array<std::uint8_t, kUnderWay + 8> hit_;
};

// The hits of the candidates among the chunk's rays, to `hits` from firstHit on; a candidate that the leaf refuses is
// LaneEnd::Refused. Rays that are no hits are added to rays.others.
template <Address kAddress, Surface kSurface>
HWY_NOINLINE void settleLanes(const LaneScene& scene, const double* const* given, LaneRays& rays, HitBlock& hits,
                              std::size_t firstHit) {
    Settling<kAddress, kSurface>(scene, given, rays.count, rays).run(hits, firstHit);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
