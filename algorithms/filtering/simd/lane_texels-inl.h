// Access to the texels of lane_levels.h in SIMD, one pixel or point per lane; compiled for each target.

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
// x: integers.
HWY_INLINE VI toInt(V x) {
    return hn::ConvertTo(DI(), x);
}

// i modulo size, in [0, size). For |i|, size < 2^23 the quotient's floor is correct despite rounding.
HWY_INLINE VI wrapped(VI i, VI size) {
    const V quotient = hn::Floor(hn::Div(toFloat(i), toFloat(size)));
    return hn::Sub(i, hn::Mul(toInt(quotient), size));
}

struct Pair {
    VU redGreen0, blue0, redGreen1, blue1;
};

// Loads two texels of each pixel k, the first at texels + offset[k].
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Pair loadPair(const std::uint64_t* texels, const std::int32_t* offset) {
    const std::uint64_t* at = texels + offset[0];
    const auto low = [](std::uint64_t texel) { return hn::Set(DU(), static_cast<std::uint32_t>(texel)); };
    return {low(at[0]), low(at[0] >> 32), low(at[1]), low(at[1] >> 32)};
}
#else
// Loads the two texels of every fourth pixel from the k-th on into a vector of N words, a quarter of four words for
// each pixel.
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
    // A transposition within quarters moves pixel k to lane k.
    const VU r0 = quarters<kLanes>(texels, offset, 0), r1 = quarters<kLanes>(texels, offset, 1);
    const VU r2 = quarters<kLanes>(texels, offset, 2), r3 = quarters<kLanes>(texels, offset, 3);
    const VU even0 = hn::InterleaveLower(d, r0, r2), odd0 = hn::InterleaveLower(d, r1, r3);
    const VU even1 = hn::InterleaveUpper(d, r0, r2), odd1 = hn::InterleaveUpper(d, r1, r3);
    return {hn::InterleaveLower(d, even0, odd0), hn::InterleaveUpper(d, even0, odd0),
            hn::InterleaveLower(d, even1, odd1), hn::InterleaveUpper(d, even1, odd1)};
}
#endif

// Doubles, half as many as there are floats in a vector.
using DH = hn::CappedTag<double, kMostLanes / 2>;
using VH = hn::Vec<DH>;
constexpr std::size_t kHalf = hn::MaxLanes(DH());

// SIMD version of placed() (lane_job.cpp) for pixels [i, i + kHalf).
HWY_INLINE hn::Mask<DH> placeLanes(const double* HWY_RESTRICT at, double per, double size, bool repeat,
                                   std::int32_t* HWY_RESTRICT whole, float* HWY_RESTRICT rest) {
    const DH d;
    const VH most = hn::Set(d, size), zero = hn::Zero(d);
    VH x = hn::Mul(hn::LoadU(d, at), hn::Set(d, per));
    const auto valid = hn::Le(hn::Abs(x), hn::Set(d, kFarthest));
    if (repeat) {
        const auto inside = [&](VH v) HWY_ATTR { return hn::And(hn::Ge(v, zero), hn::Lt(v, most)); };
        if (!hn::AllTrue(d, inside(x))) {
            const VH reduced = hn::Sub(x, hn::Mul(hn::Floor(hn::Div(x, most)), most));
            x = hn::IfThenElse(inside(x), x, hn::IfThenElseZero(inside(reduced), reduced));
        }
    } else {
        const VH beyond = hn::Set(d, kBeyond * size);
        x = hn::Min(hn::Max(x, hn::Neg(beyond)), beyond);
    }
    x = hn::IfThenElseZero(valid, x);
    const VH floor = hn::Floor(x);
    hn::StoreU(hn::DemoteTo(hn::Rebind<std::int32_t, DH>(), floor), hn::Rebind<std::int32_t, DH>(), whole);
    hn::StoreU(hn::DemoteTo(hn::Rebind<float, DH>(), hn::Sub(x, floor)), hn::Rebind<float, DH>(), rest);
    return valid;
}

// SIMD version of LaneChunk::fill, with the same bits.
inline void fillChunk(const LaneJob& job, std::size_t begin, LaneChunk& chunk) {
    const DH d;
    const hn::Rebind<float, DH> df;
    const bool repeat = job.levels->address == Address::Repeat;
    chunk.count = std::min(kLanePixels, job.count - begin);
    std::size_t k = 0;
    for (; k + kHalf <= chunk.count; k += kHalf) {
        const std::size_t i = begin + k;
        const auto s = placeLanes(job.s + i, job.perS, job.width, repeat, chunk.wholeS + k, chunk.restS + k);
        const auto t = placeLanes(job.t + i, job.perT, job.height, repeat, chunk.wholeT + k, chunk.restT + k);
        const VH valid = hn::IfThenElseZero(hn::And(s, t), hn::Set(d, 1.0));
        hn::StoreU(hn::DemoteTo(df, valid), df, chunk.valid + k);
        const auto narrow = [&](const double* from, std::size_t n, double per, float* to) HWY_ATTR {
            hn::StoreU(from == nullptr ? hn::LoadU(df, job.narrow[n] + i)
                                       : hn::DemoteTo(df, hn::Mul(hn::LoadU(d, from + i), hn::Set(d, per))),
                       df, to + k);
        };
        narrow(job.ux, 0, job.perS, chunk.ux);
        narrow(job.vx, 1, job.perT, chunk.vx);
        narrow(job.uy, 2, job.perS, chunk.uy);
        narrow(job.vy, 3, job.perT, chunk.vy);
    }
    chunk.fill(job, begin, k);
}

// Looks up values per level, with a level per lane. Up to 16 levels use permutations, because a gather is many
// operations.
class PerLane {
  public:
    HWY_INLINE PerLane(VI level, std::int32_t top) : level_(level), few_(top < kFew) {}
    HWY_INLINE VI operator()(const LaneLevels::PerLevel<std::int32_t>& column) const { return of(DI(), column.data()); }
    HWY_INLINE V operator()(const LaneLevels::PerLevel<float>& column) const { return of(D(), column.data()); }

  private:
#if HWY_TARGET <= HWY_AVX2
    static constexpr std::int32_t kFew = 16;
    template <class DT, class T>
    HWY_INLINE hn::Vec<DT> of(DT d, const T* column) const {
        if (HWY_UNLIKELY(!few_)) return hn::GatherIndex(d, column, level_);
        if constexpr (kLanes == 16) {
            return hn::TableLookupLanes(hn::LoadU(d, column), hn::IndicesFromVec(d, level_));
        } else {
            const auto indices = hn::IndicesFromVec(d, hn::And(level_, setI(7)));
            const auto low = hn::TableLookupLanes(hn::LoadU(d, column), indices);
            const auto high = hn::TableLookupLanes(hn::LoadU(d, column + 8), indices);
            return hn::IfThenElse(hn::RebindMask(d, hn::Gt(level_, setI(7))), high, low);
        }
    }
#else
    static constexpr std::int32_t kFew = 0;
    template <class DT, class T>
    HWY_INLINE hn::Vec<DT> of(DT d, const T* column) const {
        return hn::GatherIndex(d, column, level_);
    }
#endif

    VI level_;
    [[maybe_unused]] bool few_;
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
