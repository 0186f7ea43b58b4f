// Putting the rays of a chunk in order of their quadrants. Compiled for each target.

#if defined(RELIEF_RAY_QUADRANTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_RAY_QUADRANTS_INL_H
#undef RELIEF_RAY_QUADRANTS_INL_H
#else
#define RELIEF_RAY_QUADRANTS_INL_H
#endif

#include "relief/lanes/lane_trace-inl.h"
#include "relief/lanes/ray_quadrants.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
// Packing of doubles. Not Compress: see Packing.
struct WidePacking {
    explicit WidePacking(MD chosen) {
        const hn::RebindToSigned<DD> d64;
        const hn::Rebind<std::uint8_t, DD> bytes;
        std::uint8_t bits[8];
        hn::StoreMaskBits(DD(), chosen, bits);
        const auto narrow = hn::LoadU(bytes, kPackedLanes[bits[0]].data());
        indices_ = hn::IndicesFromVec(DD(), hn::PromoteTo(d64, hn::PromoteTo(DHI(), narrow)));
    }
    HWY_INLINE VD operator()(VD v) const { return hn::TableLookupLanes(v, indices_); }

  private:
    decltype(hn::IndicesFromVec(DD(), hn::Zero(hn::RebindToSigned<DD>()))) indices_;
};
#endif

// The quadrant of all rays; kQuadrants: they have not one in common.
inline std::size_t commonQuadrant(const double* a, const double* b, std::size_t count) {
    const DD d;
    const auto sign = [&](const double* runs) {
        MD every = hn::FirstN(d, kHalfLanes), any = hn::MaskFromVec(hn::Zero(d));
        std::size_t i = 0;
        for (; i + kHalfLanes <= count; i += kHalfLanes) {
            const MD back = hn::Lt(hn::LoadU(d, runs + i), hn::Zero(d));
            every = hn::And(every, back), any = hn::Or(any, back);
        }
        bool all = count >= kHalfLanes ? hn::AllTrue(d, every) : runs[0] < 0;
        bool some = !hn::AllFalse(d, any);
        for (; i < count; ++i) all = all && runs[i] < 0, some = some || runs[i] < 0;
        return all ? 1 : (some ? 2 : 0);
    };
    const int x = sign(a), y = sign(b);
    return x == 2 || y == 2 ? kQuadrants : static_cast<std::size_t>(x + 2 * y);
}

// given: s0, t0, a, b of `count` rays.
inline void orderByQuadrant(const double* const* given, std::size_t count, QuadrantOrder& out) {
    const double* const a = given[2];
    const double* const b = given[3];
    const auto quadrantOf = [&](std::size_t i) {
        return static_cast<std::size_t>(a[i] < 0 ? 1 : 0) + static_cast<std::size_t>(b[i] < 0 ? 2 : 0);
    };
    std::array<std::size_t, kQuadrants> counts{};
    for (std::size_t i = 0; i < count; ++i) ++counts[quadrantOf(i)];
    std::size_t begin = 0;
    for (std::size_t q = 0; q < kQuadrants; ++q) {
        out.parts.begin[q] = out.parts.end[q] = begin;
        begin = hwy::RoundUpTo(begin + counts[q] + kQuadrantGap, 16);
    }
    std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
    const DD d;
    for (; i + kHalfLanes <= count; i += kHalfLanes) {
        const MD backX = hn::Lt(hn::LoadU(d, a + i), hn::Zero(d)), backY = hn::Lt(hn::LoadU(d, b + i), hn::Zero(d));
        const MD quadrants[] = {hn::Not(hn::Or(backX, backY)), hn::AndNot(backY, backX), hn::AndNot(backX, backY),
                                hn::And(backX, backY)};
        const VD numbers = hn::Add(hn::Iota(d, 0), hn::Set(d, static_cast<double>(i)));
        for (std::size_t q = 0; q < kQuadrants; ++q) {
            const std::size_t to = out.parts.end[q];
            const WidePacking packing(quadrants[q]);
            for (std::size_t c = 0; c < 4; ++c) {
                hn::StoreU(packing(hn::LoadU(d, given[c] + i)), d, out.columns[c].data() + to);
            }
            hn::StoreU(hn::DemoteTo(DHI(), packing(numbers)), DHI(), out.from.data() + to);
            out.parts.end[q] = to + hn::CountTrue(d, quadrants[q]);
        }
    }
#endif
    for (; i < count; ++i) {
        const std::size_t to = out.parts.end[quadrantOf(i)]++;
        for (std::size_t c = 0; c < 4; ++c) out.columns[c][to] = given[c][i];
        out.from[to] = static_cast<std::int32_t>(i);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
