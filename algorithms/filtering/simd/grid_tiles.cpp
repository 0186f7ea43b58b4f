// The grid's work on all pixels and cells of a tile (grid_lanes.h).
#include <algorithm>
#include <bit>
#include <limits>

#include "filtering/grid_lanes.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/simd/grid_tiles.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "filtering/simd/lane_packing-inl.h"
#include "relief/simd/slope_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace tiles {

namespace hn = hwy::HWY_NAMESPACE;

using packing::D, packing::DI, packing::V, packing::M, packing::kLanes, packing::Packing, packing::withBits;
using slopes::load, slopes::set, slopes::store;
static_assert(kLanes <= kPointSlack && sizeof(std::size_t) == sizeof(std::int64_t));

// The SIMD version of scanScalar, for at least kPointSlack pixels.
void scanVectors(const FilterBlock& block, std::size_t first, std::size_t last, int across, int down, double largest,
                 TileScan& out) {
    const D d;
    const hn::Rebind<std::int32_t, D> d32;
    using V32 = hn::Vec<decltype(d32)>;
    const hn::Rebind<std::uint8_t, D> d8;
    const hn::RebindToSigned<D> whole;
    const auto word = [](const PixelView* const* view) HWY_ATTR {
        return hn::LoadU(hn::RebindToSigned<D>(), reinterpret_cast<const std::int64_t*>(view));
    };
    const auto view = hn::Set(whole, static_cast<std::int64_t>(reinterpret_cast<std::intptr_t>(block.view[first])));
    const V32 x = hn::Set(d32, block.x[first]), y = hn::Set(d32, block.y[first]);
    V32 apart = hn::Zero(d32), x0 = x, x1 = x, y0 = y, y1 = y;
    auto sameView = hn::Eq(view, view);
    M small = hn::RebindMask(d, sameView);
    auto exact = hn::Set(d8, std::uint8_t{0xFF});
    for (std::size_t from = first; from < last; from += kLanes) {
        // The last vector may contain pixels of the one before.
        const std::size_t i = std::min(from, last - kLanes);
        const V32 px = hn::LoadU(d32, block.x.data() + i), py = hn::LoadU(d32, block.y.data() + i);
        apart =
            hn::Or(apart, hn::Or(hn::ShiftRightSame(hn::Xor(px, x), across), hn::ShiftRightSame(hn::Xor(py, y), down)));
        x0 = hn::Min(x0, px), x1 = hn::Max(x1, px), y0 = hn::Min(y0, py), y1 = hn::Max(y1, py);
        sameView = hn::And(sameView, hn::Eq(word(block.view.data() + i), view));
        const auto size = [&](const std::vector<double>& column)
                              HWY_ATTR { return hn::Abs(hn::LoadU(d, column.data() + i)); };
        const V sides = hn::Add(hn::Add(hn::Add(size(block.ux), size(block.uy)), size(block.vx)), size(block.vy));
        small = hn::And(small, hn::Lt(sides, set(largest)));
        const auto flags = hn::LoadU(d8, block.exact.data() + i);
        exact = hn::IfThenZeroElse(hn::Eq(flags, hn::Zero(d8)), exact);
    }
    out.same = hn::AllTrue(d32, hn::Eq(apart, hn::Zero(d32))) && hn::AllTrue(whole, sameView);
    out.x0 = hn::GetLane(hn::MinOfLanes(d32, x0)), out.x1 = hn::GetLane(hn::MaxOfLanes(d32, x1));
    out.y0 = hn::GetLane(hn::MinOfLanes(d32, y0)), out.y1 = hn::GetLane(hn::MaxOfLanes(d32, y1));
    out.usable = hn::AllTrue(d, small) && hn::AllFalse(d8, hn::Eq(exact, hn::Zero(d8)));
}

bool copyHits(const PictureHits& picture, std::size_t from, std::size_t count, std::uint8_t polygon, glm::dvec2 scale,
              const CellColumns& out) {
    const D d;
    const hn::Rebind<float, D> df;
    const HitBlock& hits = *picture.hits;
    static_assert(sizeof(Outcome) == 1);
    const std::uint8_t* polygons = picture.polygon + from;
    const auto* outcomes = reinterpret_cast<const std::uint8_t*>(hits.outcome.data() + from);
    const auto equal = [](const std::uint8_t* bytes, std::uint8_t value, std::size_t here) HWY_ATTR {
        const hn::Rebind<std::uint8_t, D> narrow;
        const hn::Rebind<std::uint32_t, D> wide;
        const hn::RebindToUnsigned<D> whole;
        HWY_ALIGN std::uint8_t some[kLanes] = {};
        if (HWY_UNLIKELY(here < kLanes)) std::copy_n(bytes, here, some), bytes = some;
        const auto all = hn::PromoteTo(whole, hn::PromoteTo(wide, hn::LoadU(narrow, bytes)));
        return hn::RebindMask(D(), hn::Eq(all, hn::Set(whole, std::uint64_t{value})));
    };
    std::size_t known = 0;
    for (std::size_t n = 0; n < count; ++n) {
        out.known[n] = polygons[n] == polygon ? 1 : 0;
        known += out.known[n];
    }
    for (std::size_t n = 0; n < count; n += kLanes) {
        const std::size_t here = std::min(kLanes, count - n);
        const M hit = hn::And(equal(polygons + n, polygon, here),
                              equal(outcomes + n, static_cast<std::uint8_t>(Outcome::Hit), here));
        const V none = set(std::numeric_limits<double>::quiet_NaN());
        // Whole vectors are stored: the cells behind belong to later rows or to the padding.
        const auto column = [&](const std::vector<double>& all, double* to, float* narrow, double per) HWY_ATTR {
            const V value = hn::IfThenElse(hit, load(all.data() + from + n, here), none);
            hn::StoreU(value, d, to + n);
            hn::StoreU(hn::DemoteTo(df, hn::Mul(value, set(per))), df, narrow + n);
        };
        column(hits.s, out.s, out.pictureS, scale.x);
        column(hits.t, out.t, out.pictureT, scale.y);
        column(hits.lambda, out.lambda, out.floatLambda, 1);
    }
    return known == count;
}

void splitRun(const SplitJob& job, std::size_t first, std::size_t count, std::size_t cell, SplitColumns& out) {
    const D d;
    const FilterBlock& block = *job.block;
    for (std::size_t n = 0; n < count; n += kLanes) {
        const std::size_t i = first + n, c = cell + n, here = std::min(kLanes, count - n);
        const M all = hn::FirstN(d, here);
        const M plane = hn::And(all, withBits(job.around + c, kOnPlane));
        const auto index = hn::Iota(DI(), static_cast<std::int64_t>(i));
        const auto list = [&](M chosen, std::vector<std::size_t>& to, std::size_t at) HWY_ATTR {
            hn::StoreU(Packing(chosen)(index), DI(), reinterpret_cast<std::int64_t*>(to.data() + at));
        };
        if (!hn::AllFalse(d, plane)) {
            const Packing packed(plane);
            const M level = withBits(job.around + c, kOnLevel);
            const auto column = [&](V value, double scale, std::vector<double>& to) HWY_ATTR {
                hn::StoreU(packed(hn::Mul(value, set(scale))), d, to.data() + out.planeCount);
            };
            const auto along = [&](const std::vector<double>& own, const double* centres, std::size_t way) HWY_ATTR {
                const V half =
                    hn::Mul(set(0.5), hn::Sub(hn::LoadU(d, centres + c + way), hn::LoadU(d, centres + c - way)));
                return hn::IfThenElse(level, load(own.data() + i, here), half);
            };
            FilterBlock& planes = out.planes;
            column(load(block.s.data() + i, here), job.scale.x, planes.s);
            column(load(block.t.data() + i, here), job.scale.y, planes.t);
            column(along(block.ux, job.s, 1), job.scale.x, planes.ux);
            column(along(block.vx, job.t, 1), job.scale.y, planes.vx);
            column(along(block.uy, job.s, job.row), job.scale.x, planes.uy);
            column(along(block.vy, job.t, job.row), job.scale.y, planes.vy);
            list(plane, out.planeOf, out.planeCount);
            out.planeCount += hn::CountTrue(d, plane);
        }
        const M edge = hn::AndNot(plane, all);
        if (hn::AllFalse(d, edge)) continue;
        list(edge, out.edges, out.edgeCount);
        out.edgeCount += hn::CountTrue(d, edge);
    }
}

std::size_t listPlaces(const PlacesJob& job, double* x, double* y, std::uint32_t* slots) {
    const D d;
    const hn::Rebind<std::int32_t, D> di;
    const auto bit = static_cast<std::uint16_t>(1U << job.point);
    std::size_t count = 0;
    for (std::size_t n = 0; n < job.row; n += kLanes) {
        const M chosen = hn::And(hn::AndNot(withBits(job.interpolated + n, bit), withBits(job.needed + n, bit)),
                                 hn::FirstN(d, std::min(kLanes, job.row - n)));
        if (hn::AllFalse(d, chosen)) continue;
        const Packing packed(chosen);
        const V cell = hn::Iota(d, static_cast<double>(n));
        const V slot =
            hn::Add(hn::Mul(hn::Add(cell, set(static_cast<double>(job.cell))), set(static_cast<double>(job.points))),
                    set(static_cast<double>(job.point)));
        hn::StoreU(packed(hn::Add(hn::Add(cell, set(job.x)), set(job.off))), d, x + count);
        hn::StoreU(set(job.y), d, y + count);
        hn::StoreU(hn::DemoteTo(di, packed(slot)), di, reinterpret_cast<std::int32_t*>(slots + count));
        count += hn::CountTrue(d, chosen);
    }
    return count;
}

void meanUniform(const MeanJob& job, std::size_t first, std::size_t last, const std::uint16_t* uniform,
                 std::uint16_t* needed, PointColor* colors) {
    const hn::CappedTag<float, 4> d;
    const hn::CappedTag<std::uint16_t, 8> bits;
    constexpr std::size_t kCells = hn::MaxLanes(hn::CappedTag<std::uint16_t, 8>());
    const auto bit = static_cast<std::uint16_t>(1U << job.point);
    const auto mean = [&](std::size_t c) HWY_ATTR {
        needed[c] = static_cast<std::uint16_t>(needed[c] & ~bit);
        const PointColor* p = colors + (c - job.square) * job.points;
        const PointColor *q = p + job.points, *r = p + job.row * job.points, *s = r + job.points;
        for (std::size_t n = 0; n < 4; n += hn::MaxLanes(hn::CappedTag<float, 4>())) {
            const auto part = [&](const PointColor* of, std::size_t k)
                                  HWY_ATTR { return hn::Mul(hn::Set(d, job.share[k]), hn::Load(d, of->channel + n)); };
            const auto above = hn::Add(part(p, 0), part(q, 1)), below = hn::Add(part(r, 2), part(s, 3));
            hn::Store(hn::Add(above, below), d, colors[c * job.points + job.point].channel + n);
        }
    };
    for (std::size_t c = first; c < last; c += kCells) {
        const auto both = hn::And(hn::LoadU(bits, needed + c), hn::LoadU(bits, uniform + c - job.square));
        const auto chosen = hn::Ne(hn::And(both, hn::Set(bits, bit)), hn::Zero(bits));
        if (hn::AllFalse(bits, chosen)) continue;
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(bits, chosen, mask);
        for (unsigned left = mask[0]; left != 0; left &= left - 1) {
            const std::size_t at = c + static_cast<std::size_t>(std::countr_zero(left));
            if (at < last) mean(at);
        }
    }
}

}  // namespace tiles

// HWY_EXPORT needs these names in this namespace.
using tiles::copyHits, tiles::listPlaces, tiles::meanUniform, tiles::scanVectors, tiles::splitRun;

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(scanVectors);
HWY_EXPORT(copyHits);
HWY_EXPORT(splitRun);
HWY_EXPORT(listPlaces);
HWY_EXPORT(meanUniform);

namespace {

void scanScalar(const FilterBlock& block, std::size_t first, std::size_t last, int across, int down, double largest,
                TileScan& out) {
    out = {true, block.x[first], block.x[first], block.y[first], block.y[first], true};
    for (std::size_t i = first; i < last; ++i) {
        out.same = out.same && block.view[i] == block.view[first] && block.x[i] >> across == block.x[first] >> across &&
                   block.y[i] >> down == block.y[first] >> down;
        out.x0 = std::min(out.x0, block.x[i]), out.x1 = std::max(out.x1, block.x[i]);
        out.y0 = std::min(out.y0, block.y[i]), out.y1 = std::max(out.y1, block.y[i]);
        out.usable = out.usable && block.exact[i] != 0 && block.sides(i) < largest;
    }
}

}  // namespace

TileScan scanTile(const FilterBlock& block, std::size_t first, std::size_t last, int across, int down, double largest) {
    TileScan out;
    if (last - first < kPointSlack) {
        scanScalar(block, first, last, across, down, largest, out);
    } else {
        HWY_DYNAMIC_DISPATCH(scanVectors)(block, first, last, across, down, largest, out);
    }
    return out;
}

bool copyHits(const PictureHits& picture, std::size_t from, std::size_t count, std::uint8_t polygon, glm::dvec2 scale,
              const CellColumns& out) {
    return HWY_DYNAMIC_DISPATCH(copyHits)(picture, from, count, polygon, scale, out);
}

void meanUniform(const MeanJob& job, std::size_t first, std::size_t last, const std::uint16_t* uniform,
                 std::uint16_t* needed, PointColor* colors) {
    HWY_DYNAMIC_DISPATCH(meanUniform)(job, first, last, uniform, needed, colors);
}

void splitRun(const SplitJob& job, std::size_t first, std::size_t count, std::size_t cell, SplitColumns& out) {
    HWY_DYNAMIC_DISPATCH(splitRun)(job, first, count, cell, out);
}

std::size_t listPlaces(const PlacesJob& job, double* x, double* y, std::uint32_t* slots) {
    return HWY_DYNAMIC_DISPATCH(listPlaces)(job, x, y, slots);
}

}  // namespace relief
#endif
