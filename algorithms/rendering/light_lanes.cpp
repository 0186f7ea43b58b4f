#include "rendering/light_lanes.h"

#include <cassert>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rendering/light_lanes.cpp"
#include <hwy/foreach_target.h>
// Must be included after foreach_target.h.
#include "relief/simd/slope_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class SlopeAt>
HWY_INLINE void facingWith(const SlopeAt& slopeAt, const ReliefAxes& axes, double slabTexels, const glm::dvec3& toLight,
                           std::span<const double> s, std::span<const double> t, double* out) {
    using slopes::V;
    const slopes::D d;
    const hn::Rebind<float, slopes::D> df;
    const V slab = slopes::set(slabTexels), one = slopes::set(1);
    for (std::size_t i = 0; i < s.size(); i += slopes::kLanes) {
        const std::size_t here = std::min(slopes::kLanes, s.size() - i);
        const auto slope = slopeAt(slopes::load(s.data() + i, here), slopes::load(t.data() + i, here));
        const V alongS = hn::Mul(slab, slope.s), alongT = hn::Mul(slab, slope.t);
        const auto leant = [&](int c) HWY_ATTR {
            return hn::Sub(hn::Sub(slopes::set(axes.normal[c]), hn::Mul(alongS, slopes::set(axes.alongS[c]))),
                           hn::Mul(alongT, slopes::set(axes.alongT[c])));
        };
        const V x = leant(0), y = leant(1), z = leant(2);
        const V square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const V per = hn::Div(one, hn::Sqrt(square));
        const auto part = [&](V v, int c) HWY_ATTR {
            return hn::Mul(hn::PromoteTo(d, hn::DemoteTo(df, hn::Mul(v, per))), slopes::set(toLight[c]));
        };
        slopes::store(hn::Add(hn::Add(part(x, 0), part(y, 1)), part(z, 2)), out + i, here);
    }
}

void facingLanes(const SlopeScene& scene, const ReliefAxes& axes, double slabTexels, const glm::dvec3& toLight,
                 std::span<const double> s, std::span<const double> t, double* out) {
    slopes::withSlopes(
        scene, [&](const auto& slopeAt) HWY_ATTR { facingWith(slopeAt, axes, slabTexels, toLight, s, t, out); });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(facingLanes);

void facingLight(const SlopeScene& scene, const ReliefAxes& axes, double slabTexels, glm::dvec3 toLight,
                 std::span<const double> s, std::span<const double> t, std::span<double> out) {
    assert(s.size() == t.size() && out.size() == s.size());
    HWY_DYNAMIC_DISPATCH(facingLanes)(scene, axes, slabTexels, toLight, s, t, out.data());
}

}  // namespace relief
#endif
