// SIMD version of OffsetTracer::shifted in double, one ray per lane: the same step with the same bits. Compiled for
// each target.

#if defined(RELIEF_OFFSET_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_OFFSET_LANES_INL_H
#undef RELIEF_OFFSET_LANES_INL_H
#else
#define RELIEF_OFFSET_LANES_INL_H
#endif

#include <algorithm>
#include <limits>

#include "relief/methods/offset_lanes.h"
#include "relief/ray_length.h"
#include "relief/simd/surface_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// One vector of rays, in memory: used where fewer rays remain than a vector has lanes.
struct OffsetRows {
    Row<double> s0{}, t0{}, a{}, b{}, lambda{}, s{}, t{};
};

template <class Visits>
class OffsetLanes {
  public:
    OffsetLanes(const OffsetSearch& search, const RayBlock& rays, HitBlock& hits, std::vector<std::size_t>& fallback)
        : field_(search.field),
          limited_(search.limited),
          surface_(field_),
          rays_(rays),
          hits_(hits),
          fallback_(fallback) {}

    void run(std::size_t first, std::size_t last) {
        std::size_t i = first;
        for (; i + kLanes <= last; i += kLanes) {
            shift(i, kLanes, {&rays_.s0[i], &rays_.t0[i], &rays_.a[i], &rays_.b[i]},
                  {&hits_.lambda[i], &hits_.s[i], &hits_.t[i]});
        }
        if (i == last) return;
        const std::size_t count = last - i;
        OffsetRows rest;
        const auto copy = [&](const std::vector<double>& from, Row<double>& to) {
            std::copy_n(from.data() + i, count, to.begin());
        };
        copy(rays_.s0, rest.s0), copy(rays_.t0, rest.t0), copy(rays_.a, rest.a), copy(rays_.b, rest.b);
        shift(i, count, {rest.s0.data(), rest.t0.data(), rest.a.data(), rest.b.data()},
              {rest.lambda.data(), rest.s.data(), rest.t.data()});
        std::copy_n(rest.lambda.begin(), count, hits_.lambda.data() + i);
        std::copy_n(rest.s.begin(), count, hits_.s.data() + i);
        std::copy_n(rest.t.begin(), count, hits_.t.data() + i);
    }

  private:
    struct Rays {
        const double *s0, *t0, *a, *b;
    };
    struct Hits {
        double *lambda, *s, *t;
    };
    // Traces `count` rays, the first of which is ray `first` of the block.
    HWY_INLINE void shift(std::size_t first, std::size_t count, const Rays& from, const Hits& to);
    // The share of the shift that the method takes.
    HWY_INLINE V share(const Rays& from) const;

    const HeightField& field_;
    bool limited_;
    SurfaceLanes surface_;
    const RayBlock& rays_;
    HitBlock& hits_;
    std::vector<std::size_t>& fallback_;
};

template <class Visits>
V OffsetLanes<Visits>::share(const Rays& from) const {
    if (!limited_) return constant(1);
    // std::hypot has no vector form of the same bits.
    Row<double> length;
    for (std::size_t n = 0; n < kLanes; ++n) length[n] = texelsPerLambda(from.a[n], from.b[n], field_.slabTexels());
    const V all = load(length);
    return hn::IfThenElse(hn::Gt(all, hn::Zero(D())), hn::Div(constant(field_.slabTexels()), all), constant(1));
}

template <class Visits>
void OffsetLanes<Visits>::shift(std::size_t first, std::size_t count, const Rays& from, const Hits& to) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const V s0 = hn::LoadU(D(), from.s0), t0 = hn::LoadU(D(), from.t0);
    const V a = hn::LoadU(D(), from.a), b = hn::LoadU(D(), from.b);
    const M finite =
        hn::And(hn::And(hn::Lt(hn::Abs(s0), constant(kInfinite)), hn::Lt(hn::Abs(t0), constant(kInfinite))),
                hn::And(hn::Lt(hn::Abs(a), constant(kInfinite)), hn::Lt(hn::Abs(b), constant(kInfinite))));
    M taken = finite;
    const bool repeats = field_.address() == Address::Repeat;
    if (repeats) taken = hn::And(taken, hn::Lt(hn::Max(hn::Abs(s0), hn::Abs(t0)), constant(kFar)));
    // Lanes that are not taken sample the origin, where loads are valid.
    V s = hn::IfThenElseZero(taken, s0), t = hn::IfThenElseZero(taken, t0);
    if (repeats) s = surface_.reduceToPeriod(s, field_.width()), t = surface_.reduceToPeriod(t, field_.height());
    const V height = surface_.at(s, t);
    const V lambda = hn::Mul(hn::Sub(constant(1), height), share(from));
    M met = taken;
    std::uint32_t sampled = bitsOf(taken);
    if (field_.address() == Address::Border) {
        const M enters = surface_.inside(s, t);
        sampled &= bitsOf(enters);
        met = hn::And(hn::And(met, enters),
                      surface_.inside(hn::Add(s, hn::Mul(lambda, a)), hn::Add(t, hn::Mul(lambda, b))));
    }
    const V none = constant(std::numeric_limits<double>::quiet_NaN());
    hn::StoreU(hn::IfThenElse(met, lambda, none), D(), to.lambda);
    hn::StoreU(hn::IfThenElse(met, hn::Add(s0, hn::Mul(lambda, a)), none), D(), to.s);
    hn::StoreU(hn::IfThenElse(met, hn::Add(t0, hn::Mul(lambda, b)), none), D(), to.t);
    const std::uint32_t hits = bitsOf(met);
    for (std::size_t n = 0; n < count; ++n) {
        hits_.outcome[first + n] = (hits >> n & 1) != 0 ? Outcome::Hit : Outcome::Miss;
    }
    const std::uint32_t all = (1U << count) - 1;
    overLanes(bitsOf(finite) & ~bitsOf(taken) & all, [&](std::size_t n) { fallback_.push_back(first + n); });
    if constexpr (Visits::kRecords) {
        std::array<std::size_t, kLanes> numbers{};
        for (std::size_t n = 0; n < count; ++n) numbers[n] = first + n;
        Visits::visit(numbers, sampled & all, height, lambda);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
