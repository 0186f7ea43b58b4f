#include "filtering/grid_lanes.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/simd/grid_follow.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "filtering/simd/lane_packing-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace follow {

namespace hn = hwy::HWY_NAMESPACE;

using packing::D, packing::V, packing::M, packing::kLanes, packing::Packing;
static_assert(kLanes <= kPointSlack);

HWY_INLINE V set(double x) {
    return hn::Set(D(), x);
}

// Selects those of the cells from c on whose point is needed and interpolated.
HWY_INLINE M selected(const FollowJob& job, std::size_t c) {
    const auto bit = static_cast<std::uint16_t>(1U << job.point);
    return hn::And(packing::withBits(job.needed + c, bit), packing::withBits(job.interpolated + c, bit));
}

// A coordinate of points, and its derivatives along x and y of the picture.
struct Coordinate {
    V at, alongX, alongY;
};
HWY_INLINE Coordinate centre(const FollowJob& job, const double* column, std::size_t c) {
    const D d;
    const auto half = [&](std::size_t way) HWY_ATTR {
        return hn::Mul(set(0.5), hn::Sub(hn::LoadU(d, column + c + way), hn::LoadU(d, column + c - way)));
    };
    return {hn::LoadU(d, column + c), half(1), half(job.row)};
}
HWY_INLINE Coordinate between(const FollowJob& job, const double* column, std::size_t c) {
    const D d;
    const double* from = column + c - job.square;
    const V p = hn::LoadU(d, from), q = hn::LoadU(d, from + 1);
    const V r = hn::LoadU(d, from + job.row), w = hn::LoadU(d, from + job.row + 1);
    const auto mixed = [](V a, double ofA, V b, double ofB)
                           HWY_ATTR { return hn::Add(hn::Mul(set(ofA), a), hn::Mul(set(ofB), b)); };
    const auto& share = job.shares;
    const V above = mixed(p, share[0], q, share[1]), below = mixed(r, share[2], w, share[3]);
    return {hn::Add(above, below), mixed(hn::Sub(q, p), share[0] + share[1], hn::Sub(w, r), share[2] + share[3]),
            mixed(hn::Sub(r, p), share[0] + share[2], hn::Sub(w, q), share[1] + share[3])};
}

// Writes the points from index `count` on, in whole vectors, and returns the new number of points.
template <bool kCentre>
std::size_t points(const FollowJob& job, PointBlock& out, std::uint32_t* slots, std::size_t count) {
    const D d;
    const hn::Rebind<float, D> df;
    const hn::Rebind<std::int32_t, D> di;
    const PointBlur& blur = job.blur;
    const V perSlot = set(static_cast<double>(job.points)), point = set(static_cast<double>(job.point));
    for (std::size_t c = job.first; c < job.last; c += kLanes) {
        const M mask = selected(job, c);
        if (hn::AllFalse(d, mask)) continue;
        const Packing packed(mask);
        const auto coordinate = [&](const double* column, double scale, std::vector<double>& at, std::vector<float>& u,
                                    std::vector<float>& v) HWY_ATTR {
            const Coordinate x = kCentre ? centre(job, column, c) : between(job, column, c);
            const auto along = [&](double ofX, double ofY) HWY_ATTR {
                const V sum = hn::Add(hn::Mul(set(ofX * scale), x.alongX), hn::Mul(set(ofY * scale), x.alongY));
                return hn::DemoteTo(df, packed(sum));
            };
            hn::StoreU(packed(hn::Mul(x.at, set(scale))), d, at.data() + count);
            hn::StoreU(along(blur.xx, blur.xy), df, u.data() + count);
            hn::StoreU(along(blur.xy, blur.yy), df, v.data() + count);
        };
        coordinate(job.s, job.scale.x, out.s, out.ux, out.uy);
        coordinate(job.t, job.scale.y, out.t, out.vx, out.vy);
        const V slot = hn::Add(hn::Mul(hn::Iota(d, static_cast<double>(c)), perSlot), point);
        hn::StoreU(hn::DemoteTo(di, packed(slot)), di, reinterpret_cast<std::int32_t*>(slots + count));
        count += hn::CountTrue(d, mask);
    }
    return count;
}

}  // namespace follow

std::size_t gridFollow(const FollowJob& job, PointBlock& out, std::uint32_t* slots, std::size_t count) {
    return job.point == 0 ? follow::points<true>(job, out, slots, count)
                          : follow::points<false>(job, out, slots, count);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(gridFollow);

void followPoints(const FollowJob& job, PointBlock& out, std::vector<std::uint32_t>& slots) {
    const std::size_t before = out.size(), most = before + (job.last - job.first);
    out.resize(most);
    if (slots.size() < most + kPointSlack) slots.resize(most + kPointSlack);
    out.resize(HWY_DYNAMIC_DISPATCH(gridFollow)(job, out, slots.data(), before));
}

}  // namespace relief
#endif
