// Arithmetic for SIMD traversals that rounds as their references do: separate products and sums, true quotients.
// Compiled for each target.

#if defined(RELIEF_PLAIN_ARITHMETIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_PLAIN_ARITHMETIC_INL_H
#undef RELIEF_PLAIN_ARITHMETIC_INL_H
#else
#define RELIEF_PLAIN_ARITHMETIC_INL_H
#endif

#include "relief/simd/lane_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

struct PlainArithmetic {
    static constexpr bool kBeams = false;
    HWY_INLINE static VF mulAdd(VF a, VF b, VF c) { return hn::Add(hn::Mul(a, b), c); }
    HWY_INLINE static VF mulSub(VF a, VF b, VF c) { return hn::Sub(hn::Mul(a, b), c); }
    HWY_INLINE static VF negMulAdd(VF a, VF b, VF c) { return hn::Sub(c, hn::Mul(a, b)); }
    HWY_INLINE static VF reciprocal(VF a) { return hn::Div(hn::Set(DF(), 1.0F), a); }
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
