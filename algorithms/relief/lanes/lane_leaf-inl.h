// The leaf in lanes: in float, to exclude cells that the surface is surely below the ray in; in double, operation by
// operation the one leaf, for the hits of the candidates. Shared by the kernels, compiled for each target.

#if defined(RELIEF_LANE_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_LEAF_INL_H
#undef RELIEF_LANE_LEAF_INL_H
#else
#define RELIEF_LANE_LEAF_INL_H
#endif

#include "relief/lanes/lane_trace-inl.h"
#include "relief/leaf.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// ------------------------------------------------------------------------------------------------------- float leaf

// One axis of lanes in flight: the place of the walk is cell `cell` (mirrored, addressed), n = cell + offset.
struct LaneAxisState {
    VI offset;
    VF inverse, base;
    VF run;       // its size
    MF mirrored;  // whether it runs backwards
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

HWY_INLINE VF lerpPatchLanes(VF h00, VF h10, VF h01, VF h11, VF u, VF v) {
    const VF top = hn::MulAdd(u, hn::Sub(h10, h00), h00);
    const VF bottom = hn::MulAdd(u, hn::Sub(h11, h01), h01);
    return hn::MulAdd(v, hn::Sub(bottom, top), top);
}

// from[index] and from[index + 1]: gathers cost by the element, pairs are one.
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

// Heights of a cell's nodes, (i0, j0), (i1, j0), (i0, j1), (i1, j1).
struct Patch {
    VF h00, h10, h01, h11;
};

#if HWY_TARGET != HWY_SCALAR
// Four floats for each of N lanes from the k-th on, four apart: a quarter of the vector each.
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

// The four from nodes[2 pair] on, of as many lanes as d has: h00, h01, h10, h11.
template <class D4>
HWY_INLINE auto nodesAt(D4 d, const float* HWY_RESTRICT nodes, const std::int32_t* HWY_RESTRICT pair) {
    using V = hn::Vec<D4>;
    constexpr std::size_t kCount = hn::MaxLanes(D4());
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kCount >= 4) {
        // A transposition within quarters puts lane k's in lane k.
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

// Of the lanes of `who`; the others' cells are of the map.
template <Address kAddress>
HWY_INLINE Patch patchAt(const LaneScene& scene, MI who, VI realX, VI realY) {
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

// Whether the bilinear surface is surely below the ray all along its stay in the patch's cell, which lasts from
// before `in` to after `out`; nx, ny are the cell's distances n.
HWY_INLINE MF patchBelow(const Patch& patch, const LaneAxisState& x, const LaneAxisState& y, VF nx, VF ny, VF in,
                         VF out, VF tie) {
    const DF d;
    const auto [h00, h10, h01, h11] = patch;
    const VF zero = hn::Zero(d), one = hn::Set(d, 1.0F);
    const auto within = [&](const LaneAxisState& axis, VF n, VF lambda) {
        const VF along = hn::MulSub(hn::Sub(lambda, axis.base), axis.run, n);
        const VF clamped = hn::Min(hn::Max(along, zero), one);
        return hn::IfThenElse(axis.mirrored, hn::Sub(one, clamped), clamped);
    };
    const VF uIn = within(x, nx, in), vIn = within(y, ny, in);
    const VF uOut = within(x, nx, out), vOut = within(y, ny, out);
    const VF fIn = hn::Sub(lerpPatchLanes(h00, h10, h01, h11, uIn, vIn), hn::Sub(one, in));
    const VF fOut = hn::Sub(lerpPatchLanes(h00, h10, h01, h11, uOut, vOut), hn::Sub(one, out));
    const VF alongTop = hn::Sub(h10, h00), alongBottom = hn::Sub(h11, h01);
    const VF c = hn::Mul(hn::Mul(hn::Sub(uOut, uIn), hn::Sub(vOut, vIn)), hn::Sub(alongBottom, alongTop));
    // The vertex of the parabola, where it is inside and a maximum.
    const VF slope = hn::Sub(hn::Sub(fOut, fIn), c);
    const MF arched =
        hn::And(hn::Lt(c, zero), hn::And(hn::Gt(slope, zero), hn::Lt(slope, hn::Mul(hn::Set(d, -2.0F), c))));
    // A little too high: the reciprocal is approximate.
    const VF share = hn::Mul(slope, hn::ApproximateReciprocal(hn::IfThenElse(arched, c, one)));
    const VF vertex = hn::NegMulAdd(hn::Mul(slope, hn::Set(d, 0.25F * (1 + 0x1p-10F))), share, fIn);
    const VF highest = hn::Max(hn::Max(fIn, fOut), hn::IfThenElse(arched, vertex, fIn));
    // Places are off by twice the crossing margin times the run at most, heights by as much of the cell's slopes.
    const VF slopeX = hn::Max(hn::Abs(alongTop), hn::Abs(alongBottom));
    const VF slopeY = hn::Max(hn::Abs(hn::Sub(h01, h00)), hn::Abs(hn::Sub(h11, h10)));
    const auto blur = [&](const LaneAxisState& axis, VF slope) {
        return hn::Mul(slope, hn::MulAdd(axis.run, hn::Set(d, 2 * kCrossingMargin), hn::Set(d, 2 * kCrossingMargin)));
    };
    const VF margin =
        hn::Add(hn::Add(blur(x, slopeX), blur(y, slopeY)), hn::MulAdd(hn::Set(d, 2.0F), tie, hn::Set(d, 2e-6F)));
    return hn::Lt(highest, hn::Neg(margin));
}

// The same for a column.
HWY_INLINE MF columnBelow(const LaneScene& scene, VI realX, VI realY, VF out, VF tie) {
    const DF d;
    const VI index = hn::Add(hn::Mul(realY, hn::Set(DI(), scene.stride)), realX);
    const VF height = hn::GatherIndex(d, scene.heights, index);
    const VF margin = hn::MulAdd(hn::Set(d, 2.0F), tie, hn::Set(d, 2e-6F));
    return hn::Lt(hn::Add(height, margin), hn::Sub(hn::Set(d, 1.0F), out));
}

// ---------------------------------------------------------------------------------------------------- the one leaf

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

// std::max and std::min of these arguments, in this order: zeros keep the sign that they would have there.
HWY_INLINE VD stdMax(VD a, VD b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
}
HWY_INLINE VD stdMin(VD a, VD b) {
    return hn::IfThenElse(hn::Lt(b, a), b, a);
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

// leafHit() for the candidates of [i, i + kHalfLanes): lambda, and where there is a hit at all. pair: of their nodes,
// where these lie together.
template <Address kAddress, Surface kSurface>
HWY_INLINE MD exactLeaf(const LaneScene& scene, const ExactAxis& x, const ExactAxis& y, const std::int32_t* pair,
                        VD& lambda) {
    const DD d;
    const DHF df;
    const DHI di;
    const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
    VD inX, outX, inY, outY;
    exactStay<kAddress>(scene.grid.x, x, inX, outX);
    exactStay<kAddress>(scene.grid.y, y, inY, outY);
    const VD in = stdMax(stdMax(inX, inY), zero);
    const VD out = stdMin(stdMin(outX, outY), one);
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
            return hn::IfThenElse(hn::Lt(v, zero), zero, hn::IfThenElse(hn::Lt(one, v), one, v));
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
        const VD share = hn::IfThenElse(hn::Lt(w, one), w, one);
        const VD met = hn::Add(in, hn::Mul(share, hn::Sub(out, in)));
        lambda = hn::IfThenElse(atEntry, in, stdMin(met, out));
        return hn::And(stays, hn::Or(atEntry, hn::Not(none)));
    }
}

// The hits of the chunk's candidates; a candidate that the leaf refuses is left to the scalar text.
template <Address kAddress, Surface kSurface>
void settleLanes(const LaneScene& scene, const double* s0, const double* t0, const double* a, const double* b,
                 LaneRays& rays, HitBlock& hits, std::size_t firstHit) {
    const DD d;
    const DHI di;
    HWY_ALIGN double found[3][kHalfLanes];
    VD worst = hn::Zero(d);
    // First all of them: written as vectors, read lane by lane.
    alignas(64) std::array<std::int32_t, kLaneSlots> pairs;
    if (scene.nodes != nullptr) {
        const DI dv;
        for (std::size_t i = 0; i < rays.count; i += kLanes) {
            const VI row = hn::Mul(hn::Load(dv, rays.y.hitCell.data() + i), hn::Set(dv, scene.nodeStride));
            hn::Store(hn::Add(row, hn::Load(dv, rays.x.hitCell.data() + i)), dv, pairs.data() + i);
        }
    }
    for (std::size_t i = 0; i < rays.count; i += kHalfLanes) {
        const std::size_t here = std::min(kHalfLanes, rays.count - i);
        std::array<std::array<double, kHalfLanes>, 4> rest{};
        const double* columns[] = {s0, t0, a, b};
        if (here < kHalfLanes) {
            for (std::size_t c = 0; c < rest.size(); ++c) {
                std::copy(columns[c] + i, columns[c] + i + here, rest[c].begin());
                columns[c] = rest[c].data() - i;
            }
        }
        const ExactAxis x = exactAxis<kAddress>(scene, scene.grid.x, columns[0], columns[2], rays.x, i);
        const ExactAxis y = exactAxis<kAddress>(scene, scene.grid.y, columns[1], columns[3], rays.y, i);
        VD lambda;
        const MD hit = exactLeaf<kAddress, kSurface>(scene, x, y, pairs.data() + i, lambda);
        const VD end = hn::PromoteTo(d, hn::LoadU(di, rays.end.data() + i));
        const MD refused = hn::AndNot(hit, hn::Eq(end, hn::Zero(d)));
        const VD settled = hn::IfThenElse(refused, hn::Set(d, static_cast<double>(LaneEnd::Scalar)), end);
        hn::StoreU(hn::DemoteTo(di, settled), di, rays.end.data() + i);
        worst = hn::Max(worst, hn::IfThenElseZero(hn::FirstN(d, here), settled));
        const VD s = hn::Add(hn::LoadU(d, columns[0] + i), hn::Mul(lambda, hn::LoadU(d, columns[2] + i)));
        const VD t = hn::Add(hn::LoadU(d, columns[1] + i), hn::Mul(lambda, hn::LoadU(d, columns[3] + i)));
        if (here == kHalfLanes) {
            hn::StoreU(lambda, d, hits.lambda.data() + firstHit + i);
            hn::StoreU(s, d, hits.s.data() + firstHit + i);
            hn::StoreU(t, d, hits.t.data() + firstHit + i);
        } else {
            hn::Store(lambda, d, found[0]);
            hn::Store(s, d, found[1]);
            hn::Store(t, d, found[2]);
            std::copy_n(found[0], here, hits.lambda.data() + firstHit + i);
            std::copy_n(found[1], here, hits.s.data() + firstHit + i);
            std::copy_n(found[2], here, hits.t.data() + firstHit + i);
        }
    }
    std::fill_n(hits.outcome.data() + firstHit, rays.count, Outcome::Hit);
    rays.allHit = hn::AllTrue(d, hn::Eq(worst, hn::Zero(d)));
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
