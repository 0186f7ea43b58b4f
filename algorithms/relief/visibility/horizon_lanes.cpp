#include "relief/visibility/horizon_bounds.h"

#include <cassert>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relief/visibility/horizon_lanes.cpp"
#include <hwy/foreach_target.h>
// Must be included after foreach_target.h.
#include "relief/simd/slope_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The sweep, in float.
namespace sweep {

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr std::size_t kLanes = hn::MaxLanes(D());

HWY_INLINE V set(float x) {
    return hn::Set(D(), x);
}
HWY_INLINE V at(const float* from, std::size_t k) {
    return hn::LoadU(D(), from + k);
}

// Writes, for each cell of the column, the highest that it can rise above the light within the strips that begin in it,
// in the cell before it, and two cells before it, as heights at the line; -1 where it nowhere rises faster. Columns:
// the height of the next cell across where it is higher.
void steepCells(const HorizonLine& line) {
    const D d;
    const V none = set(-1), less = set(line.riseLess), rounding = set(kHorizonStep);
    // Where in their first, second and third cell strips begin and end.
    const V begin = set(line.fraction), end = set(std::min(1.0F, line.fraction + line.slope));
    const V third = set(line.fraction + line.slope - 1);
    for (std::size_t k = 0; k < line.count + 2; k += kLanes) {
        const V a0 = at(line.near, k), a1 = at(line.near, k + 1);
        if (line.columns) {
            hn::StoreU(hn::IfThenElse(hn::Gt(a1, a0), a1, none), d, line.steep[0] + k);
            continue;
        }
        const V b0 = at(line.beside, k), b1 = at(line.beside, k + 1);
        const V acrossA = hn::Sub(a1, a0), acrossB = hn::Sub(b1, b0);
        const V along = hn::Max(hn::Sub(b0, a0), hn::Sub(b1, a1));
        const V steepest = hn::Add(along, hn::Mul(set(line.slope), hn::Max(acrossA, acrossB)));
        const auto steep = hn::Gt(steepest, set(line.rise - kHorizonSteepest));
        // The patch is highest above the light in a corner of the part.
        const auto put = [&](V a, V b, V share, float* to) HWY_ATTR {
            const V aAt = hn::Add(a0, hn::Mul(share, acrossA)), bAt = hn::Add(b0, hn::Mul(share, acrossB));
            const V top = hn::Max(hn::Max(a, aAt), hn::Sub(hn::Max(b, bAt), less));
            hn::StoreU(hn::IfThenElse(steep, hn::Add(top, rounding), none), d, to + k);
        };
        put(a1, b1, begin, line.steep[0]);
        put(a0, b0, end, line.steep[1]);
        if (line.third) put(a0, b0, third, line.steep[2]);
    }
}

// The lowest part of the strip's cross-section with the surface on the line.
HWY_INLINE V lowestOf(const HorizonLine& line, std::size_t k) {
    const V a0 = at(line.near, k), a1 = at(line.near, k + 1);
    if (line.columns) return line.fraction > 0 ? hn::Min(a0, a1) : a0;
    const V a2 = at(line.near, k + 2), share = set(line.fraction);
    const V low = hn::Add(a0, hn::Mul(share, hn::Sub(a1, a0))), high = hn::Add(a1, hn::Mul(share, hn::Sub(a2, a1)));
    return hn::Sub(hn::Min(hn::Min(low, a1), high), set(kHorizonStep));
}

void sweepLine(const HorizonLine& line) {
    const D d;
    const hn::Rebind<std::int32_t, D> di;
    const V none = set(-1), zero = hn::Zero(d);
    steepCells(line);
    for (std::size_t k = 0; k < line.count; k += kLanes) {
        V upper = hn::Max(hn::Sub(at(line.upper, k), set(line.riseLess)), none);
        V lower = hn::Max(hn::Sub(at(line.lower, k), set(line.riseMore)), none);
        if (line.columns) {
            // Steps up from the column before the line.
            const auto stepUp = [&](std::size_t n) HWY_ATTR {
                const V h = at(line.near, n);
                return hn::IfThenElse(hn::Gt(h, at(line.beside, n)), h, none);
            };
            upper = hn::Max(upper, stepUp(k));
            if (line.fraction > 0) upper = hn::Max(upper, stepUp(k + 1));
            if (line.second) upper = hn::Max(upper, at(line.steep[0], k));
            if (line.third) upper = hn::Max(upper, at(line.steep[0], k + 1));
        } else {
            upper = hn::Max(upper, at(line.steep[0], k));
            if (line.second) upper = hn::Max(upper, at(line.steep[1], k + 1));
            if (line.third) upper = hn::Max(upper, at(line.steep[2], k + 2));
        }
        lower = hn::Max(lower, lowestOf(line, k));
        hn::StoreU(upper, d, line.upper + k);
        hn::StoreU(lower, d, line.lower + k);
        const V low = set(line.lowest), perUnit = set(line.perUnit);
        const V above = hn::Mul(hn::Sub(upper, low), perUnit);
        const V below = hn::Mul(hn::Sub(lower, low), perUnit);
        // At most 16 bits: in a map of little relief kHorizonStep is many units, and the last unit is above all
        // heights.
        const V up = hn::IfThenElseZero(hn::Gt(above, zero), hn::Min(hn::Add(above, set(1)), set(65535)));
        const auto high = hn::ShiftLeft<16>(hn::ConvertTo(di, up));
        hn::StoreU(hn::Or(high, hn::ConvertTo(di, hn::Max(below, zero))), di,
                   reinterpret_cast<std::int32_t*>(line.out + k));
    }
}

}  // namespace sweep

// The queries, in double. Margins only need to cover the rounding, so nothing here repeats the ray's own operations.
namespace decide {

using slopes::D;
using slopes::DI;
using slopes::kLanes;
using slopes::set;
using slopes::V;
using slopes::VI;
using M = hn::Mask<D>;

// A vector of starts in the frame of the map.
struct Starts {
    V x, y, z;
    V column, cell;  // whole parts of x and y
    V strip;         // on line 0
    M decidable;
};

HWY_INLINE Starts startsAt(const HorizonBounds& bounds, V s, V t, V lambda) {
    const HorizonBounds::Frame& f = bounds.frame();
    const V nx = set(f.nx), ny = set(f.ny), near = set(kHorizonNear), one = set(1);
    Starts at;
    at.x = hn::Add(f.swapped ? t : s, set(f.shiftX));
    at.y = hn::Add(f.swapped ? s : t, set(f.shiftY));
    if (f.backX) at.x = hn::Sub(nx, at.x);
    if (f.backY) at.y = hn::Sub(ny, at.y);
    // A start next to a line counts as before it, where more of the surface lies ahead.
    if (f.wraps) {
        at.x = hn::Sub(at.x, hn::Mul(nx, hn::Floor(hn::Mul(hn::Sub(at.x, near), set(1.0 / f.nx)))));
        at.y = hn::Sub(at.y, hn::Mul(ny, hn::Floor(hn::Mul(at.y, set(1.0 / f.ny)))));
    }
    at.z = hn::Sub(one, lambda);
    at.column = hn::Floor(hn::Sub(at.x, near));
    at.cell = hn::Floor(at.y);
    const V across = hn::Sub(at.y, hn::Mul(set(f.slope), at.x));
    at.strip = hn::Floor(across);
    const V share = hn::Sub(across, at.strip);
    const M inStrip = hn::And(hn::Gt(share, near), hn::Lt(share, hn::Sub(one, near)));
    const M inMap = hn::And(hn::Ge(at.column, hn::Zero(D())), hn::Lt(at.column, nx));
    at.decidable = hn::And(inStrip, inMap);
    return at;
}

// The two bounds of the starts' strips on these lines, and whether the map has them.
struct Bounds {
    V upper, lower;
    M known;
};
HWY_INLINE Bounds boundsOn(const HorizonBounds& bounds, const Starts& at, V line) {
    const D d;
    const DI di;
    const HorizonBounds::Frame& f = bounds.frame();
    V c = hn::Add(at.strip, hn::Floor(hn::Mul(set(f.slope), line)));
    Bounds found;
    found.known = hn::And(at.decidable, hn::Le(line, set(f.nx)));
    if (f.wraps) {
        const V ny = set(f.ny);
        c = hn::Sub(c, hn::Mul(ny, hn::Floor(hn::Mul(hn::Add(c, set(0.5)), set(1.0 / f.ny)))));
    } else {
        c = hn::Add(c, set(1));
        found.known = hn::And(found.known, hn::And(hn::Ge(c, hn::Zero(d)), hn::Lt(c, set(f.ny + 2))));
    }
    const V entry = hn::IfThenElseZero(found.known, hn::Add(hn::Mul(line, set(static_cast<double>(f.stride))), c));
    const hn::Rebind<std::uint32_t, D> du;
    const auto both = hn::GatherIndex(du, bounds.entries(), hn::DemoteTo(di, entry));
    const auto height = [&](auto steps) HWY_ATTR {
        return hn::Add(hn::Mul(hn::PromoteTo(d, hn::BitCast(di, steps)), set(bounds.unit())), set(bounds.lowest()));
    };
    found.upper = height(hn::ShiftRight<16>(both));
    found.lower = height(hn::And(both, hn::Set(du, 0xffffU)));
    return found;
}

// Bilinear: returns the starts that leave their cell across the next line and meet nothing before it. across: distance
// in y to the next cell.
HWY_INLINE M freeOfOwnCell(const HorizonBounds& bounds, const slopes::Slope& slope, V along, V across) {
    const HorizonBounds::Frame& f = bounds.frame();
    const glm::dvec2 run = bounds.run();
    // The gap between ray and surface is slack * h - bend * h * h where the ray has risen by h.
    const V slack = hn::Sub(set(1), hn::Add(hn::Mul(set(run.x), slope.s), hn::Mul(set(run.y), slope.t)));
    const V bend = hn::Max(hn::Mul(slope.bend, set(run.x * run.y)), hn::Zero(D()));
    const V least = set(kHorizonNear * (std::abs(run.x) + std::abs(run.y)) + 1e-9);
    const M falls = hn::Ge(hn::Sub(slack, hn::Mul(bend, hn::Mul(along, set(f.rise)))), least);
    const V near = set(kHorizonNear);
    const M inCell = hn::And(hn::Gt(along, near), hn::And(hn::Gt(across, near), hn::Lt(across, set(1 - kHorizonNear))));
    return hn::And(hn::And(inCell, hn::Le(hn::Mul(along, set(f.slope)), across)), falls);
}

// Columns: returns the starts that meet nothing before their next line; they cross at most one cell on the way.
HWY_INLINE M freeOfOwnColumn(const HorizonBounds& bounds, const SlopeScene& scene, const Starts& at, V along, V across,
                             V margin) {
    const D d;
    const DI di;
    const HorizonBounds::Frame& f = bounds.frame();
    const V zero = hn::Zero(d), one = set(1), lastX = set(f.nx - 1.0), lastY = set(f.ny - 1.0), ny = set(f.ny);
    V x = hn::Min(hn::Max(at.column, zero), lastX), y = hn::Add(at.cell, one);
    if (f.backX) x = hn::Sub(lastX, x);
    if (f.backY) y = hn::Sub(lastY, y);
    if (f.wraps) y = hn::Sub(y, hn::Mul(ny, hn::Floor(hn::Mul(hn::Add(y, set(0.5)), set(1.0 / f.ny)))));
    y = hn::Min(hn::Max(y, zero), lastY);
    const V width = set(scene.width);
    const V texel = f.swapped ? hn::Add(hn::Mul(x, width), y) : hn::Add(hn::Mul(y, width), x);
    const hn::Rebind<float, D> df;
    const V beside = hn::PromoteTo(d, hn::GatherIndex(df, scene.heights, hn::DemoteTo(di, texel)));
    // The ray's height where it would enter that cell.
    const V crossing = hn::Add(at.z, hn::Mul(across, set(f.slope > 0 ? f.rise / f.slope : 0)));
    const M above = hn::Ge(crossing, hn::Add(beside, margin));
    const M inCell = hn::And(hn::Gt(across, set(kHorizonNear)), hn::Lt(across, set(1 - kHorizonNear)));
    return hn::And(inCell, hn::Or(hn::Le(hn::Mul(along, set(f.slope)), across), above));
}

template <class SlopeAt>
HWY_INLINE void decideWith(const HorizonBounds& bounds, const SlopeScene& scene, const SlopeAt& slopeAt,
                           std::span<const double> s, std::span<const double> t, std::span<const double> lambda,
                           std::span<const double> wanted, Horizon* answers) {
    const D d;
    const HorizonBounds::Frame& f = bounds.frame();
    const V one = set(1), rise = set(f.rise), zero = hn::Zero(d);
    const V margin = set(kHorizonStart + kHorizonNear * f.rise);
    for (std::size_t i = 0; i < s.size(); i += kLanes) {
        const std::size_t here = std::min(kLanes, s.size() - i);
        const V sAt = slopes::load(s.data() + i, here), tAt = slopes::load(t.data() + i, here);
        Starts at = startsAt(bounds, sAt, tAt, slopes::load(lambda.data() + i, here));
        at.decidable = hn::And(at.decidable, hn::Gt(slopes::load(wanted.data() + i, here), zero));
        const V along = hn::Sub(hn::Add(at.column, one), at.x), across = hn::Sub(hn::Add(at.cell, one), at.y);
        const Bounds next = boundsOn(bounds, at, hn::Add(at.column, one));
        const V zNext = hn::Add(at.z, hn::Mul(along, rise));
        const M blocked = hn::And(next.known, hn::Lt(hn::Add(zNext, margin), next.lower));
        M clear = hn::And(next.known, hn::Ge(zNext, hn::Add(next.upper, margin)));
        if (f.columns) {
            clear = hn::And(clear, freeOfOwnColumn(bounds, scene, at, along, across, margin));
        } else {
            const M own = freeOfOwnCell(bounds, slopeAt(sAt, tAt), along, across);
            clear = hn::And(clear, own);
            const M other = hn::AndNot(hn::Or(own, blocked), at.decidable);
            if (!hn::AllFalse(d, other)) {
                // The bound on the line behind the start holds for its own column too.
                const Bounds whole = boundsOn(bounds, at, at.column);
                const M above = hn::Ge(hn::Sub(zNext, rise), hn::Add(whole.upper, margin));
                clear = hn::Or(clear, hn::And(hn::And(other, whole.known), above));
            }
        }
        HWY_ALIGN double codes[kLanes];
        hn::Store(hn::IfThenElse(clear, one, hn::IfThenElseZero(blocked, set(2))), d, codes);
        for (std::size_t n = 0; n < here; ++n) answers[i + n] = static_cast<Horizon>(static_cast<int>(codes[n]));
    }
}

void decideRows(const HorizonBounds& bounds, const SlopeScene& scene, std::span<const double> s,
                std::span<const double> t, std::span<const double> lambda, std::span<const double> wanted,
                Horizon* answers) {
    if (bounds.frame().columns) {
        const auto none = [](V, V) HWY_ATTR { return slopes::Slope{}; };
        return decideWith(bounds, scene, none, s, t, lambda, wanted, answers);
    }
    slopes::withSlopes(scene, [&](const auto& slopeAt)
                                  HWY_ATTR { decideWith(bounds, scene, slopeAt, s, t, lambda, wanted, answers); });
}

}  // namespace decide

void sweepHorizon(const HorizonLine& line) {
    sweep::sweepLine(line);
}
void decideHorizon(const HorizonBounds& bounds, const SlopeScene& scene, std::span<const double> s,
                   std::span<const double> t, std::span<const double> lambda, std::span<const double> wanted,
                   Horizon* answers) {
    decide::decideRows(bounds, scene, s, t, lambda, wanted, answers);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(sweepHorizon);
HWY_EXPORT(decideHorizon);

void sweepHorizonLine(const HorizonLine& line) {
    HWY_DYNAMIC_DISPATCH(sweepHorizon)(line);
}

void HorizonBounds::decide(const SlopeScene& scene, std::span<const double> s, std::span<const double> t,
                           std::span<const double> lambda, std::span<const double> wanted,
                           std::span<Horizon> answers) const {
    assert(s.size() == t.size() && s.size() == lambda.size());
    assert(wanted.size() == s.size() && answers.size() == s.size());
    HWY_DYNAMIC_DISPATCH(decideHorizon)(*this, scene, s, t, lambda, wanted, answers.data());
}

}  // namespace relief
#endif
