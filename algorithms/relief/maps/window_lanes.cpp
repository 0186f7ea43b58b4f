#include "relief/maps/window_lanes.h"

#include <algorithm>
#include <cmath>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/maps/window_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void least(const float* const* rows, const float* steps, int reach, const float* floor, int n, float* out) {
    // Processes two vectors at once, so that their dependency chains of minima overlap.
    const hn::CappedTag<float, kWindowPad / 2> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    for (int i = 0; i < n; i += 2 * lanes) {
        const int k = i + lanes;
        auto bestI = hn::LoadU(d, rows[0] + i), bestK = hn::LoadU(d, rows[0] + k);
        const auto floorI = hn::LoadU(d, floor + i), floorK = hn::LoadU(d, floor + k);
        for (int o = 1; o <= reach; ++o) {
            const auto step = hn::Set(d, steps[o]);
            // Rounding is monotone: no sum farther away is smaller than this one.
            const auto open = hn::Or(hn::Lt(hn::Add(floorI, step), bestI), hn::Lt(hn::Add(floorK, step), bestK));
            if (hn::AllFalse(d, open)) break;
            const float* before = rows[-o];
            const float* after = rows[o];
            bestI = hn::Min(bestI, hn::Add(hn::Min(hn::LoadU(d, before + i), hn::LoadU(d, after + i)), step));
            bestK = hn::Min(bestK, hn::Add(hn::Min(hn::LoadU(d, before + k), hn::LoadU(d, after + k)), step));
        }
        hn::StoreU(bestI, d, out + i);
        hn::StoreU(bestK, d, out + k);
    }
}

void extremes(const float* values, int n, float* both) {
    const hn::ScalableTag<float> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    auto least = hn::Set(d, values[0]), most = least;
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        const auto here = hn::LoadU(d, values + i);
        least = hn::Min(least, here);
        most = hn::Max(most, here);
    }
    both[0] = hn::GetLane(hn::MinOfLanes(d, least));
    both[1] = hn::GetLane(hn::MaxOfLanes(d, most));
    for (; i < n; ++i) {
        both[0] = std::min(both[0], values[i]);
        both[1] = std::max(both[1], values[i]);
    }
}

void roots(const float* squares, int n, float scale, float* out) {
    const hn::ScalableTag<float> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const auto by = hn::Set(d, scale);
    int i = 0;
    for (; i + lanes <= n; i += lanes) hn::StoreU(hn::Mul(hn::Sqrt(hn::LoadU(d, squares + i)), by), d, out + i);
    for (; i < n; ++i) out[i] = std::sqrt(squares[i]) * scale;
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(least);
HWY_EXPORT(extremes);
HWY_EXPORT(roots);

void leastOverWindows(const float* const* rows, const float* steps, int reach, const float* floor, int n, float* out) {
    HWY_DYNAMIC_DISPATCH(least)(rows, steps, reach, floor, n, out);
}
std::pair<float, float> extremesOf(const float* values, int n) {
    float both[2] = {};
    HWY_DYNAMIC_DISPATCH(extremes)(values, n, both);
    return {both[0], both[1]};
}
void rootsOf(const float* squares, int n, float scale, float* out) {
    HWY_DYNAMIC_DISPATCH(roots)(squares, n, scale, out);
}

}  // namespace relief
#endif
