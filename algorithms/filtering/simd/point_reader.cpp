#include "filtering/point_reader.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <hwy/cache_control.h>

#include "filtering/lane_job.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/simd/point_reader.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "filtering/simd/lane_bilinear-inl.h"

#ifndef RELIEF_POINT_READER_ONCE
#define RELIEF_POINT_READER_ONCE
namespace relief {

// Largest ratio of a footprint's axes: longer footprints are widened.
inline constexpr float kPointAnisotropy = 8;
// Smallest variance of the minor axis in texels^2 of the level chosen: two fifths of the blur of a bilinear tap itself.
inline constexpr float kLeastOfLevel = 0.1F;
// Variance of a bilinear tap between means of texels: 1/6 + 1/12.
inline constexpr float kTapVariance = 0.25F;
// Largest distance between taps in texels of the level, unless that needs more than kMostTaps.
inline constexpr float kTapSpacing = 2.0F;

}  // namespace relief
#endif

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// SIMD version of PointReader::taps, in texels of the level.
struct TapLanes {
    VI level, width, height, origin, stride;
    VI cellS, cellT;
    V restS, restT;  // from the cell's corner
    V stepS, stepT;
    V count;
};

HWY_INLINE TapLanes tapsOf(const LaneJob& job, const LaneChunk& chunk, std::size_t first,
                           std::uint8_t* HWY_RESTRICT fallback) {
    const D d;
    const DI di;
    TapLanes f;
    const V ux = hn::Load(d, chunk.ux + first), vx = hn::Load(d, chunk.vx + first);
    const V uy = hn::Load(d, chunk.uy + first), vy = hn::Load(d, chunk.vy + first);
    const V uu = hn::Add(hn::Mul(ux, ux), hn::Mul(uy, uy)), vv = hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy));
    const V uv = hn::Add(hn::Mul(ux, vx), hn::Mul(uy, vy)), det = hn::Sub(hn::Mul(ux, vy), hn::Mul(uy, vx));
    const V apart = hn::Sub(uu, vv), twice = hn::Add(uv, uv);
    const V root = hn::Sqrt(hn::Add(hn::Mul(apart, apart), hn::Mul(twice, twice)));
    const V largest = hn::Mul(set(0.5F), hn::Add(hn::Add(uu, vv), root));
    const V least = hn::Div(hn::Mul(det, det), hn::Max(largest, set(kLeastSquare)));
    // Written so that NaN is not supported.
    const auto usual = hn::Le(largest, set(job.mostSquare));
    const V minor = hn::Max(least, hn::Mul(largest, set(1 / (kPointAnisotropy * kPointAnisotropy))));
    const V over = hn::Mul(minor, set(1 / kLeastOfLevel));
    const VI exponent = hn::Sub(hn::ShiftRight<23>(hn::BitCast(di, over)), setI(127));
    f.level = hn::Min(hn::Max(hn::ShiftRight<1>(exponent), setI(0)), setI(job.top));
    f.level = hn::IfThenElseZero(hn::RebindMask(di, usual), f.level);
    const LaneLevels& levels = *job.levels;
    const PerLane perLevel(f.level, job.top);
    f.width = perLevel(levels.width);
    f.height = perLevel(levels.height);
    f.origin = perLevel(levels.origin);
    f.stride = perLevel(levels.stride);
    const V scale = perLevel(job.scale), zero = hn::Zero(d), one = set(1);
    const V more = hn::Max(hn::Sub(hn::Mul(largest, hn::Mul(scale, scale)), set(kTapVariance)), zero);
    const V length = hn::Sqrt(hn::Mul(set(12), more));
    f.count = hn::Min(hn::Add(one, hn::Ceil(hn::Mul(length, set(1 / kTapSpacing)))), set(kMostTaps));
    f.count = hn::IfThenElse(usual, f.count, one);
    const V between = hn::Sqrt(hn::Max(hn::Sub(hn::Mul(f.count, f.count), one), one));
    // The direction of the major axis, from the row that does not cancel.
    const auto wide = hn::Ge(uu, vv);
    const V alongS = hn::IfThenElse(wide, hn::Sub(largest, vv), uv),
            alongT = hn::IfThenElse(wide, uv, hn::Sub(largest, uu));
    const V norm = hn::Sqrt(hn::Add(hn::Mul(alongS, alongS), hn::Mul(alongT, alongT)));
    const auto several = hn::And(hn::Gt(f.count, one), hn::Gt(norm, zero));
    // Zero also for footprints that are not finite: NaN would become the index of a texel outside the picture.
    const V step = hn::Div(length, hn::Mul(between, norm));
    f.stepS = hn::IfThenElseZero(several, hn::Mul(step, alongS));
    f.stepT = hn::IfThenElseZero(several, hn::Mul(step, alongT));

    const VI mask = hn::Sub(hn::Shl(setI(1), f.level), setI(1));
    const auto split = [&](const std::int32_t* whole, const float* rest, VI& cell, V& within) HWY_ATTR {
        const VI texel = hn::Load(di, whole + first);
        cell = hn::Shr(texel, f.level);
        within = hn::Mul(hn::Add(toFloat(hn::And(texel, mask)), hn::Load(d, rest + first)), scale);
    };
    split(chunk.wholeS, chunk.restS, f.cellS, f.restS);
    split(chunk.wholeT, chunk.restT, f.cellT, f.restT);
    // On levels with narrow last texels, only footprints that do not touch these are supported.
    const V reach = hn::Add(hn::Mul(hn::Mul(set(0.5F), f.count), hn::Add(hn::Abs(f.stepS), hn::Abs(f.stepT))), one);
    const auto inside = [&](V at, VI size) HWY_ATTR {
        return hn::And(hn::Ge(at, reach), hn::Le(hn::Add(at, reach), hn::Sub(toFloat(size), one)));
    };
    const auto clear = hn::And(inside(hn::Add(toFloat(f.cellS), f.restS), f.width),
                               inside(hn::Add(toFloat(f.cellT), f.restT), f.height));
    const auto whole = hn::RebindMask(d, hn::Gt(perLevel(levels.whole), setI(0)));
    const auto served = hn::And(hn::And(usual, hn::Gt(hn::Load(d, chunk.valid + first), zero)), hn::Or(whole, clear));
    f.count = hn::IfThenElseZero(served, f.count);
    alignas(64) std::int32_t flags[kLanes];
    hn::Store(hn::IfThenElse(hn::RebindMask(di, served), setI(0), setI(1)), di, flags);
    for (std::size_t k = 0; k < kLanes; ++k) fallback[k] = static_cast<std::uint8_t>(flags[k]);
    return f;
}

HWY_INLINE void addTap(const LaneJob& job, const TapLanes& f, V offset, V weight, PointSums& sums) {
    const V s = hn::Add(f.restS, hn::Mul(offset, f.stepS)), t = hn::Add(f.restT, hn::Mul(offset, f.stepT));
    addBilinear(*job.levels, f, s, t, weight, sums);
}

// Prefetches the texels under the middle of each footprint, which are scattered in memory, while the taps of other
// vectors are computed. For places outside the picture some other texel is prefetched, which is harmless.
HWY_INLINE void prefetchTexels(const LaneJob& job, const TapLanes& f) {
    const DI di;
    const V half = set(0.5F);
    const VI last = hn::Sub(f.height, setI(1));
    const VI column = hn::Add(f.cellS, toInt(hn::Floor(hn::Sub(f.restS, half))));
    const VI row = hn::Add(f.cellT, toInt(hn::Floor(hn::Sub(f.restT, half))));
    const VI upper = hn::Max(hn::Min(row, last), setI(0)), lower = hn::Min(hn::Add(upper, setI(1)), last);
    const VI inside = hn::Max(hn::Min(column, f.width), setI(0));
    alignas(64) std::int32_t at[2 * kLanes];
    hn::Store(hn::Add(hn::Add(f.origin, hn::Mul(upper, f.stride)), inside), di, at);
    hn::Store(hn::Add(hn::Add(f.origin, hn::Mul(lower, f.stride)), inside), di, at + kLanes);
    for (const std::int32_t texel : at) hwy::Prefetch(job.levels->texels.data() + texel);
}

void readVector(const LaneJob& job, const LaneChunk& chunk, std::size_t first, const TapLanes& f,
                const std::uint8_t* fallback, const std::uint32_t* HWY_RESTRICT slots, PointColor* HWY_RESTRICT colors,
                FootprintCounts& counts) {
    const D d;
    const V zero = hn::Zero(d), one = set(1);
    PointSums sums{zero, zero, zero};
    const float most = hn::GetLane(hn::MaxOfLanes(d, f.count));
    const V middle = hn::Mul(set(0.5F), hn::Sub(f.count, one));
    for (float n = 0; n < most; n += 1) {
        const auto active = hn::Lt(set(n), f.count);
        const V offset = hn::IfThenElseZero(active, hn::Sub(set(n), middle));
        addTap(job, f, offset, hn::IfThenElseZero(active, one), sums);
    }
    const V per = hn::Mul(hn::Max(f.count, one), set(kLaneWhite));
    alignas(64) float red[kLanes], green[kLanes], blue[kLanes];
    hn::Store(hn::Div(sums.red, per), d, red);
    hn::Store(hn::Div(sums.green, per), d, green);
    hn::Store(hn::Div(sums.blue, per), d, blue);
    // Points that fall back to the reference have no taps here.
    counts.texels += 4 * static_cast<std::int64_t>(hn::GetLane(hn::SumOfLanes(d, f.count)));
    for (std::size_t k = 0; k < kLanes && first + k < chunk.count; ++k) {
        if (fallback[k] == 0) colors[slots[k]] = {{red[k], green[k], blue[k], 1}};
    }
}

void readPoints(const LaneJob& job, const std::uint32_t* slots, PointColor* colors, FootprintCounts& counts) {
    LaneChunk chunk;
    TapLanes taps[kLanePixels / kLanes];
    std::uint8_t fallback[kLanePixels];
    for (std::size_t begin = 0; begin < job.count; begin += kLanePixels) {
        fillChunk(job, begin, chunk);
        for (std::size_t k = 0; k < chunk.count; k += kLanes) {
            taps[k / kLanes] = tapsOf(job, chunk, k, fallback + k);
            prefetchTexels(job, taps[k / kLanes]);
        }
        for (std::size_t k = 0; k < chunk.count; k += kLanes) {
            readVector(job, chunk, k, taps[k / kLanes], fallback + k, slots + begin + k, colors, counts);
        }
        std::copy_n(fallback, chunk.count, job.fallback + begin);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(readPoints);

PointTaps PointReader::taps(const Jacobian& j) const {
    const SemiAxes<double> axes = ellipseOf(j).semiAxes();
    PointTaps taps;
    // Written so that NaN returns a single tap.
    if (!(axes.major <= 4.0 * std::max(levels_->width(), levels_->height()))) return taps;
    const double minor = std::max(axes.minor, axes.major / kPointAnisotropy);
    const double over = minor * minor / kLeastOfLevel;
    while (taps.level < levels_->top() && over >= std::ldexp(1.0, 2 * (taps.level + 1))) ++taps.level;
    const double size = std::ldexp(1.0, taps.level);
    const double more = std::max(0.0, axes.major * axes.major / (size * size) - kTapVariance);
    const double length = std::sqrt(12 * more);
    taps.count = static_cast<int>(std::min<double>(1 + std::ceil(length / kTapSpacing), kMostTaps));
    if (taps.count == 1) return taps;
    const double step = size * length / std::sqrt(taps.count * taps.count - 1.0);
    taps.step = step * glm::dvec2(axes.majorU, axes.majorV);
    return taps;
}

Color PointReader::color(glm::dvec2 place, const PointTaps& taps) const {
    Color sum(0);
    for (int n = 0; n < taps.count; ++n) sum += levels_->bilinear(taps.level, place + taps.offset(n), address_);
    return sum / static_cast<float>(taps.count);
}

void PointReader::read(const PointBlock& points, std::span<const std::uint32_t> slots, PointColor* colors,
                       FootprintCounts& counts) const {
    assert(slots.size() == points.size());
    static thread_local std::vector<std::uint8_t> fallback;
    fallback.assign(points.size(), 1);
    if (lanes_) {
        LaneJob job = laneJob(*lanes_, {});
        job.s = points.s.data(), job.t = points.t.data();
        job.narrow = {points.ux.data(), points.vx.data(), points.uy.data(), points.vy.data()};
        job.count = points.size();
        job.fallback = fallback.data();
        HWY_DYNAMIC_DISPATCH(readPoints)(job, slots.data(), colors, counts);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (fallback[i] == 0) continue;
        const PointTaps taps = this->taps(points.jacobian(i));
        const Color found = color({points.s[i], points.t[i]}, taps);
        colors[slots[i]] = {{found.r, found.g, found.b, 1}};
        counts.texels += std::int64_t{4} * taps.count;
    }
}

}  // namespace relief
#endif
