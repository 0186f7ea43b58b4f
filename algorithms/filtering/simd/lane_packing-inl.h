// Moves selected lanes of vectors of doubles to the front.

#if defined(RELIEF_LANE_PACKING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_PACKING_INL_H
#undef RELIEF_LANE_PACKING_INL_H
#else
#define RELIEF_LANE_PACKING_INL_H
#endif

#include <hwy/highway.h>

#include "relief/simd/lane_rays.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace packing {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using DI = hn::RebindToSigned<D>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

// Selects those of the cells from `bits` on that have any of the bits `which`.
HWY_INLINE M withBits(const std::uint16_t* bits, std::uint16_t which) {
    const hn::Rebind<std::uint16_t, D> narrow;
    const hn::Rebind<std::uint32_t, D> wide;
    const hn::RebindToUnsigned<D> whole;
    const auto some = hn::And(hn::LoadU(narrow, bits), hn::Set(narrow, which));
    return hn::RebindMask(D(), hn::Ne(hn::PromoteTo(whole, hn::PromoteTo(wide, some)), hn::Zero(whole)));
}

// Moves the chosen lanes to the front. Not hn::Compress: g++ 12 copies its table to the stack on each call.
class Packing {
  public:
    explicit Packing(M chosen) {
        std::uint8_t bits[8];
        hn::StoreMaskBits(D(), chosen, bits);
        const hn::Rebind<std::uint8_t, D> bytes;
        const hn::Rebind<std::int32_t, D> wide;
        const auto lanes = hn::LoadU(bytes, kPackedLanes[bits[0]].data());
        indices_ = hn::PromoteTo(DI(), hn::PromoteTo(wide, lanes));
    }
    HWY_INLINE V operator()(V v) const { return hn::TableLookupLanes(v, hn::IndicesFromVec(D(), indices_)); }
    HWY_INLINE hn::Vec<DI> operator()(hn::Vec<DI> v) const {
        return hn::TableLookupLanes(v, hn::IndicesFromVec(DI(), indices_));
    }

  private:
    hn::Vec<DI> indices_;
};

}  // namespace packing
}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
