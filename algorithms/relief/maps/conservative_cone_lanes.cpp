#include "relief/maps/conservative_cone_lanes.h"

#include <algorithm>
#include <cmath>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/maps/conservative_cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Rounding of sums of numbers below 2, and of products, roots and quotients: a few units in the last place of a float.
constexpr float kRounding = 1e-6F;

std::size_t above(const ConeNodes& nodes, float x, float y, float apex, float slope, std::uint32_t* which) {
    const hn::ScalableTag<float> d;
    using V = hn::Vec<decltype(d)>;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t count = nodes.size();
    const V px = hn::Set(d, x), py = hn::Set(d, y), a = hn::Set(d, apex), k = hn::Set(d, slope);
    const V flatter = hn::Set(d, slope * (1 - kRounding)), one = hn::Set(d, 1.0F), zero = hn::Zero(d);
    const V squared = hn::Mul(flatter, flatter), least = hn::Set(d, -kRounding);
    std::size_t found = 0;
    for (std::size_t n = 0; n < count; n += lanes) {
        const auto load = [&](const std::vector<float>& from) { return hn::LoadU(d, from.data() + n); };
        const V offsetX = hn::Sub(load(nodes.middleX), px), offsetY = hn::Sub(load(nodes.middleY), py);
        const V outX = hn::Sub(hn::Abs(offsetX), one), outY = hn::Sub(hn::Abs(offsetY), one);
        const V halfX = load(nodes.halfX), halfY = load(nodes.halfY);
        // Bound by the maximum at the smallest gap.
        const V rise = hn::Sub(load(nodes.highest), a);
        const V leastX = hn::Max(hn::Sub(outX, halfX), zero), leastY = hn::Max(hn::Sub(outY, halfY), zero);
        const V gap2 = hn::Add(hn::Mul(leastX, leastX), hn::Mul(leastY, leastY));
        const auto high = hn::And(hn::Gt(rise, zero), hn::Gt(hn::Mul(rise, rise), hn::Mul(squared, gap2)));
        if (hn::AllFalse(d, high)) continue;
        // Bound by the plane, and by the tangent of the gap at the middle, which is a lower bound since the gap is
        // convex.
        const V gapX = hn::Max(outX, zero), gapY = hn::Max(outY, zero);
        const V gap = hn::Sqrt(hn::Add(hn::Mul(gapX, gapX), hn::Mul(gapY, gapY)));
        const V share = hn::Div(k, hn::Max(gap, hn::Set(d, 1e-6F)));  // gap 0: gapX = gapY = 0
        const V fallX = hn::CopySign(hn::Mul(share, gapX), offsetX),
                fallY = hn::CopySign(hn::Mul(share, gapY), offsetY);
        const V corner = hn::Add(hn::Mul(halfX, hn::Abs(hn::Sub(load(nodes.gradientX), fallX))),
                                 hn::Mul(halfY, hn::Abs(hn::Sub(load(nodes.gradientY), fallY))));
        const V room = hn::Add(hn::Sub(hn::Sub(load(nodes.value), a), hn::Mul(flatter, gap)),
                               hn::Mul(corner, hn::Set(d, 1 + kRounding)));
        const auto matters = hn::And(high, hn::Gt(room, least));
        if (hn::AllFalse(d, matters)) continue;
        std::uint8_t bits[64] = {};
        hn::StoreMaskBits(d, matters, bits);
        for (std::size_t lane = 0; lane < lanes && n + lane < count; ++lane) {
            which[found] = static_cast<std::uint32_t>(n + lane);
            found += bits[lane / 8] >> (lane % 8) & 1U;
        }
    }
    return found;
}

using DNear = hn::CappedTag<float, kNearPad / 2>;

void apexes(const float* cells, std::ptrdiff_t stride, int n, float* out) {
    const DNear d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const auto across = [&](const float* from) {
        return hn::Max(hn::Max(hn::LoadU(d, from - 1), hn::LoadU(d, from)), hn::LoadU(d, from + 1));
    };
    for (int i = 0; i < n; i += lanes) {
        const float* from = cells + i;
        hn::StoreU(hn::Max(hn::Max(across(from - stride), across(from)), across(from + stride)), d, out + i);
    }
}

// Processes two vectors at once, so that their dependency chains of maxima overlap.
void steepen(const NearRings& rings, const float* cells, const float* apex, int n, float* slopes) {
    const DNear d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const std::ptrdiff_t* offsets = rings.offsets.data();
    for (int i = 0; i < n; i += 2 * lanes) {
        const float* first = cells + i;
        const float* second = first + lanes;
        const auto apexI = hn::LoadU(d, apex + i), apexK = hn::LoadU(d, apex + i + lanes);
        auto slopeI = hn::Zero(d), slopeK = slopeI;
        std::size_t at = 0;
        for (std::size_t k = 0; k < rings.ends.size(); ++k) {
            auto highI = hn::LoadU(d, first + offsets[at]), highK = hn::LoadU(d, second + offsets[at]);
            while (++at < rings.ends[k]) {
                highI = hn::Max(highI, hn::LoadU(d, first + offsets[at]));
                highK = hn::Max(highK, hn::LoadU(d, second + offsets[at]));
            }
            const auto inverse = hn::Set(d, rings.inverseGaps[k]);
            slopeI = hn::Max(slopeI, hn::Mul(hn::Sub(highI, apexI), inverse));
            slopeK = hn::Max(slopeK, hn::Mul(hn::Sub(highK, apexK), inverse));
        }
        hn::StoreU(slopeI, d, slopes + i);
        hn::StoreU(slopeK, d, slopes + i + lanes);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(above);
HWY_EXPORT(apexes);
HWY_EXPORT(steepen);

void ConeNodes::clear() {
    for (auto* column : {&middleX, &middleY, &halfX, &halfY, &highest, &value, &gradientX, &gradientY}) column->clear();
    places.clear();
}

void ConeNodes::add(float x, float y, float halfAcross, float halfDown, float top, float plane, float slopeX,
                    float slopeY, const Place& place) {
    middleX.push_back(x), middleY.push_back(y);
    halfX.push_back(halfAcross), halfY.push_back(halfDown);
    highest.push_back(top), value.push_back(plane);
    gradientX.push_back(slopeX), gradientY.push_back(slopeY);
    places.push_back(place);
}

void ConeNodes::finish() {
    constexpr std::size_t kMostLanes = 64;
    for (auto* column : {&middleX, &middleY, &halfX, &halfY, &highest, &value, &gradientX, &gradientY}) {
        column->resize(size() + kMostLanes);
    }
}

std::size_t nodesAbove(const ConeNodes& nodes, float x, float y, float apex, float slope, std::uint32_t* which) {
    return HWY_DYNAMIC_DISPATCH(above)(nodes, x, y, apex, slope, which);
}

void apexesAbove(const float* cells, std::ptrdiff_t stride, int n, float* out) {
    HWY_DYNAMIC_DISPATCH(apexes)(cells, stride, n, out);
}

void steepenByRings(const NearRings& rings, const float* cells, const float* apexes, int n, float* slopes) {
    HWY_DYNAMIC_DISPATCH(steepen)(rings, cells, apexes, n, slopes);
}

}  // namespace relief
#endif
