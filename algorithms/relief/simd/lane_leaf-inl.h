// SIMD version of float_leaf.h: excludes cells in which the surface is certainly below the ray. Shared by the kernels;
// compiled for each target.

#if defined(RELIEF_LANE_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_LEAF_INL_H
#undef RELIEF_LANE_LEAF_INL_H
#else
#define RELIEF_LANE_LEAF_INL_H
#endif

#include "relief/simd/lane_trace-inl.h"
#include "relief/simd/tile_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Returns the rays that pass a corner within `tie` before they leave the cell after it: two ties must be less than the
// lambda that a cell of either axis takes. Otherwise a ray almost parallel to an axis may pass through several cells
// along the line before it crosses it.
HWY_INLINE MF cornerWithinCells(VF tie, VF inverseX, VF inverseY) {
    return hn::Lt(hn::Add(tie, tie), hn::Min(inverseX, inverseY));
}

// ------------------------------------------------------------------------------------------------------- float leaf

// One axis of the rays in flight. The ray is in a cell (mirrored, addressed); n = cell + offset.
struct LaneAxisState {
    VI offset;
    VF inverse, base;
    VF run;       // absolute value
    MF mirrored;  // the ray runs backwards
};

template <Address kAddress>
HWY_INLINE void cellNodes(const GridAxis& axis, VI cell, VI& before, VI& after) {
    const DI d;
    const VI one = hn::Set(d, 1);
    if constexpr (kAddress == Address::Repeat) {
        before = cell;
        after = hn::Add(cell, one);
        after = hn::IfThenZeroElse(hn::Eq(after, hn::Set(d, axis.texels)), after);
    } else {
        before = hn::Max(hn::Sub(cell, one), hn::Zero(d));
        after = hn::Min(cell, hn::Set(d, axis.texels - 1));
    }
}

template <class Arithmetic>
HWY_INLINE VF lerpPatchLanes(VF h00, VF h10, VF h01, VF h11, VF u, VF v) {
    const VF top = Arithmetic::mulAdd(u, hn::Sub(h10, h00), h00);
    const VF bottom = Arithmetic::mulAdd(u, hn::Sub(h11, h01), h01);
    return Arithmetic::mulAdd(v, hn::Sub(bottom, top), top);
}

// Loads from[index] and from[index + 1]. Gathers cost per element, so pairs are fetched as one element.
HWY_INLINE void gatherPairs(const float* from, VI index, VF& first, VF& second) {
    const DF d;
#if HWY_TARGET <= HWY_AVX2
    const hn::RepartitionToWide<DI> d64;
    const hn::Half<DI> dHalf;
    const auto wide = [&](hn::Vec<hn::Half<DI>> half) {
        const auto bytes = hn::ShiftLeft<2>(hn::PromoteTo(d64, half));
        return hn::BitCast(d, hn::GatherOffset(d64, reinterpret_cast<const std::int64_t*>(from), bytes));
    };
    const VF low = wide(hn::LowerHalf(dHalf, index));
    const VF high = wide(hn::UpperHalf(dHalf, index));
    first = hn::ConcatEven(d, high, low);
    second = hn::ConcatOdd(d, high, low);
#else
    first = hn::GatherIndex(d, from, index);
    second = hn::GatherIndex(d, from, hn::Add(index, hn::Set(DI(), 1)));
#endif
}

// Heights of the nodes (i0, j0), (i1, j0), (i0, j1), (i1, j1) of a cell.
struct Patch {
    VF h00, h10, h01, h11;
};

#if HWY_TARGET != HWY_SCALAR
// Four floats for each of the lanes k, k + 4, k + 8, ... of N lanes, in one quarter of the vector each.
template <std::size_t N>
HWY_INLINE auto quarters(const float* HWY_RESTRICT from, const std::int32_t* HWY_RESTRICT pair, std::size_t k) {
    const hn::CappedTag<float, N> d;
    if constexpr (N > 4) {
        const auto low = quarters<N / 2>(from, pair, k);
        const auto high = quarters<N / 2>(from, pair, k + N / 2);
        return hn::Combine(d, high, low);
    } else {
        return hn::LoadU(d, from + 2 * static_cast<std::ptrdiff_t>(pair[k]));
    }
}
#endif

// Four values from nodes[2 pair] on for each lane of d: h00, h01, h10, h11.
template <class D4>
HWY_INLINE auto nodesAt(D4 d, const float* HWY_RESTRICT nodes, const std::int32_t* HWY_RESTRICT pair) {
    using V = hn::Vec<D4>;
    constexpr std::size_t kCount = hn::MaxLanes(D4());
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kCount >= 4) {
        // A transposition within quarters puts the values of lane k into lane k.
        const V r0 = quarters<kCount>(nodes, pair, 0), r1 = quarters<kCount>(nodes, pair, 1);
        const V r2 = quarters<kCount>(nodes, pair, 2), r3 = quarters<kCount>(nodes, pair, 3);
        const V even0 = hn::InterleaveLower(d, r0, r2), odd0 = hn::InterleaveLower(d, r1, r3);
        const V even1 = hn::InterleaveUpper(d, r0, r2), odd1 = hn::InterleaveUpper(d, r1, r3);
        return std::array<V, 4>{hn::InterleaveLower(d, even0, odd0), hn::InterleaveUpper(d, even0, odd0),
                                hn::InterleaveLower(d, even1, odd1), hn::InterleaveUpper(d, even1, odd1)};
    }
#endif
    if constexpr (kCount < 4) {
        HWY_ALIGN float columns[4][kCount];
        for (std::size_t k = 0; k < kCount; ++k) {
            for (std::size_t c = 0; c < 4; ++c)
                columns[c][k] = nodes[2 * static_cast<std::ptrdiff_t>(pair[k]) + static_cast<std::ptrdiff_t>(c)];
        }
        return std::array<V, 4>{hn::LoadU(d, columns[0]), hn::LoadU(d, columns[1]), hn::LoadU(d, columns[2]),
                                hn::LoadU(d, columns[3])};
    }
}

// The patches of the cells in the lanes `who`. The cells of other lanes must be valid.
template <Address kAddress>
HWY_INLINE Patch patchAt(const FloatScene& scene, MI who, VI realX, VI realY) {
    const DF d;
    const DI di;
    VI i0, i1, j0, j1;
    cellNodes<kAddress>(scene.grid.x, realX, i0, i1);
    cellNodes<kAddress>(scene.grid.y, realY, j0, j1);
    const VI stride = hn::Set(di, scene.stride);
    const VI row0 = hn::Mul(j0, stride);
    const VI row1 = hn::Mul(j1, stride);
    Patch out;
    const VI next = hn::Add(i0, hn::Set(di, 1));
    if (HWY_LIKELY(hn::AllTrue(di, hn::Or(hn::Not(who), hn::Eq(i1, next))))) {
        gatherPairs(scene.heights, hn::Add(row0, i0), out.h00, out.h10);
        gatherPairs(scene.heights, hn::Add(row1, i0), out.h01, out.h11);
    } else {
        out.h00 = hn::GatherIndex(d, scene.heights, hn::Add(row0, i0));
        out.h10 = hn::GatherIndex(d, scene.heights, hn::Add(row0, i1));
        out.h01 = hn::GatherIndex(d, scene.heights, hn::Add(row1, i0));
        out.h11 = hn::GatherIndex(d, scene.heights, hn::Add(row1, i1));
    }
    return out;
}

// patchAt() for scenes whose heights are not gathered.
template <Address kAddress>
HWY_NOINLINE Patch patchApart(const FloatScene& scene, MI who, VI realX, VI realY) {
    const DF d;
    VI i0, i1, j0, j1;
    cellNodes<kAddress>(scene.grid.x, realX, i0, i1);
    cellNodes<kAddress>(scene.grid.y, realY, j0, j1);
    const FourHeights<DF> four = fourHeights(d, scene, who, i0, i1, j0, j1);
    return {four.h00, four.h10, four.h01, four.h11};
}

// Whether the bilinear surface is certainly below the ray over the ray's whole interval in the patch's cell. That
// interval is within [in, out]: `in` is early by at most one tie, `out` late by at most half a tie. nx, ny: the cell's
// n on each axis. kTurned: the patch has been turned so that all rays run forwards.
template <class Arithmetic = FastArithmetic, bool kTurned = false>
HWY_INLINE MF patchBelow(const Patch& patch, const LaneAxisState& x, const LaneAxisState& y, VF nx, VF ny, VF in,
                         VF out, VF tie) {
    const DF d;
    const auto [h00, h10, h01, h11] = patch;
    const VF zero = hn::Zero(d), one = hn::Set(d, 1.0F);
    const auto within = [&](const LaneAxisState& axis, VF n, VF lambda) {
        const VF along = Arithmetic::mulSub(hn::Sub(lambda, axis.base), axis.run, n);
        const VF clamped = hn::Min(hn::Max(along, zero), one);
        return kTurned ? clamped : hn::IfThenElse(axis.mirrored, hn::Sub(one, clamped), clamped);
    };
    const VF uIn = within(x, nx, in), vIn = within(y, ny, in);
    const VF uOut = within(x, nx, out), vOut = within(y, ny, out);
    const VF fIn = hn::Sub(lerpPatchLanes<Arithmetic>(h00, h10, h01, h11, uIn, vIn), hn::Sub(one, in));
    const VF fOut = hn::Sub(lerpPatchLanes<Arithmetic>(h00, h10, h01, h11, uOut, vOut), hn::Sub(one, out));
    const VF alongTop = hn::Sub(h10, h00), alongBottom = hn::Sub(h11, h01);
    const VF c = hn::Mul(hn::Mul(hn::Sub(uOut, uIn), hn::Sub(vOut, vIn)), hn::Sub(alongBottom, alongTop));
    // The vertex of the parabola, if it is a maximum inside the interval.
    const VF slope = hn::Sub(hn::Sub(fOut, fIn), c);
    const MF arched =
        hn::And(hn::Lt(c, zero), hn::And(hn::Gt(slope, zero), hn::Lt(slope, hn::Mul(hn::Set(d, -2.0F), c))));
    // Rounded upwards, because the reciprocal is approximate.
    const VF share = hn::Mul(slope, Arithmetic::reciprocal(hn::IfThenElse(arched, c, one)));
    const VF vertex = Arithmetic::negMulAdd(hn::Mul(slope, hn::Set(d, 0.25F * (1 + 2 * kReciprocalError))), share, fIn);
    const VF highest = hn::Max(hn::Max(fIn, fOut), hn::IfThenElse(arched, vertex, fIn));
    // Positions are off by at most twice the crossing margin times the run, and heights by that times the cell's
    // slopes. Of the two ties, one and a half cover `in` and `out`; the rest, at least 16 units of 2^-24, covers the
    // rounding of heights.
    const VF slopeX = hn::Max(hn::Abs(alongTop), hn::Abs(alongBottom));
    const VF slopeY = hn::Max(hn::Abs(hn::Sub(h01, h00)), hn::Abs(hn::Sub(h11, h10)));
    const auto blur = [&](const LaneAxisState& axis, VF slope) {
        return hn::Mul(slope,
                       Arithmetic::mulAdd(axis.run, hn::Set(d, 2 * kCrossingMargin), hn::Set(d, 2 * kCrossingMargin)));
    };
    const VF margin = hn::Add(hn::Add(blur(x, slopeX), blur(y, slopeY)), hn::Mul(hn::Set(d, 2.0F), tie));
    return hn::Lt(highest, hn::Neg(margin));
}

// The same for the column at `index`. Needs no margin: `out` is late, heights are exact, and rounding preserves the
// order.
HWY_INLINE MF columnBelow(const FloatScene& scene, VI index, VF out) {
    const DF d;
    return hn::Lt(hn::GatherIndex(d, scene.heights, index), hn::Sub(hn::Set(d, 1.0F), out));
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
