#include "relief/maps/packed_cone_lanes.h"

#include <algorithm>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/maps/packed_cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, kConePad>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;

// Processes strips from left to right, each from top to bottom, so that windows are read before they are overwritten.
void grow(float* windows, std::size_t stride, int width, int height, int shift) {
    const D d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const std::size_t below = static_cast<std::size_t>(shift) * stride;
    for (int x = 0; x < width; x += lanes) {
        float* at = windows + x;
        for (int y = 0; y < height; ++y, at += stride) {
            const V upper = hn::Max(hn::LoadU(d, at), hn::LoadU(d, at + shift));
            const V lower = hn::Max(hn::LoadU(d, at + below), hn::LoadU(d, at + below + shift));
            hn::StoreU(hn::Max(upper, lower), d, at);
        }
    }
}

void growSteepen(float* windows, std::size_t stride, int width, int height, float inverseGap, const ConeTile& tile) {
    const D d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const V inverse = hn::Set(d, inverseGap);
    for (int x = 0; x < width; x += lanes) {
        float* at = windows + x;
        const int cones = x < tile.width ? tile.height : 0;
        const float* apex = tile.apex + x;
        float* slope = tile.slope + x;
        V upper = hn::Max(hn::LoadU(d, at), hn::LoadU(d, at + 1));
        for (int y = 0; y < height; ++y) {
            const V lower = hn::Max(hn::LoadU(d, at + stride), hn::LoadU(d, at + stride + 1));
            const V highest = hn::Max(upper, lower);
            hn::StoreU(highest, d, at);
            upper = lower;
            at += stride;
            if (y >= cones) continue;
            const V needs = hn::Mul(hn::Sub(highest, hn::LoadU(d, apex)), inverse);
            hn::StoreU(hn::Max(hn::LoadU(d, slope), needs), d, slope);
            apex += tile.stride;
            slope += tile.stride;
        }
    }
}

float steepen(const ConeRings& rings, float highest, float farther, const ConeTile& tile) {
    const D d;
    const DU du;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    // Lane n of a vector that begins at the border of a block is in block n / 2^level.
    const auto block = hn::IndicesFromVec(d, hn::ShiftRightSame(hn::Iota(du, 0), std::min(rings.level, 31)));
    const V top = hn::Set(d, highest), far = hn::Set(d, farther);
    V left = hn::Set(d, -1.0F);
    for (int y = 0; y < tile.height; ++y) {
        const std::size_t row = static_cast<std::size_t>((rings.y0 + y) >> rings.level) * rings.stride;
        for (int x = 0; x < tile.width; x += lanes) {
            const std::size_t at = row + static_cast<std::size_t>((rings.x0 + x) >> rings.level);
            const std::size_t cone = static_cast<std::size_t>(y) * tile.stride + static_cast<std::size_t>(x);
            const V apex = hn::LoadU(d, tile.apex + cone);
            V slope = hn::LoadU(d, tile.slope + cone);
            for (std::size_t k = 0; k < kConeRings; ++k) {
                const V height = hn::TableLookupLanes(hn::LoadU(d, rings.planes[k] + at), block);
                slope = hn::Max(slope, hn::Mul(hn::Sub(height, apex), hn::Set(d, rings.inverseGaps[k])));
            }
            hn::StoreU(slope, d, tile.slope + cone);
            left = hn::Max(left, hn::Sub(hn::Sub(top, apex), hn::Mul(slope, far)));
        }
    }
    return hn::GetLane(hn::MaxOfLanes(d, left));
}

void apexes(const std::uint32_t* depths, std::size_t stride, float highest, float unit, const ConeTile& tile) {
    const D d;
    const DU du;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    // Subtracted from the apexes: more than all rounding on the way to the slopes, for heights of at most 1. There are
    // four roundings here and three of the rise (a difference, 1 / gap, a product), of 2^-24 each.
    constexpr float kApexLower = 0x1p-21F;
    const V top = hn::Set(d, highest - kApexLower), step = hn::Set(d, unit);
    for (int y = 0; y < tile.height; ++y) {
        const std::uint32_t* from = depths + static_cast<std::size_t>(y) * stride;
        for (int x = 0; x < tile.width; x += lanes, from += lanes) {
            const auto own = hn::LoadU(du, from);
            const auto least = hn::Min(hn::Min(own, hn::LoadU(du, from + 1)),
                                       hn::Min(hn::LoadU(du, from + stride), hn::LoadU(du, from + stride + 1)));
            const std::size_t cone = static_cast<std::size_t>(y) * tile.stride + static_cast<std::size_t>(x);
            const V depth = hn::ConvertTo(d, hn::BitCast(hn::RebindToSigned<D>(), least));
            hn::StoreU(hn::Sub(top, hn::Mul(depth, step)), d, tile.apex + cone);
            hn::StoreU(hn::Zero(d), d, tile.slope + cone);
            hn::StoreU(hn::Or(own, hn::ShiftLeft<10>(least)), du, tile.depths + cone);
        }
    }
}

void pack(const ConeTile& tile, int row, std::uint32_t* entries) {
    const D d;
    const DU du;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const auto step = hn::Set(du, 1U << 20);
    const auto least = hn::Set(du, 1U << 23);  // the smallest normal float
    for (int x = 0; x < tile.width; x += lanes) {
        const std::size_t cone = static_cast<std::size_t>(row) * tile.stride + static_cast<std::size_t>(x);
        const auto slope = hn::Max(hn::BitCast(du, hn::LoadU(d, tile.slope + cone)), least);
        const auto entry = hn::Or(hn::ShiftLeft<20>(hn::ShiftRight<20>(slope)), hn::LoadU(du, tile.depths + cone));
        hn::StoreU(hn::IfThenElse(hn::Lt(entry, slope), hn::Add(entry, step), entry), du, entries + x);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(grow);
HWY_EXPORT(growSteepen);
HWY_EXPORT(steepen);
HWY_EXPORT(apexes);
HWY_EXPORT(pack);

void growWindows(float* windows, std::size_t stride, int width, int height, int shift) {
    HWY_DYNAMIC_DISPATCH(grow)(windows, stride, width, height, shift);
}
void growAndSteepen(float* windows, std::size_t stride, int width, int height, float inverseGap, const ConeTile& tile) {
    HWY_DYNAMIC_DISPATCH(growSteepen)(windows, stride, width, height, inverseGap, tile);
}
float steepenByBlocks(const ConeRings& rings, float highest, float farther, const ConeTile& tile) {
    return HWY_DYNAMIC_DISPATCH(steepen)(rings, highest, farther, tile);
}
void placeApexes(const std::uint32_t* depths, std::size_t stride, float highest, float unit, const ConeTile& tile) {
    HWY_DYNAMIC_DISPATCH(apexes)(depths, stride, highest, unit, tile);
}
void packCones(const ConeTile& tile, int row, std::uint32_t* entries) {
    HWY_DYNAMIC_DISPATCH(pack)(tile, row, entries);
}

}  // namespace relief
#endif
