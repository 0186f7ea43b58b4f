// Texels of lane_levels.h in lanes, one pixel or point a lane: shared by what reads them, compiled for each target.

#if defined(RELIEF_LANE_TEXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_TEXELS_INL_H
#undef RELIEF_LANE_TEXELS_INL_H
#else
#define RELIEF_LANE_TEXELS_INL_H
#endif

#include <hwy/highway.h>

#include "filtering/lane_job.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kMostLanes>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

HWY_INLINE V set(float x) {
    return hn::Set(D(), x);
}
HWY_INLINE VI setI(std::int32_t x) {
    return hn::Set(DI(), x);
}
HWY_INLINE V toFloat(VI x) {
    return hn::ConvertTo(D(), x);
}
// Of whole numbers.
HWY_INLINE VI toInt(V x) {
    return hn::ConvertTo(DI(), x);
}

// i modulo size, in [0, size). |i|, size < 2^23: then the quotient's floor is right, however it is rounded.
HWY_INLINE VI wrapped(VI i, VI size) {
    const V quotient = hn::Floor(hn::Div(toFloat(i), toFloat(size)));
    return hn::Sub(i, hn::Mul(toInt(quotient), size));
}

struct Pair {
    VU redGreen0, blue0, redGreen1, blue1;
};

// Two texels of each pixel k, the first at texels + offset[k].
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Pair loadPair(const std::uint64_t* texels, const std::int32_t* offset) {
    const std::uint64_t* at = texels + offset[0];
    const auto low = [](std::uint64_t texel) { return hn::Set(DU(), static_cast<std::uint32_t>(texel)); };
    return {low(at[0]), low(at[0] >> 32), low(at[1]), low(at[1] >> 32)};
}
#else
// Of N pixels from the k-th on, four apart: their two texels, a quarter of the vector each.
template <std::size_t N>
HWY_INLINE auto quarters(const std::uint64_t* HWY_RESTRICT texels, const std::int32_t* HWY_RESTRICT offset,
                         std::size_t k) {
    const hn::CappedTag<std::uint32_t, N> d;
    if constexpr (N > 4) {
        const auto low = quarters<N / 2>(texels, offset, k);
        const auto high = quarters<N / 2>(texels, offset, k + N / 2);
        return hn::Combine(d, high, low);
    } else {
        return hn::LoadU(d, reinterpret_cast<const std::uint32_t*>(texels + offset[k]));
    }
}

HWY_INLINE Pair loadPair(const std::uint64_t* HWY_RESTRICT texels, const std::int32_t* HWY_RESTRICT offset) {
    const DU d;
    // A transposition within quarters puts pixel k in lane k.
    const VU r0 = quarters<kLanes>(texels, offset, 0), r1 = quarters<kLanes>(texels, offset, 1);
    const VU r2 = quarters<kLanes>(texels, offset, 2), r3 = quarters<kLanes>(texels, offset, 3);
    const VU even0 = hn::InterleaveLower(d, r0, r2), odd0 = hn::InterleaveLower(d, r1, r3);
    const VU even1 = hn::InterleaveUpper(d, r0, r2), odd1 = hn::InterleaveUpper(d, r1, r3);
    return {hn::InterleaveLower(d, even0, odd0), hn::InterleaveUpper(d, even0, odd0),
            hn::InterleaveLower(d, even1, odd1), hn::InterleaveUpper(d, even1, odd1)};
}
#endif

HWY_INLINE VI perLevel(const LaneLevels::PerLevel<std::int32_t>& table, VI level) {
    return hn::GatherIndex(DI(), table.data(), level);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
