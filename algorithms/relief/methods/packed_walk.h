// The walk by packed cones in double, one step at a time. It is used where float cannot decide (cone_walk.h), to finish
// rays that the SIMD walk cannot, from where that stopped, and for visibility queries (visibility/packed_cone_any.h).
// All exact methods return the same bits, since the leaf decides all hits and the cells partition the ray.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <hwy/cache_control.h>

#include "relief/cell_record.h"
#include "relief/maps/packed_cones.h"

namespace relief {

// The data that all walks share; not owned.
struct ConeGround {
    const HeightField& field;
    const CellGrid& grid;
    const PackedCones& cones;
};

// The record of a step. The subject of an advance is the entry's cone, which stands below the point where the ray
// leaves the cell; that of other decisions is the cell's highest point.
inline Step coneRecord(const ConeGround& ground, const GridRay& ray, AxisCell cx, AxisCell cy, Decision decision,
                       CellInterval interval, std::uint32_t entry, double after) {
    // Azimuth sector of each quadrant.
    constexpr std::array<int, 4> kSectors{0, 1, 3, 2};
    const bool advances = decision == Decision::Advance;
    const double own = ground.cones.heightAt(coneOwnDepth(entry)), slope = static_cast<double>(coneSlope(entry));
    Step step = cellRecord(ground.field, ground.grid, cx, cy, decision, interval.in, interval.out,
                           advances ? slope : own, after);
    if (!advances) {
        step.subject = subject::Texel{0, step.i, step.j, own, {}};
        return step;
    }
    const double s = ray.x.start + interval.out * ray.x.run - ground.grid.x.shift;
    const double t = ray.y.start + interval.out * ray.y.run - ground.grid.y.shift;
    const double apex = ground.cones.heightAt(coneApexDepth(entry));
    step.subject = subject::Cone{s, t, apex, slope, kSectors[quadrantOf(ray)], 4, true, true};
    return step;
}

// True if the ray ends in the same way in every method. Rays flatter than the domain of exactness end in each method
// after a different number of steps.
inline bool packedWalks(const CellGrid& grid, const ViewRay& ray) {
    return !ray.finite() || GridRay(grid, ray).inDomain();
}

// Rays that return to float more often continue in double to their end.
inline constexpr int kMostReturns = 4;

// The target of a walk for a view ray: the first hit of the surface. The parameter is lambda.
struct FirstHit {
    ViewRay line;

    // Clearance, in heights, by which a ray must pass above a cell; the leaf's rounding could still make a closer ray a
    // hit.
    static constexpr double kMargin = kExclusionMargin;
    const ViewRay& course() const { return line; }
    double heightAt(double lambda) const { return 1 - lambda; }
    double rise() const { return -1; }  // derivative of heightAt() by the parameter
    double end(const CellGrid& grid, const GridRay& ray) const { return ray.end(grid); }
    double mostSteps(const GridRay& ray) const { return ray.cellBound() + 2; }
    std::optional<double> leaf(const ConeGround& ground, const GridRay& ray, AxisCell cx, AxisCell cy, double) const {
        return leafHit(ground.field, ground.grid, ray, cx, cy);
    }
    const Step& logged(const Step& step) const { return step; }
};

// The state of one walk. Query defines the line, its height along the parameter, and the leaf: FirstHit or BlockingCell
// (visibility/packed_cone_any.h).
template <class Query>
class PackedConeWalk {
  public:
    // number: any number by which the caller identifies the walk. from: the line does not meet the surface before.
    // until: the walk pauses at the first step that ends at or after this parameter.
    PackedConeWalk(const ConeGround& ground, const Query& query, std::size_t number, double from, double until)
        : number_(number),
          query_(query),
          ray_(ground.grid, query.course()),
          quadrant_(quadrantOf(ray_)),
          run_(std::max(std::abs(ray_.x.run), std::abs(ray_.y.run))),
          end_(query.end(ground.grid, ray_)),
          lambda_(from),
          until_(until),
          left_(query.mostSteps(ray_)) {
        arrive(ground);
    }

    std::size_t number() const { return number_; }
    const GridRay& ray() const { return ray_; }
    Outcome outcome() const { return outcome_; }
    // Result of a view ray whose walk has ended.
    Hit hit() const { return outcome_ == Outcome::Hit ? Hit::at(query_.line, lambda_) : Hit::none(outcome_); }
    // True if the walk is paused. Then, and while it goes on, the line is at lambda() in the cell x(), y().
    bool paused() const { return paused_; }
    const AxisCell& x() const { return x_; }
    const AxisCell& y() const { return y_; }
    double lambda() const { return lambda_; }

    // Takes a step. Returns false if the walk has ended or paused.
    template <class Sink>
    bool step(const ConeGround& ground, Sink& sink) {
        const std::uint32_t entry = ground.cones.quadrant(quadrant_)[ground.cones.index(x_.index, y_.index)];
        const auto note = [&](Decision decision, double after) {
            return [&, decision, after] {
                return query_.logged(coneRecord(ground, ray_, x_, y_, decision, {lambda_, out_}, entry, after));
            };
        };
        double after = out_;
        if (testing_) {
            const auto met = query_.leaf(ground, ray_, x_, y_, out_);
            sink.read(leafReads(ground.field.surface()));
            sink.step(note(met ? Decision::Hit : Decision::Test, met ? *met : out_));
            if (met) return finish(Outcome::Hit, *met);
            testing_ = false;
        } else {
            sink.read(1);
            const double zOut = query_.heightAt(out_), lowest = std::min(query_.heightAt(lambda_), zOut);
            if (!(ground.cones.heightAt(coneOwnDepth(entry)) + Query::kMargin < lowest)) {
                testing_ = true;
                fetchHeights(ground);
                return true;
            }
            const double room = zOut - ground.cones.heightAt(coneApexDepth(entry));
            const double closing = static_cast<double>(coneSlope(entry)) * run_ - query_.rise();
            if (room > 0) {
                // A line that rises faster than the cone never meets it.
                const double free = closing > 0 ? room / closing * kShorterShare : 1;
                after += std::max(0.0, free - Query::kMargin);
            }
            // Below the apex the line is only known to be above the cell.
            sink.step(note(room > 0 ? Decision::Advance : Decision::Skip, std::min(after, end_)));
        }
        if (!(after < end_)) return finish(Outcome::Miss, after);
        lambda_ = after;
        if (!(--left_ > 0)) return finish(Outcome::Limit, after);
        arrive(ground);
        paused_ = lambda_ >= until_;
        return !paused_;
    }

  private:
    bool finish(Outcome outcome, double lambda) {
        outcome_ = outcome;
        lambda_ = lambda;
        return false;
    }
    void arrive(const ConeGround& ground) {
        x_ = ray_.x.cellAt(ground.grid.x, lambda_);
        y_ = ray_.y.cellAt(ground.grid.y, lambda_);
        out_ = std::max(std::min(cellInterval(ground.grid, ray_, x_, y_).out, end_), lambda_);
        hwy::Prefetch(ground.cones.quadrant(quadrant_) + ground.cones.index(x_.index, y_.index));
    }
    void fetchHeights(const ConeGround& ground) const {
        const auto width = static_cast<std::size_t>(ground.field.width());
        const bool nodes = ground.field.surface() == Surface::Bilinear;
        const auto at = [&](int i, int j) {
            return ground.field.heights().data() + static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
        };
        const int i = nodes ? ground.grid.x.nodeBefore(x_.index) : x_.index;
        hwy::Prefetch(at(i, nodes ? ground.grid.y.nodeBefore(y_.index) : y_.index));
        if (nodes) hwy::Prefetch(at(i, ground.grid.y.nodeAfter(y_.index)));
    }

    std::size_t number_;
    Query query_;
    GridRay ray_;
    std::size_t quadrant_;
    double run_, end_;
    double lambda_, until_;
    double left_;  // steps until the limit
    double out_ = 0;
    AxisCell x_, y_;
    bool testing_ = false;  // the surface in the cell is to be tested
    bool paused_ = false;
    Outcome outcome_ = Outcome::Unset;
};
using PackedWalk = PackedConeWalk<FirstHit>;

// Runs all walks, one step of each in turn. Each step waits for memory, and in this way those waits overlap. Calls
// end() with each walk that has ended or paused. Leaves `walks` empty.
template <class End>
void walkAll(const ConeGround& ground, std::vector<PackedWalk>& walks, const End& end) {
    NullSink sink;
    while (!walks.empty()) {
        for (std::size_t n = 0; n < walks.size();) {
            if (walks[n].step(ground, sink)) {
                ++n;
                continue;
            }
            end(walks[n]);
            walks[n] = walks.back();
            walks.pop_back();
        }
    }
}

}  // namespace relief
