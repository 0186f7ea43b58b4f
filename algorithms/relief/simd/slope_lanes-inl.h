// SIMD version of HeightField::slope for bilinear surfaces in double, with the same bits. Compiled for each target.

#if defined(RELIEF_SLOPE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_SLOPE_LANES_INL_H
#undef RELIEF_SLOPE_LANES_INL_H
#else
#define RELIEF_SLOPE_LANES_INL_H
#endif

#include <algorithm>
#include <cmath>

#include <hwy/highway.h>

#include "relief/methods/slope_scene.h"
#include "relief/simd/lane_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace slopes {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

HWY_INLINE V set(double x) {
    return hn::Set(D(), x);
}

// Loads a vector, or its first `count` values, padded with zeros that are not stored again.
HWY_INLINE V load(const double* from, std::size_t count) {
    if (HWY_LIKELY(count >= kLanes)) return hn::LoadU(D(), from);
    HWY_ALIGN double some[kLanes] = {};
    std::copy_n(from, count, some);
    return hn::Load(D(), some);
}
HWY_INLINE void store(V value, double* to, std::size_t count) {
    if (HWY_LIKELY(count >= kLanes)) return hn::StoreU(value, D(), to);
    HWY_ALIGN double some[kLanes];
    hn::Store(value, D(), some);
    std::copy_n(some, count, to);
}

// The two nodes around a position on an axis, and the fraction of the way to the second one.
struct Nodes {
    VI first, second;
    VI cell;  // numbered as in PackedCones
    V share;
};
HWY_INLINE Nodes nodesAt(V place, std::int32_t size, bool repeat) {
    const D d;
    const DI di;
    const V whole = set(static_cast<double>(size));
    V at = hn::Sub(place, set(0.5));
    if (!repeat) {
        at = hn::Min(hn::Max(at, set(-1)), hn::Add(whole, set(1)));
    } else if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Lt(hn::Abs(at), whole)))) {
        // In other periods fmod() gives the remainder, which is exact.
        HWY_ALIGN double some[kLanes];
        hn::Store(at, d, some);
        for (double& x : some) x = std::fmod(x, size);
        at = hn::Load(d, some);
    }
    const V low = hn::Floor(at);
    Nodes nodes;
    nodes.share = hn::Sub(at, low);
    // NaN is mapped to a valid node.
    VI i = hn::DemoteTo(di, hn::Min(hn::Max(low, hn::Neg(whole)), whole));
    const VI last = hn::Set(di, size - 1), sizes = hn::Set(di, size), none = hn::Zero(di);
    if (repeat) i = hn::IfThenElse(hn::Lt(i, none), hn::Add(i, sizes), i);
    const VI next = hn::Add(i, hn::Set(di, 1));
    nodes.first = hn::Min(hn::Max(i, none), last);
    nodes.cell = repeat ? nodes.first : hn::Min(hn::Max(next, none), sizes);
    nodes.second = repeat ? hn::IfThenElseZero(hn::Lt(next, sizes), next) : hn::Min(hn::Max(next, none), last);
    return nodes;
}

// bend: the mixed second derivative within the cell.
struct Slope {
    V s, t, bend;
};
// The slope within a cell, from the heights of its nodes.
HWY_INLINE Slope slopeOf(V h00, V h10, V h01, V h11, const Nodes& x, const Nodes& y) {
    const auto mixed = [&](V first, V second, V share)
                           HWY_ATTR { return hn::Add(hn::Mul(hn::Sub(set(1), share), first), hn::Mul(share, second)); };
    return {mixed(hn::Sub(h10, h00), hn::Sub(h11, h01), y.share), mixed(hn::Sub(h01, h00), hn::Sub(h11, h10), x.share),
            hn::Sub(hn::Sub(h11, h10), hn::Sub(h01, h00))};
}
HWY_INLINE Slope slopeByHeights(const SlopeScene& scene, V s, V t) {
    const D d;
    const hn::Rebind<float, D> df;
    const DI di;
    const Nodes x = nodesAt(s, scene.width, scene.repeat), y = nodesAt(t, scene.height, scene.repeat);
    const auto height = [&](VI i, VI j) HWY_ATTR {
        const VI at = hn::Add(hn::Mul(j, hn::Set(di, scene.width)), i);
        return hn::PromoteTo(d, hn::GatherIndex(df, scene.heights, at));
    };
    const V h00 = height(x.first, y.first), h10 = height(x.second, y.first);
    const V h01 = height(x.first, y.second), h11 = height(x.second, y.second);
    return slopeOf(h00, h10, h01, h11, x, y);
}
// The same for scenes whose heights are not gathered.
HWY_INLINE Slope slopeByLanes(const SlopeScene& scene, V s, V t) {
    const D d;
    const DI di;
    const Nodes x = nodesAt(s, scene.width, scene.repeat), y = nodesAt(t, scene.height, scene.repeat);
    const auto all = hn::Not(hn::MaskFromVec(hn::Zero(di)));
    const hn::Rebind<float, D> df;
    const auto four = fourHeights(df, scene, all, x.first, x.second, y.first, y.second);
    return slopeOf(hn::PromoteTo(d, four.h00), hn::PromoteTo(d, four.h10), hn::PromoteTo(d, four.h01),
                   hn::PromoteTo(d, four.h11), x, y);
}
// The same heights, stored together for each cell: one load per lane instead of four.
HWY_INLINE Slope slopeByNodes(const SlopeScene& scene, V s, V t) {
    const D d;
    const hn::Rebind<float, D> df;
    const DI di;
    const Nodes x = nodesAt(s, scene.width, scene.repeat), y = nodesAt(t, scene.height, scene.repeat);
    HWY_ALIGN std::int32_t pair[kLanes];
    hn::Store(hn::Add(hn::Mul(y.cell, hn::Set(di, scene.nodeStride)), x.cell), di, pair);
    const auto h = HWY_NAMESPACE::nodesAt(df, scene.nodes, pair);
    const auto wide = [&](hn::Vec<decltype(df)> v) HWY_ATTR { return hn::PromoteTo(d, v); };
    return slopeOf(wide(h[0]), wide(h[2]), wide(h[1]), wide(h[3]), x, y);
}
// Calls body(slopeAt). Each kind of scene has a loop of its own, because a branch in the loop would cost more than the
// code it selects.
template <class Body>
HWY_INLINE void withSlopes(const SlopeScene& scene, const Body& body) {
    if (scene.nodes != nullptr) {
        body([&](V s, V t) HWY_ATTR { return slopeByNodes(scene, s, t); });
    } else if (!scene.gathered) {
        body([&](V s, V t) HWY_ATTR { return slopeByLanes(scene, s, t); });
    } else {
        body([&](V s, V t) HWY_ATTR { return slopeByHeights(scene, s, t); });
    }
}

}  // namespace slopes
}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
