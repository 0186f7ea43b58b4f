// Vectors of doubles, and vectors of as many floats and 32-bit integers. Compiled for each target.

#if defined(RELIEF_DOUBLE_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_DOUBLE_VECTORS_INL_H
#undef RELIEF_DOUBLE_VECTORS_INL_H
#else
#define RELIEF_DOUBLE_VECTORS_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::ScalableTag<double>;
using VD = hn::Vec<DD>;
using MD = hn::Mask<DD>;
using DHF = hn::Rebind<float, DD>;
using DHI = hn::Rebind<std::int32_t, DD>;
using VHI = hn::Vec<DHI>;

inline constexpr std::size_t kHalfLanes = hn::MaxLanes(DD());

// Calls body(lane) for each lane whose bit is set.
template <class Body>
HWY_INLINE void overLanes(std::uint64_t lanes, const Body& body) {
    for (; lanes != 0; lanes &= lanes - 1) body(static_cast<std::size_t>(__builtin_ctzll(lanes)));
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
