// SIMD version of DistanceMarch::trace in double, one ray per lane: the same steps with the same bits. Compiled for
// each target.

#if defined(RELIEF_DISTANCE_MARCH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_DISTANCE_MARCH_LANES_INL_H
#undef RELIEF_DISTANCE_MARCH_LANES_INL_H
#else
#define RELIEF_DISTANCE_MARCH_LANES_INL_H
#endif

#include <array>
#include <cmath>

#include "relief/methods/distance_march_lanes.h"
#include "relief/ray_length.h"
#include "relief/sampled_surface.h"
#include "relief/simd/stored_lanes-inl.h"
#include "relief/simd/surface_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// DistanceMap::trilinear.
class DistanceLanes {
  public:
    explicit DistanceLanes(const DistanceMap& map)
        : values_(map.values),
          nx_(map.nx()),
          ny_(map.ny()),
          layers_(map.layers()),
          fieldWidth_(map.fieldWidth),
          fieldHeight_(map.fieldHeight),
          repeats_(map.address == Address::Repeat) {}

    HWY_INLINE V at(V s, V t, V z) const {
        const V half = constant(0.5), one = constant(1), zero = hn::Zero(D());
        const V x = hn::Sub(hn::Div(hn::Mul(s, constant(nx_)), constant(fieldWidth_)), half);
        const V y = hn::Sub(hn::Div(hn::Mul(t, constant(ny_)), constant(fieldHeight_)), half);
        const V last = constant(layers_ - 1);
        const V w = hn::Min(hn::Max(hn::Sub(hn::Mul(z, constant(layers_)), half), zero), last);
        const V x0 = hn::Floor(x), y0 = hn::Floor(y), k0 = hn::Floor(w);
        const V share = hn::Sub(w, k0), u = hn::Sub(x, x0), v = hn::Sub(y, y0);
        const V plane = constant(nx_ * ny_);
        const V lower = hn::Mul(k0, plane), upper = hn::Mul(hn::Min(hn::Add(k0, one), last), plane);
        const V i0 = addressed(x0, nx_), i1 = addressed(hn::Add(x0, one), nx_);
        const V j0 = hn::Mul(addressed(y0, ny_), constant(nx_));
        const V j1 = hn::Mul(addressed(hn::Add(y0, one), ny_), constant(nx_));
        const auto column = [&](V i, V j) {
            const V place = hn::Add(j, i);
            const V below = values_.at(hn::Add(lower, place));
            return hn::Add(below, hn::Mul(share, hn::Sub(values_.at(hn::Add(upper, place)), below)));
        };
        const V c00 = column(i0, j0), c01 = column(i0, j1);
        const V top = hn::Add(c00, hn::Mul(u, hn::Sub(column(i1, j0), c00)));
        const V bottom = hn::Add(c01, hn::Mul(u, hn::Sub(column(i1, j1), c01)));
        return hn::Add(top, hn::Mul(v, hn::Sub(bottom, top)));
    }

  private:
    HWY_INLINE V addressed(V i, double size) const { return addressedIndex(i, size, repeats_); }

    StoredLanes values_;
    double nx_, ny_, layers_, fieldWidth_, fieldHeight_;
    bool repeats_;
};

// A vector of rays in flight.
template <class Visits>
class DistanceSteps : public VectorOfRays<DistanceSteps<Visits>, MarchSearch> {
  public:
    explicit DistanceSteps(RayQueue<MarchSearch>& queue)
        : Rays(queue), field_(queue.search.field), surface_(field_), distance_(queue.search.map) {}

    bool take(std::size_t lane, const ViewRay& ray, std::size_t number);
    void step();

  private:
    using Rays = VectorOfRays<DistanceSteps, MarchSearch>;
    using Rays::active_;
    using Rays::queue_;
    using Rays::ray_;
    const HeightField& field_;
    SurfaceLanes surface_;
    DistanceLanes distance_;
    Row<double> s0_{}, t0_{}, a_{}, b_{}, perLambda_{}, lambda_{}, left_{}, above_{}, gapAbove_{}, gap_{};
};

template <class Visits>
bool DistanceSteps<Visits>::take(std::size_t lane, const ViewRay& ray, std::size_t number) {
    const bool served = std::hypot(ray.a, ray.b) <= queue_.search.map.maxRun;
    if (!served || !(std::max(std::abs(ray.a), std::abs(ray.b)) < kFar)) {
        queue_.fallback.push_back(number);
        return false;
    }
    const SampledSurface surface(field_, ray);
    if (!surface.inside(0)) {
        queue_.hits.set(number, Hit::none(Outcome::Miss));
        return false;
    }
    const auto [s0, t0] = surface.placeAt(0);
    s0_[lane] = s0, t0_[lane] = t0, a_[lane] = ray.a, b_[lane] = ray.b;
    perLambda_[lane] = texelsPerLambda(ray.a, ray.b, queue_.search.map.slabTexels);
    lambda_[lane] = 0;
    left_[lane] = queue_.search.iterations;
    return true;
}

template <class Visits>
void DistanceSteps<Visits>::step() {
    const V one = constant(1), zero = hn::Zero(D());
    const V s0 = load(s0_), t0 = load(t0_), a = load(a_), b = load(b_);
    const V lambda = load(lambda_), perLambda = load(perLambda_);
    const V s = hn::Add(s0, hn::Mul(lambda, a)), t = hn::Add(t0, hn::Mul(lambda, b));
    const V distance = distance_.at(s, t, hn::Sub(one, lambda));
    M arrived = hn::Ne(zero, zero);
    if (queue_.search.end.stop == MarchStop::Surface) {
        const V gap = hn::Sub(surface_.at(s, t), hn::Sub(one, lambda));
        arrived = hn::Ge(gap, zero);
        store(gap, gap_);
        store(hn::IfThenElse(arrived, load(above_), lambda), above_);
        store(hn::IfThenElse(arrived, load(gapAbove_), gap), gapAbove_);
    } else if (queue_.search.end.stop == MarchStop::Distance) {
        arrived = hn::Lt(distance, constant(queue_.search.end.within));
    }
    const V further = hn::Min(hn::Add(lambda, hn::Div(distance, perLambda)), one);
    const V after = hn::IfThenElse(arrived, lambda, hn::IfThenElse(hn::Gt(perLambda, zero), further, one));
    if constexpr (Visits::kRecords) Visits::visit(ray_, active_ & ~bitsOf(arrived), lambda, distance, after);
    const V left = hn::Sub(load(left_), one);
    M inside = hn::Eq(zero, zero);
    if (field_.address() == Address::Border) {
        inside = surface_.inside(hn::Add(s0, hn::Mul(after, a)), hn::Add(t0, hn::Mul(after, b)));
    }
    const M more = hn::And(hn::Gt(left, zero), hn::Lt(after, one));
    const M goesOn = hn::AndNot(arrived, hn::And(inside, more));
    store(after, lambda_), store(left, left_);
    const std::uint32_t done = active_ & ~bitsOf(goesOn);
    const std::uint32_t in = bitsOf(inside);
    const std::uint32_t met = queue_.search.end.stop == MarchStop::Surface ? bitsOf(arrived) : 0;
    active_ &= ~done;
    overLanes(done, [&](std::size_t lane) {
        const std::size_t i = ray_[lane];
        const bool hit = (in >> lane & 1) != 0;
        if ((met >> lane & 1) != 0 && left_[lane] + 1 < queue_.search.iterations) {
            const double share = gapAbove_[lane] / (gapAbove_[lane] - gap_[lane]);
            lambda_[lane] = above_[lane] + share * (lambda_[lane] - above_[lane]);
        }
        queue_.hits.set(i, hit ? Hit::at(queue_.rays[i], lambda_[lane]) : Hit::none(Outcome::Miss));
        lambda_[lane] = 0;  // idle lanes stay at the start, where loads are valid
    });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
