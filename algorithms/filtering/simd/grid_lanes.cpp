#include "filtering/grid_lanes.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/simd/grid_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/simd/slope_lanes-inl.h"

#ifndef RELIEF_GRID_LANES_ONCE
#define RELIEF_GRID_LANES_ONCE
namespace relief {

// Largest distance, in texels, by which rounding may put the ray of a pixel's centre outside the polygon: more than the
// rounding of coordinates up to 10^6 (margins.md).
inline constexpr double kEdgeRounding = 1e-6;
// Smallest 1 + r . g of a point's tangent plane: see kLeastFacing in elliptical_rays.cpp.
inline constexpr double kLeastPointFacing = 1;

}  // namespace relief
#endif

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace grid {

namespace hn = hwy::HWY_NAMESPACE;

using slopes::D, slopes::kLanes, slopes::load, slopes::set, slopes::store, slopes::V;
using M = hn::Mask<D>;

struct Linear {
    double perY, perX, at;
};

// Floats, in vectors as long as possible.
using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;
constexpr std::size_t kFloats = hn::MaxLanes(DF());

// Surroundings of the cells [at, at + kFloats).
HWY_INLINE void surroundingsOf(const CellHits& cells, float bounds, std::size_t at, std::uint16_t* out) {
    const DF d;
    const auto row = static_cast<std::size_t>(cells.width);
    const auto squared = [&](double x) HWY_ATTR { return hn::Set(d, static_cast<float>(x * x)); };
    // `squared` bounds first differences; `bound` bounds second differences and includes the factor `bounds`.
    const auto bound = [&](double x) HWY_ATTR { return squared(x * static_cast<double>(bounds)); };
    const VF farthest = squared(2 * kNear), nearest = squared(2 * kLeastNear);
    const auto load = [&](const float* column, std::size_t i) HWY_ATTR { return hn::LoadU(d, column + i); };
    const auto square = [&](VF x, VF y) HWY_ATTR { return hn::Add(hn::Mul(x, x), hn::Mul(y, y)); };
    const VF s = load(cells.s, at), t = load(cells.t, at), height = load(cells.lambda, at);
    const VF twiceS = hn::Add(s, s), twiceT = hn::Add(t, t), most = hn::Set(d, kLevelHeight);
    auto onPlane = hn::Eq(s, s);
    auto onLevel = onPlane, allNear = onPlane;
    VF bits = hn::Zero(d);
    float bit = kSmooth;
    for (const std::size_t way : {std::size_t{1}, row, row + 1, row - 1}) {
        // The last direction is to the right and up.
        const VF s1 = load(cells.s, at + way), s0 = load(cells.s, at - way);
        const VF t1 = load(cells.t, at + way), t0 = load(cells.t, at - way);
        // Four times the squares of half the first and of half the second difference. Comparisons with NaN fail.
        const VF step = square(hn::Sub(s1, s0), hn::Sub(t1, t0));
        const VF bend = square(hn::Sub(hn::Add(s1, s0), twiceS), hn::Sub(hn::Add(t1, t0), twiceT));
        const auto within = [&](const Bend& most, auto near, double nearShare) HWY_ATTR {
            const VF share = hn::IfThenElse(near, bound(nearShare), bound(most.relative));
            return hn::Le(bend, hn::Add(hn::Mul(share, step), bound(2 * most.absolute)));
        };
        const auto near = hn::Le(step, farthest);
        allNear = hn::And(allNear, near);
        onPlane = hn::And(onPlane, within(kPlaneBend, hn::And(near, hn::Ge(step, nearest)), kNearPlaneBend));
        const auto smooth = within(kSmoothBend, near, kNearSmoothBend);
        const auto straight = within(kStraightBend, near, kStraightBend.relative);
        bits = hn::Add(bits, hn::IfThenElseZero(smooth, hn::Set(d, bit)));
        bits = hn::Add(bits, hn::IfThenElseZero(straight, hn::Set(d, float{kStraight} * bit)));
        bit *= 2;
        const VF up = hn::Sub(load(cells.lambda, at + way), height),
                 down = hn::Sub(load(cells.lambda, at - way), height);
        onLevel = hn::And(onLevel, hn::Le(hn::Max(hn::Abs(up), hn::Abs(down)), most));
    }
    bits = hn::Add(bits, hn::IfThenElseZero(onPlane, hn::Set(d, float{kOnPlane})));
    bits = hn::Add(bits, hn::IfThenElseZero(allNear, hn::Set(d, float{kNearAround})));
    bits = hn::Add(bits, hn::IfThenElseZero(hn::And(onPlane, onLevel), hn::Set(d, float{kOnLevel})));
    const hn::Rebind<std::uint16_t, DF> du;
    hn::StoreU(hn::DemoteTo(du, hn::ConvertTo(hn::RebindToSigned<DF>(), bits)), du, out + at);
}

// Processes the rows in one sweep; the ends of rows, which lack neighbours, are corrected afterwards.
void findSurroundings(const CellHits& cells, float bounds, std::uint16_t* out) {
    static_assert(kFloats <= kCellSlack);
    const auto width = static_cast<std::size_t>(cells.width), height = static_cast<std::size_t>(cells.height);
    const std::size_t last = width * (height - 1);
    for (std::size_t at = width + 1; at < last; at += kFloats) surroundingsOf(cells, bounds, at, out);
    std::fill_n(out, width, std::uint16_t{0});
    std::fill_n(out + last, width, std::uint16_t{0});
    for (std::size_t at = width; at < last; at += width) out[at] = out[at + width - 1] = 0;
}

void raysThrough(const PixelView& view, std::span<const double> x, std::span<const double> y, RayBlock& rays,
                 std::size_t first) {
    const Homography& m = view.texelFromScreen;
    const std::size_t count = x.size();
    for (std::size_t i = 0; i < count; i += kLanes) {
        const std::size_t here = std::min(kLanes, count - i);
        const V px = load(x.data() + i, here), py = load(y.data() + i, here);
        const auto linear = [&](double perX, double perY, double at) HWY_ATTR {
            return hn::Add(hn::Add(hn::Mul(set(perX), px), hn::Mul(set(perY), py)), set(at));
        };
        const V q = linear(m.qx, m.qy, m.q1);
        const V s = hn::Div(linear(m.sx, m.sy, m.s1), q), t = hn::Div(linear(m.tx, m.ty, m.t1), q);
        const auto within = [&](V at, int size) HWY_ATTR {
            return hn::Min(hn::Max(at, hn::Zero(D())), set(static_cast<double>(size)));
        };
        const V nearS = within(s, view.width), nearT = within(t, view.height), slack = set(kEdgeRounding);
        const M off = hn::Or(hn::Gt(hn::Abs(hn::Sub(s, nearS)), slack), hn::Gt(hn::Abs(hn::Sub(t, nearT)), slack));
        const V s0 = hn::IfThenElse(off, s, nearS), t0 = hn::IfThenElse(off, t, nearT);
        const V run = set(view.runPerTexel);
        store(s0, rays.s0.data() + first + i, here);
        store(t0, rays.t0.data() + first + i, here);
        store(hn::Mul(hn::Sub(s0, set(view.sEye)), run), rays.a.data() + first + i, here);
        store(hn::Mul(hn::Sub(t0, set(view.tEye)), run), rays.b.data() + first + i, here);
    }
}

template <bool kSloping, class SlopeAt>
HWY_INLINE void layWith(const PixelView& view, const SlopeAt& slopeAt, const PointBlur& blur, glm::dvec2 scale,
                        const PointHits& hits, PointBlock& points) {
    const Homography& m = view.texelFromScreen;
    // Derivatives of s and t along the picture, times q^2, as in jacobianAt.
    const double uxY = m.sx * m.qy - m.sy * m.qx, ux1 = m.sx * m.q1 - m.s1 * m.qx;
    const double vxY = m.tx * m.qy - m.ty * m.qx, vx1 = m.tx * m.q1 - m.t1 * m.qx;
    const double uyX = m.sy * m.qx - m.sx * m.qy, uy1 = m.sy * m.q1 - m.s1 * m.qy;
    const double vyX = m.ty * m.qx - m.tx * m.qy, vy1 = m.ty * m.q1 - m.t1 * m.qy;
    const V one = set(1), perS = set(scale.x), perT = set(scale.y);
    // The same along the axes of the blur, as linear functions of the place.
    const auto blurred = [](double perY, double at1, double perX, double at2, double share, double other) HWY_ATTR {
        return Linear{share * perY, other * perX, share * at1 + other * at2};
    };
    const Linear toUx = blurred(uxY, ux1, uyX, uy1, blur.xx, blur.xy),
                 toVx = blurred(vxY, vx1, vyX, vy1, blur.xx, blur.xy);
    const Linear toUy = blurred(uxY, ux1, uyX, uy1, blur.xy, blur.yy),
                 toVy = blurred(vxY, vx1, vyX, vy1, blur.xy, blur.yy);
    const std::size_t count = hits.x.size(), before = points.size();
    const hn::Rebind<float, D> df;
    points.resize(before + count);
    static_assert(kLanes <= kPointSlack);
    for (std::size_t i = 0; i < count; i += kLanes) {
        const std::size_t here = std::min(kLanes, count - i);
        const V x = load(hits.x.data() + i, here), y = load(hits.y.data() + i, here);
        const V q = hn::Add(hn::Add(hn::Mul(set(m.qx), x), hn::Mul(set(m.qy), y)), set(m.q1));
        const V run = set(view.runPerTexel);
        const V below = hn::Add(one, hn::Mul(load(hits.lambda.data() + i, here), run));
        const V factor = hn::Div(below, hn::Mul(q, q));
        const auto along = [&](const Linear& line) HWY_ATTR {
            const V linear = hn::Add(hn::Mul(set(line.perY), y), hn::Mul(set(line.perX), x));
            return hn::Mul(factor, hn::Add(linear, set(line.at)));
        };
        V ux = along(toUx), vx = along(toVx), uy = along(toUy), vy = along(toVy);
        const V s = load(hits.s.data() + i, here), t = load(hits.t.data() + i, here);
        if constexpr (kSloping) {
            // The ray's run, from its position below the eye.
            const V perBelow = hn::Div(run, below);
            const V a = hn::Mul(hn::Sub(s, set(view.sEye)), perBelow);
            const V b = hn::Mul(hn::Sub(t, set(view.tEye)), perBelow);
            const slopes::Slope slope = slopeAt(s, t);
            const V facing = hn::Add(one, hn::Add(hn::Mul(a, slope.s), hn::Mul(b, slope.t)));
            const V per = hn::Div(one, hn::Max(facing, set(kLeastPointFacing)));
            const V alongX = hn::Mul(hn::Add(hn::Mul(slope.s, ux), hn::Mul(slope.t, vx)), per);
            const V alongY = hn::Mul(hn::Add(hn::Mul(slope.s, uy), hn::Mul(slope.t, vy)), per);
            ux = hn::Sub(ux, hn::Mul(a, alongX)), vx = hn::Sub(vx, hn::Mul(b, alongX));
            uy = hn::Sub(uy, hn::Mul(a, alongY)), vy = hn::Sub(vy, hn::Mul(b, alongY));
        }
        // The columns are padded, so whole vectors may be stored.
        const auto narrow = [&](V value, std::vector<float>& to)
                                HWY_ATTR { hn::StoreU(hn::DemoteTo(df, value), df, to.data() + before + i); };
        hn::StoreU(hn::Mul(s, perS), D(), points.s.data() + before + i);
        hn::StoreU(hn::Mul(t, perT), D(), points.t.data() + before + i);
        narrow(hn::Mul(ux, perS), points.ux);
        narrow(hn::Mul(vx, perT), points.vx);
        narrow(hn::Mul(uy, perS), points.uy);
        narrow(hn::Mul(vy, perT), points.vy);
    }
}
void layFootprints(const PixelView& view, const SlopeScene* slopes, const PointBlur& blur, glm::dvec2 scale,
                   const PointHits& hits, PointBlock& points) {
    const auto level = [](V s, V) { return slopes::Slope{s, s, s}; };
    if (slopes == nullptr) return layWith<false>(view, level, blur, scale, hits, points);
    slopes::withSlopes(*slopes,
                       [&](const auto& slopeAt) HWY_ATTR { layWith<true>(view, slopeAt, blur, scale, hits, points); });
}

void findUniform(const std::array<const float*, 3>& channel, std::size_t row, std::size_t count, float bounds,
                 std::uint16_t* uniform) {
    const DF d;
    const hn::RebindToSigned<DF> di;
    const hn::Rebind<std::int16_t, DF> dh;
    const VF most = hn::Set(d, bounds * kUniformColors), share = hn::Set(d, kUniformShare);
    for (std::size_t c = 0; c < count; c += kFloats) {
        auto all = hn::Set(di, -1);
        for (const float* column : channel) {
            const auto at = [&](std::size_t off) HWY_ATTR { return hn::LoadU(d, column + c + off); };
            const VF p = at(0), q = at(1), r = at(row), s = at(row + 1);
            const VF low = hn::Min(hn::Min(p, q), hn::Min(r, s)), high = hn::Max(hn::Max(p, q), hn::Max(r, s));
            // Infinity minus infinity is NaN, for which the comparison fails.
            const auto within = hn::Le(hn::Sub(high, low), hn::Min(most, hn::Mul(share, high)));
            all = hn::IfThenElseZero(hn::RebindMask(di, within), all);
        }
        hn::StoreU(hn::DemoteTo(dh, all), dh, reinterpret_cast<std::int16_t*>(uniform + c));
    }
}

// The channels of kFloats colours, `apart` of them from one to the next.
using Channels = std::array<VF, 4>;
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Channels channelsOf(const PointColor* colors, std::size_t) {
    const auto one = [&](std::size_t n) { return hn::Set(DF(), colors->channel[n]); };
    return {one(0), one(1), one(2), one(3)};
}
#else
// Loads every fourth colour from the k-th on into a vector of N floats, a quarter for each.
template <std::size_t N>
HWY_INLINE auto quartersOf(const PointColor* colors, std::size_t apart, std::size_t k) {
    const hn::CappedTag<float, N> d;
    if constexpr (N > 4) {
        const auto low = quartersOf<N / 2>(colors, apart, k), high = quartersOf<N / 2>(colors, apart, k + N / 2);
        return hn::Combine(d, high, low);
    } else {
        return hn::Load(d, colors[k * apart].channel);
    }
}
HWY_INLINE Channels channelsOf(const PointColor* colors, std::size_t apart) {
    const DF d;
    // A transposition within quarters moves colour k to lane k.
    const VF r0 = quartersOf<kFloats>(colors, apart, 0), r1 = quartersOf<kFloats>(colors, apart, 1);
    const VF r2 = quartersOf<kFloats>(colors, apart, 2), r3 = quartersOf<kFloats>(colors, apart, 3);
    const VF even0 = hn::InterleaveLower(d, r0, r2), odd0 = hn::InterleaveLower(d, r1, r3);
    const VF even1 = hn::InterleaveUpper(d, r0, r2), odd1 = hn::InterleaveUpper(d, r1, r3);
    return {hn::InterleaveLower(d, even0, odd0), hn::InterleaveUpper(d, even0, odd0),
            hn::InterleaveLower(d, even1, odd1), hn::InterleaveUpper(d, even1, odd1)};
}
#endif

void splitCentres(const PointColor* colors, std::size_t points, const std::uint16_t* needed, std::size_t count,
                  const std::array<float*, 3>& out) {
    const DF d;
    const hn::RebindToUnsigned<DF> du;
    const hn::Rebind<std::uint16_t, DF> dh;
    const VF none = hn::Set(d, std::numeric_limits<float>::infinity());
    for (std::size_t c = 0; c < count; c += kFloats) {
        const auto bits = hn::PromoteTo(du, hn::And(hn::LoadU(dh, needed + c), hn::Set(dh, std::uint16_t{1})));
        const auto selected = hn::RebindMask(d, hn::Ne(bits, hn::Zero(du)));
        if (hn::AllFalse(d, selected)) {
            for (float* column : out) hn::StoreU(none, d, column + c);
            continue;
        }
        const Channels channel = channelsOf(colors + c * points, points);
        const auto known = hn::And(selected, hn::Gt(channel[3], hn::Zero(d)));
        for (std::size_t n = 0; n < out.size(); ++n) {
            hn::StoreU(hn::IfThenElse(known, channel[n], none), d, out[n] + c);
        }
    }
}

void sumPoints(const PointColor* colors, std::span<const std::int32_t> base, std::span<const std::int32_t> offset,
               std::span<const float> weight, std::span<PointColor> sums) {
    using DC = hn::CappedTag<float, 4>;
    const DC d;
    for (std::size_t n = 0; n < base.size(); ++n) {
        const PointColor* from = colors + base[n];
        for (std::size_t c = 0; c < 4; c += hn::MaxLanes(DC())) {
            auto sum = hn::Zero(d);
            for (std::size_t k = 0; k < offset.size(); ++k) {
                const auto color = hn::Load(d, from[offset[k]].channel + c);
                sum = hn::Add(sum, hn::Mul(hn::Set(d, weight[k]), color));
            }
            hn::Store(sum, d, sums[n].channel + c);
        }
    }
}

}  // namespace grid

// HWY_EXPORT needs these names in this namespace.
using grid::findUniform, grid::findSurroundings, grid::layFootprints, grid::raysThrough, grid::splitCentres,
    grid::sumPoints;

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(findSurroundings);
HWY_EXPORT(raysThrough);
HWY_EXPORT(layFootprints);
HWY_EXPORT(findUniform);
HWY_EXPORT(splitCentres);
HWY_EXPORT(sumPoints);

void findSurroundings(const CellHits& cells, float bounds, std::uint16_t* out) {
    HWY_DYNAMIC_DISPATCH(findSurroundings)(cells, bounds, out);
}

void raysThrough(const PixelView& view, std::span<const double> x, std::span<const double> y, RayBlock& rays,
                 std::size_t first) {
    assert(x.size() == y.size() && first + x.size() <= rays.size());
    HWY_DYNAMIC_DISPATCH(raysThrough)(view, x, y, rays, first);
}

void layFootprints(const PixelView& view, const SlopeScene* slopes, const PointBlur& blur, glm::dvec2 scale,
                   const PointHits& hits, PointBlock& points) {
    assert(hits.lambda.size() >= hits.x.size() && hits.s.size() >= hits.x.size());
    HWY_DYNAMIC_DISPATCH(layFootprints)(view, slopes, blur, scale, hits, points);
}

void findUniform(const std::array<const float*, 3>& channel, std::size_t row, std::size_t count, float bounds,
                 std::uint16_t* uniform) {
    HWY_DYNAMIC_DISPATCH(findUniform)(channel, row, count, bounds, uniform);
}

void splitCentres(const PointColor* colors, std::size_t points, const std::uint16_t* needed, std::size_t count,
                  const std::array<float*, 3>& out) {
    HWY_DYNAMIC_DISPATCH(splitCentres)(colors, points, needed, count, out);
}

void sumPoints(const PointColor* colors, std::span<const std::int32_t> base, std::span<const std::int32_t> offset,
               std::span<const float> weight, std::span<PointColor> sums) {
    assert(weight.size() == offset.size() && sums.size() >= base.size());
    HWY_DYNAMIC_DISPATCH(sumPoints)(colors, base, offset, weight, sums);
}

}  // namespace relief
#endif
