// SIMD version of LayersTracerOf::trace in double, one ray per lane: the same steps with the same bits. Compiled for
// each target.

#if defined(RELIEF_LAYER_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LAYER_LANES_INL_H
#undef RELIEF_LAYER_LANES_INL_H
#else
#define RELIEF_LAYER_LANES_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "relief/cell_grid.h"
#include "relief/methods/layer_lanes.h"
#include "relief/simd/bisection_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

using LayerQueue = BracketQueue<LayerSearch>;

// A vector of rays in flight through the layers.
template <class Visits>
class LayerWalk : public VectorOfRays<LayerWalk<Visits>, LayerSearch> {
  public:
    explicit LayerWalk(LayerQueue& queue)
        : Rays(queue), brackets_(queue.brackets), field_(queue.search.field), surface_(field_) {}

    bool take(std::size_t lane, const ViewRay& ray, std::size_t number);
    void step();

  private:
    using Rays = VectorOfRays<LayerWalk, LayerSearch>;
    using Rays::active_;
    using Rays::queue_;
    using Rays::ray_;
    void finish(std::size_t lane, bool inside);

    std::vector<Bracket>& brackets_;
    const HeightField& field_;
    SurfaceLanes surface_;
    Row<double> s0_{}, t0_{}, a_{}, b_{}, layer_{}, lambda_{}, gap_{}, above_{}, gapAbove_{};
};

template <class Visits>
bool LayerWalk<Visits>::take(std::size_t lane, const ViewRay& ray, std::size_t number) {
    const bool repeats = field_.address() == Address::Repeat;
    if (repeats && !(std::max(std::abs(ray.a), std::abs(ray.b)) < kFar)) {
        queue_.fallback.push_back(number);
        return false;
    }
    s0_[lane] = repeats ? reduceToPeriod(ray.s0, field_.width()) : ray.s0;
    t0_[lane] = repeats ? reduceToPeriod(ray.t0, field_.height()) : ray.t0;
    a_[lane] = ray.a, b_[lane] = ray.b;
    layer_[lane] = 0;
    return true;
}

template <class Visits>
void LayerWalk<Visits>::step() {
    const V one = constant(1), zero = hn::Zero(D());
    const V layer = load(layer_);
    const V lambda = hn::Min(hn::Div(layer, constant(queue_.search.layers)), one);
    const V s = hn::Add(load(s0_), hn::Mul(lambda, load(a_)));
    const V t = hn::Add(load(t0_), hn::Mul(lambda, load(b_)));
    const V gap = hn::Sub(surface_.at(s, t), hn::Sub(one, lambda));
    M inside = hn::Eq(zero, zero);
    if (field_.address() == Address::Border) {
        inside = surface_.inside(s, t);
    }
    const M ends = hn::Or(hn::Not(inside), hn::Or(hn::Ge(gap, zero), hn::Ge(lambda, one)));
    if constexpr (Visits::kRecords) Visits::visit(ray_, active_ & bitsOf(inside), layer, lambda, gap);
    const std::uint32_t done = bitsOf(ends) & active_;
    if (done != 0) {
        store(lambda, lambda_), store(gap, gap_);
        const std::uint32_t in = bitsOf(inside);
        overLanes(done, [&](std::size_t lane) { finish(lane, (in >> lane & 1) != 0); });
        active_ &= ~done;
    }
    store(hn::Add(layer, one), layer_), store(lambda, above_), store(gap, gapAbove_);
}

template <class Visits>
void LayerWalk<Visits>::finish(std::size_t lane, bool inside) {
    const std::size_t i = ray_[lane];
    if (!inside) {
        queue_.hits.set(i, Hit::none(Outcome::Miss));
        return;
    }
    double lambda = lambda_[lane];
    if (layer_[lane] > 0 && queue_.search.refinement == LayerRefinement::Bisection) {
        brackets_.push_back({i, {s0_[lane], t0_[lane], a_[lane], b_[lane]}, above_[lane], lambda});
        return;
    }
    if (layer_[lane] > 0 && queue_.search.refinement == LayerRefinement::Secant) {
        const double share = gapAbove_[lane] / (gapAbove_[lane] - std::max(gap_[lane], 0.0));
        lambda = above_[lane] + share * (lambda - above_[lane]);
    }
    queue_.hits.set(i, Hit::at(queue_.rays[i], lambda));
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
