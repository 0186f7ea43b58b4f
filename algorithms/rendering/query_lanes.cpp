#include "rendering/query_lanes.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "relief/methods/look_up_point.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rendering/query_lanes.cpp"
#include <hwy/foreach_target.h>
// Must be included after foreach_target.h.
#include "relief/simd/slope_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Repeats jacobianAt() and pixelQuery() operation by operation.
void queryJacobians(const PixelView& view, const double* lambda, int x, int y, std::size_t count, double* const* out) {
    using slopes::V;
    const slopes::D d;
    const Homography& m = view.texelFromScreen;
    const double atY = y + 0.5;
    const V a = slopes::set((m.sx * m.qy - m.sy * m.qx) * atY + (m.sx * m.q1 - m.s1 * m.qx));
    const V b = slopes::set((m.tx * m.qy - m.ty * m.qx) * atY + (m.tx * m.q1 - m.t1 * m.qx));
    const V perX = slopes::set(m.sy * m.qx - m.sx * m.qy), atX = slopes::set(m.sy * m.q1 - m.s1 * m.qy);
    const V perX2 = slopes::set(m.ty * m.qx - m.tx * m.qy), atX2 = slopes::set(m.ty * m.q1 - m.t1 * m.qy);
    const V one = slopes::set(1), spread = slopes::set(view.runPerTexel);
    for (std::size_t i = 0; i < count; i += slopes::kLanes) {
        const std::size_t here = std::min(slopes::kLanes, count - i);
        const V px = hn::Add(hn::Iota(d, x + static_cast<double>(i)), slopes::set(0.5));
        const V q = hn::Add(hn::Add(hn::Mul(slopes::set(m.qx), px), slopes::set(m.qy * atY)), slopes::set(m.q1));
        const V square = hn::Mul(q, q);
        const V scale = hn::Add(one, hn::Mul(slopes::load(lambda + i, here), spread));
        const auto put = [&](V derivative, double* to)
                             HWY_ATTR { slopes::store(hn::Mul(hn::Div(derivative, square), scale), to + i, here); };
        put(a, out[0]);
        put(b, out[1]);
        put(hn::Add(hn::Mul(perX, px), atX), out[2]);
        put(hn::Add(hn::Mul(perX2, px), atX2), out[3]);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(queryJacobians);

void setQueries(const QueryRun& run, const HeightField& field, FilterBlock& block, std::size_t first) {
    assert(first + run.count <= block.size());
    const auto from = static_cast<std::ptrdiff_t>(run.from), to = static_cast<std::ptrdiff_t>(first);
    const auto count = static_cast<std::ptrdiff_t>(run.count);
    const auto copy = [&](const std::vector<double>& column, std::vector<double>& out) {
        std::copy_n(column.begin() + from, count, out.begin() + to);
    };
    if (block.picture == nullptr) {
        copy(run.rays.s0, block.rays.s0);
        copy(run.rays.t0, block.rays.t0);
        copy(run.rays.a, block.rays.a);
        copy(run.rays.b, block.rays.b);
    }
    copy(run.hits.lambda, block.lambda);
    copy(run.hits.s, block.s);
    copy(run.hits.t, block.t);
    if (field.surface() == Surface::Columns) {
        for (std::size_t n = 0; n < run.count; ++n) {
            const glm::dvec2 place = lookUpPoint(field, run.rays[run.from + n], run.hits[run.from + n]);
            block.s[first + n] = place.x, block.t[first + n] = place.y;
        }
    }
    std::fill_n(block.spread.begin() + to, count, run.polygon.runPerTexel);
    std::fill_n(block.view.begin() + to, count, &run.polygon);
    std::iota(block.x.begin() + to, block.x.begin() + to + count, run.x);
    std::fill_n(block.y.begin() + to, count, run.y);
    double* const out[] = {block.ux.data() + first, block.vx.data() + first, block.uy.data() + first,
                           block.vy.data() + first};
    HWY_DYNAMIC_DISPATCH(queryJacobians)
    (run.polygon, run.hits.lambda.data() + run.from, run.x, run.y, run.count, out);
}

}  // namespace relief
#endif
