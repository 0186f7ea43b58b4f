// The one leaf in lanes of double, operation by operation: leaf.h and cell_grid.h to the bit. Compiled for each target.

#if defined(RELIEF_EXACT_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_EXACT_LEAF_INL_H
#undef RELIEF_EXACT_LEAF_INL_H
#else
#define RELIEF_EXACT_LEAF_INL_H
#endif

#include "relief/lanes/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

struct ExactAxis {
    VD start, run;
    VD inverse;  // when invert() has been there
    MD forward, still;
    VD base;  // the cell's period
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

// Whether the candidates are as most are: they run somewhere, and neither side of their cell is an edge of the map.
// Then the other texts of the axis say as much as these two.
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
HWY_INLINE void plainStay(const ExactAxis& ray, VD& in, VD& out) {
    const VD upper = hn::Add(ray.index, hn::Set(DD(), 1.0));
    const VD atLower = hn::Mul(hn::Sub(ray.index, ray.start), ray.inverse);
    const VD atUpper = hn::Mul(hn::Sub(upper, ray.start), ray.inverse);
    in = hn::IfThenElse(ray.forward, atLower, atUpper);
    out = hn::IfThenElse(ray.forward, atUpper, atLower);
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

// std::max and std::min of the stay's, cut to [0, 1].
HWY_INLINE VD entryOf(const ExactStay& stay) {
    return stdMax(stdMax(stay.inX, stay.inY), hn::Zero(DD()));
}
HWY_INLINE VD exitOf(const ExactStay& stay) {
    return stdMin(stdMin(stay.outX, stay.outY), hn::Set(DD(), 1.0));
}

// The surface minus the ray where it comes into the cell and where it leaves it, and the bend between (leaf.h).
struct ExactGaps {
    VD in, out, bend;
};

// Heights of the nodes of the candidates' cells.
struct ExactNodes {
    VD h00, h10, h01, h11;
};

HWY_INLINE VD exactHeight(const LaneScene& scene, VD i, VD j) {
    const DD d;
    const VD at = hn::Add(hn::Mul(j, hn::Set(d, scene.stride)), i);
    return hn::PromoteTo(d, hn::GatherIndex(DHF(), scene.heights, hn::DemoteTo(DHI(), at)));
}

// pair: where the nodes lie together.
template <Address kAddress>
HWY_INLINE ExactNodes exactNodes(const LaneScene& scene, VD cellX, VD cellY, const std::int32_t* pair) {
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
    if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(i1, hn::Add(i0, one))))) {
        heightPairs(scene, i0, j0, out.h00, out.h10);
        heightPairs(scene, i0, j1, out.h01, out.h11);
    } else {
        out.h00 = exactHeight(scene, i0, j0), out.h10 = exactHeight(scene, i1, j0);
        out.h01 = exactHeight(scene, i0, j1), out.h11 = exactHeight(scene, i1, j1);
    }
    return out;
}

// Bilinear surfaces.
HWY_INLINE ExactGaps exactGaps(const ExactNodes& h, const ExactAxis& x, const ExactAxis& y, VD in, VD out) {
    const DD d;
    const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const auto within = [&](const ExactAxis& axis, VD at) {
        const VD place = hn::Add(axis.start, hn::Mul(at, axis.run));
        const VD v = hn::Sub(place, hn::Add(axis.base, axis.index));
        // std::clamp(v, 0, 1)
        return stdMin(stdMax(v, zero), one);
    };
    const auto patch = [&](VD u, VD v) {
        const VD u1 = hn::Sub(one, u), v1 = hn::Sub(one, v);
        const VD top = hn::Add(hn::Mul(u1, h.h00), hn::Mul(u, h.h10));
        const VD bottom = hn::Add(hn::Mul(u1, h.h01), hn::Mul(u, h.h11));
        return hn::Add(hn::Mul(v1, top), hn::Mul(v, bottom));
    };
    const VD uIn = within(x, in), vIn = within(y, in), uOut = within(x, out), vOut = within(y, out);
    ExactGaps gaps;
    gaps.bend =
        hn::Mul(hn::Mul(hn::Sub(uOut, uIn), hn::Sub(vOut, vIn)), hn::Sub(hn::Sub(h.h11, h.h10), hn::Sub(h.h01, h.h00)));
    gaps.in = hn::Sub(patch(uIn, vIn), hn::Sub(one, in));
    gaps.out = hn::Sub(patch(uOut, vOut), hn::Sub(one, out));
    return gaps;
}

// Where there is a hit at all; then it is at the share above / below of the way from in to out, at most 1.
struct ExactShare {
    VD above, below;
    MD hit;
};
HWY_INLINE ExactShare exactShare(const ExactGaps& gaps, VD in, VD out) {
    const DD d;
    const VD zero = hn::Zero(d), c = gaps.bend;
    const MD stays = hn::Lt(in, out);
    const MD atEntry = hn::Not(hn::Lt(gaps.in, zero));
    // leaf_detail::firstRoot
    const VD b = hn::Sub(hn::Sub(gaps.out, gaps.in), c);
    const MD ends = hn::Lt(gaps.out, zero);
    const MD arched = hn::And(hn::Lt(c, zero), hn::And(hn::Gt(b, zero), hn::Lt(b, hn::Mul(hn::Set(d, -2.0), c))));
    const VD four = hn::Mul(hn::Set(d, 4.0), c);
    const VD discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(four, gaps.in));
    const MD none = hn::Or(hn::AndNot(arched, ends), hn::And(hn::Lt(discriminant, zero), ends));
    const VD root = hn::Sqrt(hn::IfThenElse(hn::Lt(discriminant, zero), zero, discriminant));
    const MD rising = hn::Ge(b, zero);
    const VD above = hn::IfThenElse(rising, hn::Mul(hn::Set(d, -2.0), gaps.in), hn::Sub(root, b));
    const VD below = hn::IfThenElse(rising, hn::Add(b, root), hn::Mul(hn::Set(d, 2.0), c));
    return {hn::IfThenZeroElse(atEntry, above), hn::IfThenElse(atEntry, hn::Set(d, 1.0), below),
            hn::And(stays, hn::Or(atEntry, hn::Not(none)))};
}
HWY_INLINE VD exactMeeting(VD above, VD below, VD in, VD out) {
    const VD w = hn::Div(above, below);
    const VD share = stdMin(hn::Set(DD(), 1.0), w);
    return stdMin(hn::Add(in, hn::Mul(share, hn::Sub(out, in))), out);
}

// The same for columns.
HWY_INLINE MD exactColumn(VD h, VD in, VD out, VD& lambda) {
    const VD one = hn::Set(DD(), 1.0);
    const MD wall = hn::Le(hn::Sub(one, in), h);
    const VD top = hn::Sub(one, h);
    const MD reached = hn::Le(top, out);
    lambda = hn::IfThenElse(wall, in, stdMax(top, in));
    return hn::And(hn::Lt(in, out), hn::Or(wall, reached));
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
