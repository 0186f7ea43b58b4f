// SIMD version of leaf.h in double, operation by operation with the same bits. Compiled for each target.

#if defined(RELIEF_EXACT_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_EXACT_LEAF_INL_H
#undef RELIEF_EXACT_LEAF_INL_H
#else
#define RELIEF_EXACT_LEAF_INL_H
#endif

#include <array>

#include "relief/cell_grid.h"
#include "relief/height_field.h"
#include "relief/simd/double_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// std::max(a, b) and std::min(a, b), also for the sign of zeros and for NaN.
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

// The surface minus the ray at the entry and exit of the cell, and the curvature in between (c in leaf.h).
struct ExactGaps {
    VD in, out, bend;
};

// Heights of the four nodes of the lanes' cells.
struct ExactNodes {
    VD h00, h10, h01, h11;
};

HWY_INLINE VD heightsAt(const FloatImage& heights, VHI i, VHI j) {
    const VHI at = hn::Add(hn::Mul(j, hn::Set(DHI(), heights.width())), i);
    return hn::PromoteTo(DD(), hn::GatherIndex(DHF(), heights.data(), at));
}

// cellCorners(). cx, cy: indices of the cells within the period.
HWY_INLINE ExactNodes cornersAt(const FloatImage& heights, const CellGrid& grid, VHI cx, VHI cy) {
    const VHI zero = hn::Zero(DHI()), one = hn::Set(DHI(), 1);
    const auto nodes = [&](const GridAxis& axis, VHI k) {
        const VHI last = hn::Set(DHI(), axis.texels - 1), next = hn::Add(k, one);
        if (axis.wraps) return std::array{k, hn::IfThenZeroElse(hn::Eq(k, last), next)};
        return std::array{hn::Max(hn::Sub(k, one), zero), hn::Min(k, last)};
    };
    const auto i = nodes(grid.x, cx), j = nodes(grid.y, cy);
    return {heightsAt(heights, i[0], j[0]), heightsAt(heights, i[1], j[0]), heightsAt(heights, i[0], j[1]),
            heightsAt(heights, i[1], j[1])};
}

// Positions in the cells, [0, 1]. z: heights of the ray there.
struct ExactPlaces {
    VD uIn, vIn, uOut, vOut;
    VD zIn, zOut;
};

// Patch of bilinear surfaces, minus the ray.
HWY_INLINE ExactGaps exactGaps(const ExactNodes& h, const ExactPlaces& at) {
    const VD one = hn::Set(DD(), 1.0);
    const auto patch = [&](VD u, VD v) {
        const VD u1 = hn::Sub(one, u), v1 = hn::Sub(one, v);
        const VD top = hn::Add(hn::Mul(u1, h.h00), hn::Mul(u, h.h10));
        const VD bottom = hn::Add(hn::Mul(u1, h.h01), hn::Mul(u, h.h11));
        return hn::Add(hn::Mul(v1, top), hn::Mul(v, bottom));
    };
    ExactGaps gaps;
    gaps.bend = hn::Mul(hn::Mul(hn::Sub(at.uOut, at.uIn), hn::Sub(at.vOut, at.vIn)),
                        hn::Sub(hn::Sub(h.h11, h.h10), hn::Sub(h.h01, h.h00)));
    gaps.in = hn::Sub(patch(at.uIn, at.vIn), at.zIn);
    gaps.out = hn::Sub(patch(at.uOut, at.vOut), at.zOut);
    return gaps;
}

// Whether the parabola has a maximum inside the interval. b: its slope at the entry.
HWY_INLINE MD isArched(VD b, VD bend) {
    const VD zero = hn::Zero(DD());
    return hn::And(hn::Lt(bend, zero), hn::And(hn::Gt(b, zero), hn::Lt(b, hn::Mul(hn::Set(DD(), -2.0), bend))));
}

// highestGap().
HWY_INLINE VD highestGap(const ExactGaps& gaps) {
    const VD b = hn::Sub(hn::Sub(gaps.out, gaps.in), gaps.bend);
    const VD ends = hn::Max(gaps.in, gaps.out);
    const VD peak = hn::Sub(gaps.in, hn::Div(hn::Mul(b, b), hn::Mul(hn::Set(DD(), 4.0), gaps.bend)));
    return hn::IfThenElse(isArched(b, gaps.bend), hn::Max(ends, peak), ends);
}

// Lanes that have a hit; it is at the fraction above / below, at most 1, of the interval from in to out.
struct ExactShare {
    VD above, below;
    MD hit;
};
HWY_INLINE ExactShare exactShare(const ExactGaps& gaps, VD in, VD out) {
    const DD d;
    const VD zero = hn::Zero(d), c = gaps.bend;
    const MD crosses = hn::Lt(in, out);
    const MD atEntry = hn::Not(hn::Lt(gaps.in, zero));
    // leaf_detail::firstRoot
    const VD b = hn::Sub(hn::Sub(gaps.out, gaps.in), c);
    const MD ends = hn::Lt(gaps.out, zero);
    const VD four = hn::Mul(hn::Set(d, 4.0), c);
    const VD discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(four, gaps.in));
    const MD none = hn::Or(hn::AndNot(isArched(b, c), ends), hn::And(hn::Lt(discriminant, zero), ends));
    const VD root = hn::Sqrt(hn::IfThenElse(hn::Lt(discriminant, zero), zero, discriminant));
    const MD rising = hn::Ge(b, zero);
    const VD above = hn::IfThenElse(rising, hn::Mul(hn::Set(d, -2.0), gaps.in), hn::Sub(root, b));
    const VD below = hn::IfThenElse(rising, hn::Add(b, root), hn::Mul(hn::Set(d, 2.0), c));
    return {hn::IfThenZeroElse(atEntry, above), hn::IfThenElse(atEntry, hn::Set(d, 1.0), below),
            hn::And(crosses, hn::Or(atEntry, hn::Not(none)))};
}
HWY_INLINE VD exactMeeting(VD above, VD below, VD in, VD out) {
    const VD w = hn::Div(above, below);
    const VD share = stdMin(hn::Set(DD(), 1.0), w);
    return stdMin(hn::Add(in, hn::Mul(share, hn::Sub(out, in))), out);
}

// The same for columns; lambda receives the hit.
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
