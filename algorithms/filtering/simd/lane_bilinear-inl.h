// Bilinear samples in SIMD, one per lane; used for points and for pixels smaller than a texel.

#if defined(RELIEF_LANE_BILINEAR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_LANE_BILINEAR_INL_H
#undef RELIEF_LANE_BILINEAR_INL_H
#else
#define RELIEF_LANE_BILINEAR_INL_H
#endif

#include "filtering/simd/lane_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Sums of colours, in units of 1/65535.
struct PointSums {
    V red, green, blue;

    HWY_INLINE void add(VU redGreen, VU blueOnly, V w) {
        const DI d;
        const VU low = hn::And(redGreen, hn::Set(DU(), 0xFFFFU));
        red = hn::Add(red, hn::Mul(w, toFloat(hn::BitCast(d, low))));
        green = hn::Add(green, hn::Mul(w, toFloat(hn::BitCast(d, hn::ShiftRight<16>(redGreen)))));
        blue = hn::Add(blue, hn::Mul(w, toFloat(hn::BitCast(d, blueOnly))));
    }
};

// Adds the weighted bilinear sample at (fromS, fromT) from the corner of f's texel (cellS, cellT) of the level given by
// width, height, origin and stride. All coordinates must be within the lanes' range around the picture, also in lanes
// of weight 0.
template <class Place>
HWY_INLINE void addBilinear(const LaneLevels& levels, const Place& f, V fromS, V fromT, V weight, PointSums& sums) {
    const DI di;
    const V s = hn::Sub(fromS, set(0.5F)), t = hn::Sub(fromT, set(0.5F));
    const V floorS = hn::Floor(s), floorT = hn::Floor(t);
    const V shareS = hn::Sub(s, floorS), shareT = hn::Sub(t, floorT);
    VI column = hn::Add(f.cellS, toInt(floorS)), row = hn::Add(f.cellT, toInt(floorT));
    VI next = hn::Add(row, setI(1));
    if (levels.address == Address::Repeat) {
        const auto out = [&](VI i, VI size) HWY_ATTR { return hn::Or(hn::Lt(i, setI(0)), hn::Not(hn::Lt(i, size))); };
        if (!hn::AllFalse(di, out(column, f.width))) column = wrapped(column, f.width);
        if (!hn::AllFalse(di, hn::Or(out(row, f.height), out(next, f.height)))) {
            row = wrapped(row, f.height);
            next = wrapped(next, f.height);
        }
    } else {
        column = hn::Max(hn::Min(column, f.width), setI(-1));
        const VI last = hn::Sub(f.height, setI(1));
        row = hn::Max(hn::Min(row, last), setI(0));
        next = hn::Max(hn::Min(next, last), setI(0));
    }
    const V right = hn::Mul(weight, shareS), onLeft = hn::Sub(weight, right);
    const V lowerRight = hn::Mul(right, shareT), lowerLeft = hn::Mul(onLeft, shareT);
    alignas(64) std::int32_t at[kLanes];
    const auto add = [&](VI in, V w0, V w1) HWY_ATTR {
        hn::Store(hn::Add(hn::Add(f.origin, hn::Mul(in, f.stride)), column), di, at);
        const Pair pair = loadPair(levels.texels.data(), at);
        sums.add(pair.redGreen0, pair.blue0, w0);
        sums.add(pair.redGreen1, pair.blue1, w1);
    };
    add(row, hn::Sub(onLeft, lowerLeft), hn::Sub(right, lowerRight));
    add(next, lowerLeft, lowerRight);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
