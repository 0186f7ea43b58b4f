// Weights of the texels of an ellipse's rows, one pixel per lane. Included by elliptical_lanes.cpp and compiled for
// each target.

#if defined(RELIEF_LANE_WEIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_WEIGHTS_INL_H
#undef RELIEF_LANE_WEIGHTS_INL_H
#else
#define RELIEF_LANE_WEIGHTS_INL_H
#endif

#include "filtering/simd/lane_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// 2^x for |x| <= 126, by a polynomial on [-1/2, 1/2]. x is rounded to the nearest integer (half to even) by adding a
// number so large that floats are integers there; the lowest bits of the sum are those of that integer.
template <std::size_t kTerms>
HWY_INLINE V powerOf(V x, const std::array<float, kTerms>& terms) {
    constexpr float kWhole = 0x1.8p23F;
    const V sum = hn::Add(x, set(kWhole));
    const V rest = hn::Sub(x, hn::Sub(sum, set(kWhole)));
    V p = set(terms.back());
    for (std::size_t n = kTerms - 1; n-- > 0;) p = hn::Add(hn::Mul(p, rest), set(terms[n]));
    const VI power = hn::Add(hn::ShiftLeft<23>(hn::BitCast(DI(), sum)), setI(127 << 23));
    return hn::Mul(p, hn::BitCast(D(), power));
}

// 2^x for x <= 0; not below 2^-126.
HWY_INLINE V exp2Of(V x) {
    return powerOf(hn::Max(x, set(-126)), kExp2);
}

// 2^x with a relative error of 2e-7, for |x| < 126.
HWY_INLINE V preciseExp2Of(V x) {
    return powerOf(x, kPreciseExp2);
}

// Weights, given the coefficients of their exponents (Footprints::acrossRow, downRow).
//
// Run(weight, x, row, middle) yields the weights of a row's texels one after the other by next(weight). x: distance of
// the first texel from the row's middle; row: the result of row().
struct GaussianLanes {
    V acrossRow, downRow;
    HWY_INLINE GaussianLanes(V across, V down) : acrossRow(across), downRow(down) {}
    HWY_INLINE V row(V v, V) const { return hn::Mul(downRow, hn::Mul(v, v)); }
    HWY_INLINE V at(V x, V row) const { return exp2Of(hn::Sub(hn::Neg(row), hn::Mul(acrossRow, hn::Mul(x, x)))); }

    struct Run {
        V x, row;
        Run() = default;
        HWY_INLINE Run(const GaussianLanes&, V first, V rowTerm, V) : x(first), row(rowTerm) {}
        HWY_INLINE V next(const GaussianLanes& g) {
            const V now = g.at(x, row);
            x = hn::Add(x, set(1));
            return now;
        }
    };
};
// Gaussian weights where none is very small (kMostRunExponent). In a row each weight is the one before it times a
// ratio, and the ratio changes by a constant ratio: two multiplications instead of an exponential. The error grows to
// 1e-5 after kLanePad texels, where a run ends.
struct GaussianRuns : GaussianLanes {
    V bend;
    HWY_INLINE GaussianRuns(V across, V down)
        : GaussianLanes(across, down), bend(preciseExp2Of(within(hn::Mul(set(-2), across)))) {}

    struct Run {
        V weight, ratio;
        Run() = default;
        HWY_INLINE Run(const GaussianRuns& g, V x, V row, V)
            : weight(g.at(x, row)),
              ratio(preciseExp2Of(within(hn::Neg(hn::Mul(g.acrossRow, hn::Add(hn::Add(x, x), set(1))))))) {}
        HWY_INLINE V next(const GaussianRuns& g) {
            const V now = weight;
            weight = hn::Mul(weight, ratio);
            ratio = hn::Mul(ratio, g.bend);
            return now;
        }
    };

  private:
    // Does not change lanes that are summed.
    HWY_INLINE static V within(V x) { return hn::Min(hn::Max(x, set(-100)), set(100)); }
};
struct UniformLanes {
    HWY_INLINE UniformLanes(V, V) {}
    HWY_INLINE V row(V, V) const { return set(1); }
    struct Run {
        Run() = default;
        HWY_INLINE Run(const UniformLanes&, V, V, V) {}
        HWY_INLINE V next(const UniformLanes&) const { return set(1); }
    };
};
struct TexelDistanceLanes {
    HWY_INLINE TexelDistanceLanes(V, V) {}
    HWY_INLINE V row(V v, V) const { return hn::Mul(v, v); }
    struct Run {
        V u, row;
        Run() = default;
        HWY_INLINE Run(const TexelDistanceLanes&, V x, V vv, V middle) : u(hn::Add(x, middle)), row(vv) {}
        HWY_INLINE V next(const TexelDistanceLanes&) {
            const V now = u;
            u = hn::Add(u, set(1));
            return hn::Div(set(1), hn::Add(set(1), hn::Sqrt(hn::Add(hn::Mul(now, now), row))));
        }
    };
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
