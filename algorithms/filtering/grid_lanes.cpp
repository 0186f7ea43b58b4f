#include "filtering/grid_lanes.h"

#include <algorithm>
#include <cassert>

// Vectors in arrays: not for the instruction sets without a fixed width.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/grid_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "relief/slope_lanes-inl.h"

#ifndef RELIEF_GRID_LANES_ONCE
#define RELIEF_GRID_LANES_ONCE
namespace relief {

// What layFootprints is given, but for the columns.
struct FootprintScene {
    const PixelView* view;
    SlopeScene slopes;
    bool bilinear;
    double blur, perS, perT;
};

// What sumPoints is given.
struct SumJob {
    const PointColor* colors;
    std::span<const std::int32_t> base, offset;
    const float* weight;
    PointColor* sums;
};

// Texels by which a centre's ray may lie outside the polygon by rounding.
inline constexpr double kEdgeRounding = 1e-6;
// Least 1 + r . g of a point's tangent plane: as in elliptical_rays.cpp.
inline constexpr double kLeastPointFacing = 1;

}  // namespace relief
#endif

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace grid {

namespace hn = hwy::HWY_NAMESPACE;

using slopes::D;
using slopes::kLanes;
using slopes::load;
using slopes::set;
using slopes::store;
using slopes::V;
using M = hn::Mask<D>;

struct Point {
    V s, t;
};
HWY_INLINE Point operator-(const Point& p, const Point& q) {
    return {hn::Sub(p.s, q.s), hn::Sub(p.t, q.t)};
}
HWY_INLINE Point operator+(const Point& p, const Point& q) {
    return {hn::Add(p.s, q.s), hn::Add(p.t, q.t)};
}
HWY_INLINE V square(const Point& p, V perS, V perT) {
    return hn::Add(hn::Mul(hn::Mul(p.s, p.s), perS), hn::Mul(hn::Mul(p.t, p.t), perT));
}

// Of the cells [at, at + count), which lie in a row.
HWY_INLINE void surroundingsOf(const CellHits& cells, std::size_t at, std::size_t count, std::uint16_t* out) {
    const D d;
    const auto row = static_cast<std::size_t>(cells.width);
    const V perS = set(cells.scale.x * cells.scale.x), perT = set(cells.scale.y * cells.scale.y);
    const V unseen = set(4 * kUnseenBend * kUnseenBend);
    const V plane = set(kMostBend * kMostBend), smooth = set(kMostSmoothBend * kMostSmoothBend);
    const V straight = set(kMostStraightBend * kMostStraightBend);
    const auto place = [&](std::size_t i) HWY_ATTR {
        return Point{load(cells.s + i, count), load(cells.t + i, count)};
    };
    const auto lambda = [&](std::size_t i) HWY_ATTR { return load(cells.lambda + i, count); };
    const Point own = place(at), twice = own + own;
    const V height = lambda(at), most = set(kLevelHeight);
    M onPlane = hn::Eq(own.s, own.s), onLevel = onPlane;
    V bits = hn::Zero(d);
    double bit = kSmooth;
    for (const std::size_t way : {std::size_t{1}, row, row + 1, row - 1}) {
        // The last way runs upwards.
        const Point after = place(at + way), before = place(at - way);
        // Four times the squares of half the first, of half the second difference. NaN fails.
        const V step = square(after - before, perS, perT), bend = square(after + before - twice, perS, perT);
        const auto within = [&](V share) HWY_ATTR { return hn::Le(bend, hn::Add(hn::Mul(share, step), unseen)); };
        onPlane = hn::And(onPlane, within(plane));
        bits = hn::Add(bits, hn::IfThenElseZero(within(smooth), set(bit)));
        bits = hn::Add(bits, hn::IfThenElseZero(within(straight), set(double{kStraight} * bit)));
        bit *= 2;
        onLevel = hn::And(onLevel, hn::And(hn::Le(hn::Abs(hn::Sub(lambda(at + way), height)), most),
                                           hn::Le(hn::Abs(hn::Sub(lambda(at - way), height)), most)));
    }
    bits = hn::Add(bits, hn::IfThenElseZero(onPlane, set(kOnPlane)));
    bits = hn::Add(bits, hn::IfThenElseZero(hn::And(onPlane, onLevel), set(kOnLevel)));
    const hn::Rebind<std::int32_t, D> di;
    HWY_ALIGN std::int32_t whole[kLanes];
    hn::Store(hn::DemoteTo(di, bits), di, whole);
    for (std::size_t n = 0; n < count; ++n) out[at + n] = static_cast<std::uint16_t>(whole[n]);
}

void findSurroundings(const CellHits& cells, std::uint16_t* out) {
    const auto width = static_cast<std::size_t>(cells.width), height = static_cast<std::size_t>(cells.height);
    std::fill_n(out, width * height, std::uint16_t{0});
    for (std::size_t y = 1; y + 1 < height; ++y) {
        for (std::size_t x = 1; x + 1 < width; x += kLanes) {
            surroundingsOf(cells, y * width + x, std::min(kLanes, width - 1 - x), out);
        }
    }
}

void raysThrough(const PixelView& view, const double* x, const double* y, std::size_t count, double* const* out) {
    const Homography& m = view.texelFromScreen;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const std::size_t here = std::min(kLanes, count - i);
        const V px = load(x + i, here), py = load(y + i, here);
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
        store(s0, out[0] + i, here);
        store(t0, out[1] + i, here);
        store(hn::Mul(hn::Sub(s0, set(view.sEye)), run), out[2] + i, here);
        store(hn::Mul(hn::Sub(t0, set(view.tEye)), run), out[3] + i, here);
    }
}

void layFootprints(const FootprintScene& scene, const PointHits& hits, PointBlock& points) {
    const PixelView& view = *scene.view;
    const Homography& m = view.texelFromScreen;
    // Derivatives of s and t along the picture times q^2, as jacobianAt has them.
    const double uxY = m.sx * m.qy - m.sy * m.qx, ux1 = m.sx * m.q1 - m.s1 * m.qx;
    const double vxY = m.tx * m.qy - m.ty * m.qx, vx1 = m.tx * m.q1 - m.t1 * m.qx;
    const double uyX = m.sy * m.qx - m.sx * m.qy, uy1 = m.sy * m.q1 - m.s1 * m.qy;
    const double vyX = m.ty * m.qx - m.tx * m.qy, vy1 = m.ty * m.q1 - m.t1 * m.qy;
    const V one = set(1), perS = set(scene.perS), perT = set(scene.perT);
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; i += kLanes) {
        const std::size_t here = std::min(kLanes, count - i);
        const V x = load(hits.x.data() + i, here), y = load(hits.y.data() + i, here);
        const V q = hn::Add(hn::Add(hn::Mul(set(m.qx), x), hn::Mul(set(m.qy), y)), set(m.q1));
        const V below = hn::Add(one, hn::Mul(load(hits.lambda.data() + i, here), set(view.runPerTexel)));
        const V factor = hn::Div(hn::Mul(set(scene.blur), below), hn::Mul(q, q));
        const auto along = [&](double per, double at, V place)
                               HWY_ATTR { return hn::Mul(factor, hn::Add(hn::Mul(set(per), place), set(at))); };
        V ux = along(uxY, ux1, y), vx = along(vxY, vx1, y), uy = along(uyX, uy1, x), vy = along(vyX, vy1, x);
        const Point place{load(hits.s.data() + i, here), load(hits.t.data() + i, here)};
        if (scene.bilinear) {
            const V a = load(hits.a.data() + i, here), b = load(hits.b.data() + i, here);
            const slopes::Slope slope = slopes::slopeAt(scene.slopes, place.s, place.t);
            const V facing = hn::Add(one, hn::Add(hn::Mul(a, slope.s), hn::Mul(b, slope.t)));
            const V per = hn::Div(one, hn::Max(facing, set(kLeastPointFacing)));
            const V alongX = hn::Mul(hn::Add(hn::Mul(slope.s, ux), hn::Mul(slope.t, vx)), per);
            const V alongY = hn::Mul(hn::Add(hn::Mul(slope.s, uy), hn::Mul(slope.t, vy)), per);
            ux = hn::Sub(ux, hn::Mul(a, alongX)), vx = hn::Sub(vx, hn::Mul(b, alongX));
            uy = hn::Sub(uy, hn::Mul(a, alongY)), vy = hn::Sub(vy, hn::Mul(b, alongY));
        }
        store(hn::Mul(place.s, perS), points.s.data() + i, here);
        store(hn::Mul(place.t, perT), points.t.data() + i, here);
        store(hn::Mul(ux, perS), points.ux.data() + i, here);
        store(hn::Mul(vx, perT), points.vx.data() + i, here);
        store(hn::Mul(uy, perS), points.uy.data() + i, here);
        store(hn::Mul(vy, perT), points.vy.data() + i, here);
    }
}

void sumPoints(const SumJob& job) {
    using DC = hn::CappedTag<float, 4>;
    const DC d;
    for (std::size_t n = 0; n < job.base.size(); ++n) {
        const PointColor* from = job.colors + job.base[n];
        for (std::size_t c = 0; c < 4; c += hn::MaxLanes(DC())) {
            auto sum = hn::Zero(d);
            for (std::size_t k = 0; k < job.offset.size(); ++k) {
                const auto color = hn::Load(d, from[job.offset[k]].channel + c);
                sum = hn::Add(sum, hn::Mul(hn::Set(d, job.weight[k]), color));
            }
            hn::Store(sum, d, job.sums[n].channel + c);
        }
    }
}

}  // namespace grid

// As the tables of targets want them.
void gridSurroundings(const CellHits& cells, std::uint16_t* out) {
    grid::findSurroundings(cells, out);
}
void gridRays(const PixelView& view, const double* x, const double* y, std::size_t count, double* const* out) {
    grid::raysThrough(view, x, y, count, out);
}
void gridFootprints(const FootprintScene& scene, const PointHits& hits, PointBlock& points) {
    grid::layFootprints(scene, hits, points);
}
void gridSums(const SumJob& job) {
    grid::sumPoints(job);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(gridSurroundings);
HWY_EXPORT(gridRays);
HWY_EXPORT(gridFootprints);
HWY_EXPORT(gridSums);

void findSurroundings(const CellHits& cells, std::uint16_t* out) {
    HWY_DYNAMIC_DISPATCH(gridSurroundings)(cells, out);
}

void raysThrough(const PixelView& view, std::span<const double> x, std::span<const double> y, RayBlock& rays,
                 std::size_t first) {
    assert(x.size() == y.size() && first + x.size() <= rays.size());
    double* const out[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                           rays.b.data() + first};
    HWY_DYNAMIC_DISPATCH(gridRays)(view, x.data(), y.data(), x.size(), out);
}

void layFootprints(const PixelView& view, const HeightField& field, double blur, glm::dvec2 scale,
                   const PointHits& hits, PointBlock& points) {
    assert(hits.x.size() == points.size() && hits.lambda.size() >= points.size());
    const FootprintScene scene{&view, SlopeScene(field), field.surface() == Surface::Bilinear, blur, scale.x, scale.y};
    HWY_DYNAMIC_DISPATCH(gridFootprints)(scene, hits, points);
}

void sumPoints(const PointColor* colors, std::span<const std::int32_t> base, std::span<const std::int32_t> offset,
               std::span<const float> weight, std::span<PointColor> sums) {
    assert(weight.size() == offset.size() && sums.size() >= base.size());
    HWY_DYNAMIC_DISPATCH(gridSums)({colors, base, offset, weight.data(), sums.data()});
}

}  // namespace relief
#endif
