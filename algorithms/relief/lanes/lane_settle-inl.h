// The one leaf in lanes of double, operation by operation: the hits of the candidates that a walk has found. Shared by
// the kernels, compiled for each target.

#if defined(RELIEF_LANE_SETTLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_SETTLE_INL_H
#undef RELIEF_LANE_SETTLE_INL_H
#else
#define RELIEF_LANE_SETTLE_INL_H
#endif

#include <optional>
#include "relief/lanes/lane_leaf-inl.h"

#include "relief/leaf.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

struct ExactAxis {
    VD start, run, inverse;
    MD forward, still;
    VD base;  // the cell's period
    VD index;
};

template <Address kAddress>
HWY_INLINE ExactAxis exactAxis(const LaneScene& scene, const GridAxis& axis, const double* origins, const double* runs,
                               const LaneAxisRays& lanes, std::size_t i) {
    const DD d;
    const DHI di;
    ExactAxis out;
    const VD zero = hn::Zero(d);
    const VD s = reducedOrigins<kAddress>(axis, origins + i);
    const VD given = hn::LoadU(d, runs + i);
    out.start = hn::Add(s, hn::Set(d, axis.shift));
    out.run = hn::IfThenZeroElse(hn::Lt(hn::Abs(given), hn::Set(d, 1e-300)), given);
    out.still = hn::Eq(out.run, zero);
    out.forward = hn::Gt(out.run, zero);
    out.inverse = hn::IfThenZeroElse(out.still, hn::Div(hn::Set(d, 1.0), out.run));
    out.index = hn::PromoteTo(d, hn::LoadU(di, lanes.hitCell.data() + i));
    out.base = zero;
    if constexpr (kAddress == Address::Repeat) {
        const VD first = hn::PromoteTo(d, hn::LoadU(di, lanes.first.data() + i));
        const VD along = hn::Add(first, hn::PromoteTo(d, hn::LoadU(di, lanes.hitPlace.data() + i)));
        const VD real = hn::IfThenElse(hn::Lt(given, zero), hn::Sub(hn::Set(d, scene.mirror - 1.0), along), along);
        out.base = hn::Sub(real, out.index);
    }
    return out;
}

template <Address kAddress>
HWY_INLINE VD exactEdge(const GridAxis& axis, const ExactAxis& ray, VD k) {
    const DD d;
    if constexpr (kAddress == Address::Repeat) return hn::Add(ray.base, k);
    VD edge = hn::IfThenElse(hn::Le(k, hn::Zero(d)), hn::Set(d, axis.low), k);
    return hn::IfThenElse(hn::Ge(k, hn::Set(d, axis.cells)), hn::Set(d, axis.high), edge);
}

// Rays of which is known that they run backwards, or that they do not; empty: not known, or they do not agree.
using Course = std::optional<bool>;

// Whether the candidates are as most are: they run somewhere, and neither side of their cell is an edge of the map.
// Then the other texts of the axis say as much as these two.
HWY_INLINE MD isPlain(const GridAxis& axis, const double* runs, const LaneAxisRays& lanes, std::size_t i) {
    const DD d;
    const VD index = hn::PromoteTo(d, hn::LoadU(DHI(), lanes.hitCell.data() + i));
    const MD inside = hn::And(hn::Gt(index, hn::Zero(d)), hn::Lt(index, hn::Set(d, axis.cells - 1.0)));
    return hn::And(inside, hn::Ge(hn::Abs(hn::LoadU(d, runs + i)), hn::Set(d, 1e-300)));
}
HWY_INLINE ExactAxis plainAxis(const GridAxis& axis, const double* origins, const double* runs,
                               const LaneAxisRays& lanes, std::size_t i) {
    const DD d;
    ExactAxis out;
    out.start = hn::Add(hn::LoadU(d, origins + i), hn::Set(d, axis.shift));
    out.run = hn::LoadU(d, runs + i);
    out.inverse = hn::Div(hn::Set(d, 1.0), out.run);
    out.index = hn::PromoteTo(d, hn::LoadU(DHI(), lanes.hitCell.data() + i));
    out.base = hn::Zero(d);
    out.forward = out.still = hn::MaskFromVec(out.base);
    return out;
}
HWY_INLINE void plainStay(const ExactAxis& ray, bool backwards, VD& in, VD& out) {
    const VD upper = hn::Add(ray.index, hn::Set(DD(), 1.0));
    const VD atLower = hn::Mul(hn::Sub(ray.index, ray.start), ray.inverse);
    const VD atUpper = hn::Mul(hn::Sub(upper, ray.start), ray.inverse);
    in = backwards ? atUpper : atLower;
    out = backwards ? atLower : atUpper;
}

// RayAxis::enter and leave, to the bit.
template <Address kAddress>
HWY_INLINE void exactStay(const GridAxis& axis, const ExactAxis& ray, VD& in, VD& out) {
    const DD d;
    const VD lower = exactEdge<kAddress>(axis, ray, ray.index);
    const VD upper = exactEdge<kAddress>(axis, ray, hn::Add(ray.index, hn::Set(d, 1.0)));
    const VD infinite = hn::Inf(d);
    const auto at = [&](VD edge) { return hn::Mul(hn::Sub(edge, ray.start), ray.inverse); };
    in = hn::IfThenElse(ray.still, hn::Neg(infinite), at(hn::IfThenElse(ray.forward, lower, upper)));
    out = hn::IfThenElse(ray.still, infinite, at(hn::IfThenElse(ray.forward, upper, lower)));
}

// std::max and std::min of these arguments, in this order: zeros keep the sign that they would have there, and so do
// what is no number.
HWY_INLINE VD stdMax(VD a, VD b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
    return hn::Max(b, a);  // b > a ? b : a
#else
    return hn::IfThenElse(hn::Lt(a, b), b, a);
#endif
}
HWY_INLINE VD stdMin(VD a, VD b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
    return hn::Min(b, a);  // b < a ? b : a
#else
    return hn::IfThenElse(hn::Lt(b, a), b, a);
#endif
}

// Heights of texels (i, j) and (i + 1, j), two in one element of a gather.
HWY_INLINE void heightPairs(const LaneScene& scene, VD i, VD j, VD& first, VD& second) {
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

// Where candidates come into their cells and leave them, before either is cut to [0, 1].
struct ExactStay {
    VD inX, outX, inY, outY;
};

// leafHit() for the candidates of [i, i + kHalfLanes): lambda, and where there is a hit at all. pair: of their nodes,
// where these lie together.
template <Address kAddress, Surface kSurface>
HWY_INLINE MD exactLeaf(const LaneScene& scene, const ExactAxis& x, const ExactAxis& y, const ExactStay& stay,
                        const std::int32_t* pair, VD& lambda) {
    const DD d;
    const DHF df;
    const DHI di;
    const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const VD in = stdMax(stdMax(stay.inX, stay.inY), zero);
    const VD out = stdMin(stdMin(stay.outX, stay.outY), one);
    const MD stays = hn::Lt(in, out);
    const auto height = [&](VD i, VD j) {
        const VD at = hn::Add(hn::Mul(j, hn::Set(d, scene.stride)), i);
        return hn::PromoteTo(d, hn::GatherIndex(df, scene.heights, hn::DemoteTo(di, at)));
    };
    if constexpr (kSurface == Surface::Columns) {
        const VD h = height(x.index, y.index);
        const MD wall = hn::Le(hn::Sub(one, in), h);
        const VD top = hn::Sub(one, h);
        const MD reached = hn::Le(top, out);
        lambda = hn::IfThenElse(wall, in, stdMax(top, in));
        return hn::And(stays, hn::Or(wall, reached));
    } else {
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
        VD h00, h10, h01, h11;
        if (scene.nodes != nullptr) {
            const auto h = nodesAt(df, scene.nodes, pair);
            h00 = hn::PromoteTo(d, h[0]), h01 = hn::PromoteTo(d, h[1]);
            h10 = hn::PromoteTo(d, h[2]), h11 = hn::PromoteTo(d, h[3]);
        } else {
            VD i0, i1, j0, j1;
            nodes(scene.grid.x, x.index, i0, i1);
            nodes(scene.grid.y, y.index, j0, j1);
            if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(i1, hn::Add(i0, one))))) {
                heightPairs(scene, i0, j0, h00, h10);
                heightPairs(scene, i0, j1, h01, h11);
            } else {
                h00 = height(i0, j0), h10 = height(i1, j0), h01 = height(i0, j1), h11 = height(i1, j1);
            }
        }
        const auto within = [&](const ExactAxis& axis, VD at) {
            const VD place = hn::Add(axis.start, hn::Mul(at, axis.run));
            const VD v = hn::Sub(place, hn::Add(axis.base, axis.index));
            // std::clamp(v, 0, 1)
            return stdMin(stdMax(v, zero), one);
        };
        const auto patch = [&](VD u, VD v) {
            const VD u1 = hn::Sub(one, u), v1 = hn::Sub(one, v);
            const VD top = hn::Add(hn::Mul(u1, h00), hn::Mul(u, h10));
            const VD bottom = hn::Add(hn::Mul(u1, h01), hn::Mul(u, h11));
            return hn::Add(hn::Mul(v1, top), hn::Mul(v, bottom));
        };
        const VD uIn = within(x, in), vIn = within(y, in), uOut = within(x, out), vOut = within(y, out);
        const VD c =
            hn::Mul(hn::Mul(hn::Sub(uOut, uIn), hn::Sub(vOut, vIn)), hn::Sub(hn::Sub(h11, h10), hn::Sub(h01, h00)));
        const VD fIn = hn::Sub(patch(uIn, vIn), hn::Sub(one, in));
        const VD fOut = hn::Sub(patch(uOut, vOut), hn::Sub(one, out));
        const MD atEntry = hn::Not(hn::Lt(fIn, zero));
        // leaf_detail::firstRoot
        const VD b = hn::Sub(hn::Sub(fOut, fIn), c);
        const MD ends = hn::Lt(fOut, zero);
        const MD arched = hn::And(hn::Lt(c, zero), hn::And(hn::Gt(b, zero), hn::Lt(b, hn::Mul(hn::Set(d, -2.0), c))));
        const VD four = hn::Mul(hn::Set(d, 4.0), c);
        const VD discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(four, fIn));
        const MD none = hn::Or(hn::AndNot(arched, ends), hn::And(hn::Lt(discriminant, zero), ends));
        const VD root = hn::Sqrt(hn::IfThenElse(hn::Lt(discriminant, zero), zero, discriminant));
        const MD rising = hn::Ge(b, zero);
        const VD above = hn::IfThenElse(rising, hn::Mul(hn::Set(d, -2.0), fIn), hn::Sub(root, b));
        const VD below = hn::IfThenElse(rising, hn::Add(b, root), hn::Mul(hn::Set(d, 2.0), c));
        const VD w = hn::Div(above, below);
        const VD share = stdMin(one, w);
        const VD met = hn::Add(in, hn::Mul(share, hn::Sub(out, in)));
        lambda = hn::IfThenElse(atEntry, in, stdMin(met, out));
        return hn::And(stays, hn::Or(atEntry, hn::Not(none)));
    }
}

// Lambda before which those that are refused meet nothing: walks come to a cell at most so much later, cells, than
// the ray does.
HWY_INLINE VD metNothingBefore(const ExactAxis& x, const ExactAxis& y, const ExactStay& stay) {
    const DD d;
    constexpr double kLate = 0x1p-16;
    const VD in = hn::Min(hn::Max(stay.inX, stay.inY), hn::Min(stay.outX, stay.outY));
    const VD late = hn::MulAdd(hn::Add(hn::Abs(x.inverse), hn::Abs(y.inverse)), hn::Set(d, kLate), hn::Set(d, kLate));
    const VD from = hn::Sub(in, late);
    return hn::IfThenElseZero(hn::Gt(from, hn::Zero(d)), from);
}

// Those of rays [i, i + here) that are no hits; the refused go on from there.
HWY_NOINLINE inline void noteOthers(VD settled, MD refused, VD from, std::size_t i, std::size_t here, LaneRays& rays) {
    HWY_ALIGN double ends[kHalfLanes], starts[kHalfLanes];
    hn::Store(settled, DD(), ends);
    hn::Store(hn::IfThenElseZero(refused, from), DD(), starts);
    for (std::size_t n = 0; n < here; ++n) {
        if (ends[n] == 0) continue;
        rays.others[rays.othersCount++] = {static_cast<std::uint32_t>(i + n), static_cast<LaneEnd>(ends[n]), starts[n]};
    }
}

// The hits of the candidates among rays [first, last) of the chunk, to `hits` from firstHit + first on; a candidate
// that the leaf refuses is left to the scalar text. Rays that are no hits are added to rays.others.
template <Address kAddress, Surface kSurface>
void settleLanes(const LaneScene& scene, const double* const* given, std::size_t first, std::size_t last,
                 Course backwardsX, Course backwardsY, LaneRays& rays, HitBlock& hits, std::size_t firstHit) {
    const DD d;
    const DHI di;
    // Lanes behind the last ray: in some cell of the map, for its heights are read.
    for (LaneAxisRays* axis : {&rays.x, &rays.y}) {
        hn::StoreU(hn::Zero(DI()), DI(), axis->hitCell.data() + last);
    }
    // First all of them: written as vectors, read lane by lane.
    alignas(64) std::array<std::int32_t, kLaneSlots> pairs;
    if (scene.nodes != nullptr) {
        const DI dv;
        for (std::size_t i = first; i < last; i += kLanes) {
            const VI row = hn::Mul(hn::LoadU(dv, rays.y.hitCell.data() + i), hn::Set(dv, scene.nodeStride));
            hn::StoreU(hn::Add(row, hn::LoadU(dv, rays.x.hitCell.data() + i)), dv, pairs.data() + i);
        }
    }
    const bool known = kAddress != Address::Repeat && backwardsX.has_value() && backwardsY.has_value();
    for (std::size_t i = first; i < last; i += kHalfLanes) {
        const std::size_t here = std::min(kHalfLanes, last - i);
        std::array<std::array<double, kHalfLanes>, 4> rest{};
        const double* columns[] = {given[0], given[1], given[2], given[3]};
        if (here < kHalfLanes) {
            for (std::size_t c = 0; c < rest.size(); ++c) {
                std::copy(columns[c] + i, columns[c] + i + here, rest[c].begin());
                columns[c] = rest[c].data() - i;
            }
        }
        ExactAxis x, y;
        ExactStay stay;
        if (known && HWY_LIKELY(hn::AllTrue(d, hn::And(isPlain(scene.grid.x, columns[2], rays.x, i),
                                                       isPlain(scene.grid.y, columns[3], rays.y, i))))) {
            x = plainAxis(scene.grid.x, columns[0], columns[2], rays.x, i);
            y = plainAxis(scene.grid.y, columns[1], columns[3], rays.y, i);
            plainStay(x, *backwardsX, stay.inX, stay.outX);
            plainStay(y, *backwardsY, stay.inY, stay.outY);
        } else {
            x = exactAxis<kAddress>(scene, scene.grid.x, columns[0], columns[2], rays.x, i);
            y = exactAxis<kAddress>(scene, scene.grid.y, columns[1], columns[3], rays.y, i);
            exactStay<kAddress>(scene.grid.x, x, stay.inX, stay.outX);
            exactStay<kAddress>(scene.grid.y, y, stay.inY, stay.outY);
        }
        VD lambda;
        const MD hit = exactLeaf<kAddress, kSurface>(scene, x, y, stay, pairs.data() + i, lambda);
        const VD end = hn::PromoteTo(d, hn::LoadU(di, rays.end.data() + i));
        const MD refused = hn::AndNot(hit, hn::Eq(end, hn::Zero(d)));
        const VD settled = hn::IfThenElse(refused, hn::Set(d, static_cast<double>(LaneEnd::Scalar)), end);
        if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Eq(settled, hn::Zero(d))))) {
            noteOthers(settled, refused, metNothingBefore(x, y, stay), i, here, rays);
        }
        const VD s = hn::Add(hn::LoadU(d, columns[0] + i), hn::Mul(lambda, hn::LoadU(d, columns[2] + i)));
        const VD t = hn::Add(hn::LoadU(d, columns[1] + i), hn::Mul(lambda, hn::LoadU(d, columns[3] + i)));
        const auto give = [&](VD v, std::vector<double>& to) {
            if (here == kHalfLanes) {
                hn::StoreU(v, d, to.data() + firstHit + i);
            } else {
                HWY_ALIGN double values[kHalfLanes];
                hn::Store(v, d, values);
                std::copy_n(values, here, to.data() + firstHit + i);
            }
        };
        give(lambda, hits.lambda), give(s, hits.s), give(t, hits.t);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
