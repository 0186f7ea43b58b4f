#include "relief/maps/relaxed_cone_lanes.h"

#include <algorithm>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/maps/relaxed_cone_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The texels of a vector are neighbours in the row. Doubles, and the operations of the reference in its order.
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D d;
constexpr hn::Rebind<float, D> dFloat;

// Slopes below this are computed without any bound: a ray's rounding could decide them.
constexpr double kTiny = 1e-12;
// Greater than the rounding of a ray's height, and as a share of a slope than that of any bound below.
constexpr double kRounding = 1e-15;

V heightsAt(const float* from) {
    return hn::PromoteTo(d, hn::LoadU(dFloat, from));
}

// Heights of the columns `whole`, and of the columns after them. Neighbouring texels read neighbouring columns, except
// where rounding or clamping moves one of them.
struct Columns {
    explicit Columns(V whole) {
        const double begin = hn::GetLane(whole);
        first = static_cast<std::ptrdiff_t>(begin);
        together = hn::AllTrue(d, hn::Eq(hn::Sub(whole, hn::Iota(d, 0)), hn::Set(d, begin)));
        if (!together) hn::StoreU(whole, d, each);
    }
    V at(const float* row) const {
        if (together) [[likely]]
            return heightsAt(row + first);
        double heights[hn::MaxLanes(d)];
        for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
            heights[lane] = static_cast<double>(row[static_cast<std::ptrdiff_t>(each[lane])]);
        }
        return hn::LoadU(d, heights);
    }

    std::ptrdiff_t first;
    bool together;
    double each[hn::MaxLanes(d)];
};

// The profile of one azimuth for a vector of texels, and the slopes that it requires.
class Profile {
  public:
    Profile(const RelaxedRow& row, double* heights) : row_(row), heights_(heights) {}

    // Samples the profiles of the texels at x, of which the apexes are given, as far as they can raise a slope.
    // Returns the number of samples, the apex included.
    int sample(const ProfileSample* samples, V x, V apex, V slope) {
        constexpr int kStride = 8;  // samples between two tests of whether farther ones matter
        store(0, apex);
        const V most = hn::Sub(hn::Set(d, row_.highest + kRounding), apex);
        const V low = lowered(slope);
        int n = 1;
        while (n <= row_.reach) {
            if (hn::AllTrue(d, hn::Le(most, hn::Mul(low, hn::Set(d, n))))) break;
            for (const int end = std::min(n + kStride, row_.reach + 1); n < end; ++n) store(n, height(samples[n], x));
        }
        return n;
    }

    // Returns what the first `count` samples require, by the reference's rule and no other bound.
    V plain(V apex, int count) const {
        const V one = hn::Set(d, 1);
        V slope = hn::Zero(d);
        for (int j = 1; j < count; ++j) {
            M open = hn::Gt(hn::Sub(at(j), apex), hn::Mul(slope, hn::Set(d, j)));
            const V ray = hn::Div(hn::Sub(at(j), one), hn::Set(d, j));
            for (int k = j + 1; k < count && !hn::AllFalse(d, open); ++k) {
                const V here = hn::Add(one, hn::Mul(ray, hn::Set(d, k)));
                const M out = hn::AndNot(hn::Lt(here, at(k)), open);
                slope = hn::IfThenElse(out, hn::Max(slope, hn::Div(hn::Sub(here, apex), hn::Set(d, k))), slope);
                open = hn::AndNot(out, open);
            }
        }
        return slope;
    }

    // Returns the larger of `slope` and plain(), if that is at least kTiny.
    V raised(V slope, V apex, int count) const {
        const V one = hn::Set(d, 1);
        V after = hn::Zero(d);
        int known = 0;  // the sample of which `after` is the ray's slope
        for (int j = 1; j + 1 < count; ++j) {
            const V distance = hn::Set(d, j);
            const V height = at(j);
            M open = hn::Gt(hn::Sub(height, apex), hn::Mul(slope, distance));
            if (hn::AllFalse(d, open)) continue;
            const V next = hn::Set(d, j + 1);
            const V ray = known == j ? after : hn::Div(hn::Sub(height, one), distance);
            const V here = hn::Add(one, hn::Mul(ray, next));
            // No exit is nearer than the next sample or higher than the ray there.
            open = hn::And(open, hn::Gt(hn::Sub(here, apex), hn::Mul(lowered(slope), next)));
            if (hn::AllFalse(d, open)) continue;
            const V heightAfter = at(j + 1);
            const M below = hn::Lt(here, heightAfter);
            const M out = hn::AndNot(below, open);
            slope = hn::IfThenElse(out, hn::Max(slope, hn::Div(hn::Sub(here, apex), next)), slope);
            open = hn::AndNot(out, open);
            if (j + 2 < count) {
                after = hn::Div(hn::Sub(heightAfter, one), next);
                known = j + 1;
                const V second = hn::Add(one, hn::Mul(after, hn::Set(d, j + 2)));
                // The ray through the next sample is no lower, and is in the surface behind it: it leaves it no later
                // and no lower.
                const M hidden = hn::And(hn::And(below, hn::Ge(after, ray)), hn::Lt(second, at(j + 2)));
                open = hn::AndNot(hidden, open);
            }
            if (!hn::AllFalse(d, open)) slope = followed(slope, apex, ray, open, j + 2, count);
        }
        return slope;
    }

  private:
    // The heights at a sample of the profiles of the texels at x.
    V height(const ProfileSample& sample, V x) const {
        V where = hn::Add(x, hn::Set(d, sample.across));
        if (row_.bilinear) where = hn::Sub(where, hn::Set(d, 0.5));
        where = hn::Min(hn::Max(where, hn::Set(d, row_.least)), hn::Set(d, row_.most));
        const V whole = hn::Floor(where);
        const Columns columns(whole);
        if (!row_.bilinear) return columns.at(sample.upper);
        const V share = hn::Sub(where, whole), rest = hn::Sub(hn::Set(d, 1), share);
        const V top = hn::Add(hn::Mul(rest, columns.at(sample.upper)), hn::Mul(share, columns.at(sample.upper + 1)));
        const V bottom = hn::Add(hn::Mul(rest, columns.at(sample.lower)), hn::Mul(share, columns.at(sample.lower + 1)));
        return hn::Add(hn::Mul(hn::Set(d, 1 - sample.downShare), top), hn::Mul(hn::Set(d, sample.downShare), bottom));
    }
    static V lowered(V slope) { return hn::Mul(slope, hn::Set(d, 1 - kRounding)); }
    V at(int n) const { return hn::LoadU(d, heights_ + static_cast<std::size_t>(n) * hn::Lanes(d)); }
    void store(int n, V height) { hn::StoreU(height, d, heights_ + static_cast<std::size_t>(n) * hn::Lanes(d)); }

    // Follows the `open` rays, which are in the surface, from sample k on to where they leave it.
    V followed(V slope, V apex, V ray, M open, int k, int count) const {
        for (; k < count; ++k) {
            const V distance = hn::Set(d, k);
            const V here = hn::Add(hn::Set(d, 1), hn::Mul(ray, distance));
            const V rise = hn::Sub(here, apex);
            // Farther exits are lower.
            open = hn::And(open, hn::Gt(rise, hn::Mul(lowered(slope), distance)));
            if (hn::AllFalse(d, open)) break;
            const M out = hn::AndNot(hn::Lt(here, at(k)), open);
            if (hn::AllFalse(d, out)) continue;
            slope = hn::IfThenElse(out, hn::Max(slope, hn::Div(rise, distance)), slope);
            open = hn::AndNot(out, open);
        }
        return slope;
    }

    const RelaxedRow& row_;
    double* heights_;
};

void slopesOfRow(RelaxedRow& row, float* slopes) {
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const auto samples = static_cast<std::size_t>(row.reach) + 1;
    row.profiles.resize(samples * hn::Lanes(d));
    Profile profile(row, row.profiles.data());
    int first = 0;  // the azimuth that raised the slopes last: probably the one that decides the next ones
    for (int x = 0; x < row.width; x += lanes) {
        const V apex = heightsAt(row.apexes + x);
        const V middle = hn::Add(hn::Add(hn::Set(d, x), hn::Iota(d, 0)), hn::Set(d, 0.5));
        const auto sampled = [&](int azimuth, V slope) {
            return profile.sample(row.samples.data() + static_cast<std::size_t>(azimuth) * samples, middle, apex,
                                  slope);
        };
        V slope = hn::Zero(d);
        int decisive = first;
        for (int n = 0; n < row.azimuths; ++n) {
            const int azimuth = (first + n) % row.azimuths;
            const V raised = profile.raised(slope, apex, sampled(azimuth, slope));
            if (!hn::AllTrue(d, hn::Eq(raised, slope))) decisive = azimuth;
            slope = raised;
        }
        first = decisive;
        const M tiny = hn::And(hn::Gt(slope, hn::Zero(d)), hn::Lt(slope, hn::Set(d, kTiny)));
        if (!hn::AllFalse(d, tiny)) {
            V plain = hn::Zero(d);
            for (int n = 0; n < row.azimuths; ++n) {
                plain = hn::Max(plain, profile.plain(apex, sampled(n, hn::Zero(d))));
            }
            slope = hn::IfThenElse(tiny, plain, slope);
        }
        hn::StoreU(hn::DemoteTo(dFloat, slope), dFloat, slopes + x);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(slopesOfRow);

void relaxedSlopes(RelaxedRow& row, float* slopes) {
    HWY_DYNAMIC_DISPATCH(slopesOfRow)(row, slopes);
}

}  // namespace relief
#endif
