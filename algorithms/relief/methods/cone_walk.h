// The walk by packed cones for one ray: the reference of simd/cone_walk-inl.h. Both use the same precision and the same
// margins (margins.md), so that they visit the same cells. Float only excludes cells. The leaf decides where a ray hits
// the surface in a cell. Where float cannot choose the next cell, next to corners and at the ends of the map, the walk
// in double takes over.
//
// Frame: float_scene.h. n counts cells from the one in which the ray begins, in the direction of the ray. The line
// after cell n is crossed at lambda = n * inverse + base, which is at or after the true crossing, later by no more than
// `tie` for both axes together.
#pragma once

#include <optional>
#include <type_traits>

#include "relief/float_leaf.h"
#include "relief/methods/float_place.h"
#include "relief/methods/packed_walk.h"
#include "relief/methods/steps_within.h"

namespace relief {

// One axis of a ray.
struct ConeAxis {
    bool back = false;  // the ray runs towards lower indices
    int first = 0;      // cell of the ray's start, before addressing is applied
    int n = 0;
    int last = 0;  // n of the map's last cell (of the current period under repeat)
    float run = 0, inverse = 0, base = 0;
    float place = 0;   // n at lambda is lambda * run - place, rounded; slightly early
    float margin = 0;  // largest error of a crossing, in lambda

    AxisCell cell(const GridAxis& axis) const { return cellOf(axis, back ? first - n : first + n); }
    static AxisCell cellOf(const GridAxis& axis, int at) {
        if (!axis.wraps) return {std::clamp(at, 0, axis.cells - 1), 0};
        const int base = at >= 0 ? at / axis.cells * axis.cells : -((axis.cells - 1 - at) / axis.cells) * axis.cells;
        return {at - base, base};
    }
    // The cell in which a jump to lambda ends, but at least the next cell if the ray moves along this axis.
    int beyond(bool moves, float lambda) const {
        const float whole = (lambda * run - place + kWhole) - kWhole;
        return std::max(moves ? n + 1 : n, static_cast<int>(whole));
    }
};

// A ray in float. It does not meet the surface before lambda `begin`.
struct ConeRay {
    ConeAxis x, y;
    float rim = 1;  // lambda at which the ray has left the map or reached the bottom of the slab
    float tie = 0;
    float steep = 0;  // the longer run, times kSteeper
    FloatFit fit = FloatFit::Fit;

    ConeRay(const FloatScene& scene, const GridRay& ray, double begin) {
        const FloatFit fitX = setUp(scene, scene.grid.x, ray.x, begin, x);
        fit = bothFit(fitX, setUp(scene, scene.grid.y, ray.y, begin, y));
        tie = (x.margin + y.margin) + (x.margin + y.margin);
        steep = std::max(x.run, y.run) * kSteeper;
        goTo(scene, x.cell(scene.grid.x), y.cell(scene.grid.y));
    }
    // Places the ray in the given cell.
    void goTo(const FloatScene& scene, AxisCell cx, AxisCell cy) {
        rim = 1;
        for (ConeAxis* axis : {&x, &y}) {
            const GridAxis& of = axis == &x ? scene.grid.x : scene.grid.y;
            const AxisCell& cell = axis == &x ? cx : cy;
            const int at = cell.index + static_cast<int>(cell.base);
            axis->n = axis->back ? axis->first - at : at - axis->first;
            axis->last = axis->n + (axis->back ? cell.index : of.cells - 1 - cell.index);
            if (scene.address != Address::Border) continue;
            // The rim is a line like others, at this distance beyond the line after the last cell.
            const float lines = static_cast<float>(axis->last) + static_cast<float>(of.high - of.cells);
            rim = std::min(rim, lines * axis->inverse + axis->base);
        }
    }
    // Lambda at which the ray leaves the cell across each axis.
    struct Crossings {
        float x, y;
        float first() const { return std::min(x, y); }
        float last() const { return std::max(x, y); }
    };
    Crossings crossings(const FloatScene& scene) const {
        constexpr float kNever = 1e30F;
        const auto at = [&](const ConeAxis& axis) {
            if (scene.address == Address::Clamp && axis.n == axis.last) return kNever;
            return static_cast<float>(axis.n) * axis.inverse + axis.base;
        };
        return {at(x), at(y)};
    }

  private:
    static FloatFit setUp(const FloatScene& scene, const GridAxis& axis, const RayAxis& ray, double begin,
                          ConeAxis& out) {
        const FloatPlace place(scene, axis, ray, begin);
        const bool fits = place.fit != FloatFit::Unfit;
        const float ahead = fits ? 1 - static_cast<float>(place.share) : 0;  // cells from the start to the next line
        out.back = place.back;
        out.first = fits ? static_cast<int>(place.back ? place.line - 1 : place.line) : 0;
        out.run = place.run;
        out.inverse = place.inverse;
        out.margin = place.margin;
        out.base = ahead * out.inverse + (static_cast<float>(begin) + out.margin);
        out.place = out.base * out.run + (out.run * kShorterJump + (kShorterJump - 0.5F));
        return place.fit;
    }
};

// The part of a ray near a corner of cells where float cannot decide which cell comes next. The ray does not meet the
// surface before `from`; float can decide again after `until` (infinite if that is beyond the ray's end).
struct AmbiguousPart {
    double from, until;

    // The part around the exit of the given cell.
    AmbiguousPart(const CellGrid& grid, const GridRay& ray, AxisCell cx, AxisCell cy) {
        // In cells: upper bound of how much later than the ray a float walk enters a cell. After the corner, float can
        // decide again beyond the same distance.
        constexpr double kLate = 0x1p-16;
        const auto enters = [](const RayAxis& of, const GridAxis& axis, AxisCell c) {
            return of.enter(axis, c.index, c.index + 1, c.base);
        };
        const auto leaves = [](const RayAxis& of, const GridAxis& axis, AxisCell c) {
            return of.leave(axis, c.index, c.index + 1, c.base);
        };
        const double outX = leaves(ray.x, grid.x, cx), outY = leaves(ray.y, grid.y, cy);
        const double first = std::min(outX, outY), last = std::max(outX, outY);
        const double lateX = std::abs(ray.x.inverse) * kLate, lateY = std::abs(ray.y.inverse) * kLate;
        // Each crossing minus the lateness of its own axis: where the ray hardly moves along an axis, that exceeds the
        // whole ray.
        const double in = std::max(enters(ray.x, grid.x, cx) - lateX, enters(ray.y, grid.y, cy) - lateY);
        from = std::max(std::min({in, outX - lateX, outY - lateY}) - kLate, 0.0);
        const double late = lateX + lateY + kLate;
        until = last - first < late ? last + late : std::numeric_limits<double>::infinity();
    }
};

// The walk for one field and its packed cones. Thread-safe.
class ConeWalk {
  public:
    // cones: those of this field; not owned, must outlive the walk.
    ConeWalk(const HeightField& field, const PackedCones& cones)
        : field_(field),
          cones_(cones),
          scene_(field, cones),
          unit_(static_cast<float>(cones.unit)),
          top_(static_cast<float>(1 - cones.highest)),
          topOfApex_(static_cast<float>(1 - cones.highest - static_cast<double>(kApexMore * unit_))) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const {
        return trace(viewRay, scene_.start, sink, sink);
    }
    // begin: lambda at which the ray leaves the packet in which it began, or scene().start. inDouble: receives the
    // steps that double takes where float cannot.
    template <class Sink, class DoubleSink>
    Hit trace(const ViewRay& viewRay, double begin, Sink& sink, DoubleSink& inDouble) const;
    // Traces within a segment, in double.
    template <class Sink>
    Hit traceSegment(const ViewRay& viewRay, Segment segment, Sink& sink) const {
        if (!viewRay.finite()) return Hit::none(Outcome::Miss);
        const ConeGround ground{field_, scene_.grid, cones_};
        PackedWalk part(ground, {viewRay}, 0, segment.in, segment.out);
        StepsWithin<Sink> within{sink, segment.in, segment.out};
        while (part.step(ground, within)) {
        }
        if (part.paused()) return Hit::none(Outcome::Miss);
        if (part.hit().outcome == Outcome::Limit) {
            within.step([&] {
                const double at = part.lambda();
                return cellRecord(field_, scene_.grid, part.x(), part.y(), Decision::Limit, at, at, 0, at);
            });
        }
        return part.hit();
    }
    const FloatScene& scene() const { return scene_; }

  private:
    // Ambiguous: float cannot choose the next cell. Fallback: the ray has returned to float too often and continues in
    // double to its end.
    enum class End : std::uint8_t { Hit, Miss, Ambiguous, Fallback };

    float depthAt(std::uint32_t depth) const { return static_cast<float>(depth) * unit_ + top_; }
    std::uint32_t entry(std::size_t quadrant, int cx, int cy) const {
        return cones_.quadrant(quadrant)[cones_.index(cx, cy)];
    }
    bool below(const ConeRay& ray, AxisCell cx, AxisCell cy, float out) const;
    bool neighbourClear(const ConeRay& ray, std::size_t quadrant, bool alongX, float out) const;
    std::optional<End> move(ConeRay& ray, std::size_t quadrant, const ConeRay::Crossings& cross, float jump) const;
    template <class Sink>
    End walk(const ViewRay& viewRay, const GridRay& exact, ConeRay& ray, double& lambda, int& returns, Hit& hit,
             Sink& sink) const;

    HeightField field_;
    const PackedCones& cones_;
    FloatScene scene_;
    float unit_, top_, topOfApex_;  // depth value d is at lambda top + d unit
};

// Returns true if the surface in the cell is certainly below the ray.
inline bool ConeWalk::below(const ConeRay& ray, AxisCell cx, AxisCell cy, float out) const {
    const FloatImage& heights = field_.heights();
    if (scene_.surface == Surface::Columns) return columnBelow(heights(cx.index, cy.index), out);
    const auto entered = [](const ConeAxis& axis) {
        return static_cast<float>(axis.n) * axis.inverse + (axis.base - axis.inverse);
    };
    const float latest = std::max(entered(ray.x), entered(ray.y));
    const float in = std::min(std::max(latest - ray.tie, 0.0F), out);
    const auto cellAxis = [](const ConeAxis& axis) {
        return FloatCellAxis{static_cast<float>(axis.n), axis.base - axis.inverse, axis.run, axis.back};
    };
    std::array<float, 4> corners;
    std::ranges::transform(cellCorners(heights, scene_.grid, cx.index, cy.index), corners.begin(),
                           [](double height) { return static_cast<float>(height); });
    return patchBelow(corners, cellAxis(ray.x), cellAxis(ray.y), in, out, ray.tie);
}

// Returns true if the ray is certainly above the surface of the neighbouring cell along one axis until it has passed
// the corner.
inline bool ConeWalk::neighbourClear(const ConeRay& ray, std::size_t quadrant, bool alongX, float out) const {
    ConeAxis next = alongX ? ray.x : ray.y;
    if (next.n == next.last && scene_.address != Address::Repeat) return scene_.address == Address::Clamp;
    ++next.n;
    const AxisCell cx = (alongX ? next : ray.x).cell(scene_.grid.x), cy = (alongX ? ray.y : next).cell(scene_.grid.y);
    return out + (ray.tie + ray.tie) < depthAt(coneOwnDepth(entry(quadrant, cx.index, cy.index)));
}

// Moves to the cell where the jump ends, but at least to the next one; returns an end if the walk stops.
inline std::optional<ConeWalk::End> ConeWalk::move(ConeRay& ray, std::size_t quadrant, const ConeRay::Crossings& cross,
                                                   float jump) const {
    const float out = std::min(cross.first(), ray.rim);
    if (ray.rim < 1) {
        // The ray is certainly beyond the rim; or float cannot decide whether rim or line comes first.
        if (std::max(cross.first(), jump) > ray.rim + ray.tie) return End::Miss;
        if (cross.first() + ray.tie >= ray.rim) return End::Ambiguous;
    } else if (out >= 1) {
        return End::Ambiguous;
    }
    // The ray passes too close to a corner to decide which neighbour comes first, and the jump does not pass the
    // corner. Both neighbours are skipped if they can be, and if the ray passes the corner before it leaves the cell
    // after it.
    const bool corner = std::abs(cross.x - cross.y) < ray.tie && jump < cross.last() + ray.tie;
    const auto clear = [&] {
        return ray.tie + ray.tie < std::min(ray.x.inverse, ray.y.inverse) && neighbourClear(ray, quadrant, true, out) &&
               neighbourClear(ray, quadrant, false, out);
    };
    if (corner && !clear()) return End::Ambiguous;
    const int nextX = ray.x.beyond(corner || cross.x <= cross.y, jump);
    const int nextY = ray.y.beyond(corner || cross.y <= cross.x, jump);
    const auto take = [&](ConeAxis& axis, const GridAxis& of, int next) {
        if (scene_.address == Address::Repeat) {
            while (next > axis.last) axis.last += of.cells;
        } else if (next > axis.last) {
            if (scene_.address == Address::Border) return false;
            next = axis.last;
        }
        axis.n = next;
        return true;
    };
    if (!take(ray.x, scene_.grid.x, nextX) || !take(ray.y, scene_.grid.y, nextY)) return End::Miss;
    return std::nullopt;
}

// Walks until the ray hits, misses, or float cannot choose the next cell.
template <class Sink>
ConeWalk::End ConeWalk::walk(const ViewRay& viewRay, const GridRay& exact, ConeRay& ray, double& lambda, int& returns,
                             Hit& hit, Sink& sink) const {
    const ConeGround ground{field_, scene_.grid, cones_};
    const std::size_t quadrant = quadrantOf(exact);
    while (true) {
        const AxisCell cx = ray.x.cell(scene_.grid.x), cy = ray.y.cell(scene_.grid.y);
        const std::uint32_t bits = entry(quadrant, cx.index, cy.index);
        const ConeRay::Crossings cross = ray.crossings(scene_);
        const float exit = cross.first();
        float jump = std::min(exit, ray.rim);
        // The log stores the exact exit of the cell; float places it slightly later.
        double out = lambda;
        if constexpr (!std::is_same_v<Sink, NullSink>) {
            out = std::clamp(cellInterval(scene_.grid, exact, cx, cy).out, lambda, 1.0);
        }
        double after = out;
        const auto note = [&](Decision decision) {
            return coneRecord(ground, exact, cx, cy, decision, {lambda, out}, bits, after);
        };
        sink.read(1);
        if (exit < depthAt(coneOwnDepth(bits))) {
            // The jump ends where the ray meets the cone.
            const float apexDepth = (kApexMore + static_cast<float>(coneApexDepth(bits))) * unit_ + topOfApex_;
            const float steepness = coneSlope(bits) * ray.steep + kSteeper;
            jump = std::max(apexDepth - exit, 0.0F) * (1 / steepness) + exit;
            after = std::min(out + static_cast<double>(jump - exit), 1.0);
            // Below the apex the ray is only known to be above the cell.
            const bool inCone = 1 - out > cones_.heightAt(coneApexDepth(bits));
            sink.step([&] { return note(inCone ? Decision::Advance : Decision::Skip); });
        } else {
            sink.read(leafReads(scene_.surface));
            const bool excluded = below(ray, cx, cy, jump);
            const auto met = excluded ? std::nullopt : leafHit(field_, scene_.grid, exact, cx, cy);
            if (met) {
                after = *met;
                sink.step([&] { return note(Decision::Hit); });
                hit = Hit::at(viewRay, *met);
                return End::Hit;
            }
            sink.step([&] { return note(Decision::Test); });
            // In SIMD, a ray whose candidate hit the leaf rejects resumes the walk.
            if (!excluded && ++returns > kMostReturns) return End::Fallback;
        }
        lambda = after;
        if (const auto end = move(ray, quadrant, cross, jump)) return *end;
    }
}

template <class Sink, class DoubleSink>
Hit ConeWalk::trace(const ViewRay& viewRay, double begin, Sink& sink, DoubleSink& inDouble) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const ConeGround ground{field_, scene_.grid, cones_};
    const GridRay exact(scene_.grid, viewRay);
    const auto record = [&](Decision decision, double at, double value) {
        const AxisCell cx = exact.x.cellAt(scene_.grid.x, at), cy = exact.y.cellAt(scene_.grid.y, at);
        return cellRecord(field_, scene_.grid, cx, cy, decision, at, at, value, at);
    };
    const auto none = [&](Outcome outcome, double at) {
        const Decision end = outcome == Outcome::Limit ? Decision::Limit : Decision::Miss;
        sink.step([&] { return record(end, std::min(at, 1.0), 0); });
        return Hit::none(outcome);
    };
    const auto miss = [&](double at) { return none(Outcome::Miss, at); };
    sink.step([&] { return record(Decision::Start, 0, 1); });
    if (exact.entersOutside(scene_.grid)) return miss(0);
    ConeRay ray(scene_, exact, begin);
    // Advance to the height of the highest point; or, in a packet, to where the ray leaves the packet.
    if (begin > 0) {
        sink.step([&] {
            Step step = record(Decision::Advance, begin, cones_.highest);
            if (begin <= scene_.start) step.phase = Phase::Start;
            step.lambdaIn = 0;
            return step;
        });
    }
    if (ray.fit == FloatFit::Gone) return miss(begin);
    double lambda = begin;
    constexpr double kEnd = std::numeric_limits<double>::infinity();
    double from = 0, until = kEnd, verified = 0;
    int returns = 0;
    while (true) {
        if (ray.fit == FloatFit::Fit) {
            Hit hit;
            const End end = walk(viewRay, exact, ray, lambda, returns, hit, sink);
            if (end == End::Hit) return hit;
            if (end == End::Miss) return miss(lambda);
            const AmbiguousPart part(scene_.grid, exact, ray.x.cell(scene_.grid.x), ray.y.cell(scene_.grid.y));
            from = std::max(part.from, verified);  // double has verified the ray up to here
            until = end == End::Fallback || ++returns > kMostReturns ? kEnd : part.until;
        }
        PackedWalk part(ground, {viewRay}, 0, from, until);
        StepsWithin<DoubleSink> rest{inDouble, lambda, 1};
        while (part.step(ground, rest)) {
        }
        if (!part.paused()) {
            const Outcome outcome = part.hit().outcome;
            return outcome == Outcome::Hit ? part.hit() : none(outcome, part.lambda());
        }
        if (begin != scene_.start) ray = ConeRay(scene_, exact, begin = scene_.start);
        ray.goTo(scene_, part.x(), part.y());
        verified = part.lambda();
        lambda = std::max(lambda, verified);
    }
}

}  // namespace relief
