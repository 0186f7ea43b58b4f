// The walk by packed cones in double, a step at a time: for what float cannot decide (cone_walk.h), for rays that the
// SIMD walk cannot finish, from where it stopped, and for visibility queries (visibility/packed_cone_any.h). All exact
// methods give the same bits: the one leaf decides, and cells partition the ray.
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

// What all walks share; the caller keeps it.
struct ConeGround {
    const HeightField& field;
    const CellGrid& grid;
    const PackedCones& cones;
};

// The record of a step: an advance is over the word's cone, which stands under the place where the ray leaves the cell;
// any other is about the cell's highest point.
inline Step coneRecord(const ConeGround& ground, const GridRay& ray, AxisCell cx, AxisCell cy, Decision decision,
                       CellInterval interval, std::uint32_t entry, double after) {
    // In the order of azimuths.
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

// Rays flatter than the domain of exactness each method gives up after steps of its own.
inline bool packedWalks(const CellGrid& grid, const ViewRay& ray) {
    return !ray.finite() || GridRay(grid, ray).inDomain();
}

// Rays that come back to float more often go on in double to their end.
inline constexpr int kMostReturns = 4;

// What a walk looks for: where a view ray meets the surface. Its parameter is lambda.
struct FirstHit {
    ViewRay line;

    // By how much, in heights, a ray must pass above what the leaf could still call a hit.
    static constexpr double kMargin = kExclusionMargin;
    const ViewRay& course() const { return line; }
    double heightAt(double lambda) const { return 1 - lambda; }
    double rise() const { return -1; }  // of heightAt, to the parameter
    double end(const CellGrid& grid, const GridRay& ray) const { return ray.end(grid); }
    double mostSteps(const GridRay& ray) const { return ray.cellBound() + 2; }
    std::optional<double> leaf(const ConeGround& ground, const GridRay& ray, AxisCell cx, AxisCell cy, double) const {
        return leafHit(ground.field, ground.grid, ray, cx, cy);
    }
    const Step& logged(const Step& step) const { return step; }
};

template <class Query>
class PackedConeWalk {
  public:
    // from: before it the line meets nothing. It pauses at the first place from `until` on. number: as the caller
    // counts.
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
    // Of a view ray that has ended.
    Hit hit() const { return outcome_ == Outcome::Hit ? Hit::at(query_.line, lambda_) : Hit::none(outcome_); }
    // Where it is: the place of x() and y(), unless it has ended.
    bool paused() const { return paused_; }
    const AxisCell& x() const { return x_; }
    const AxisCell& y() const { return y_; }
    double lambda() const { return lambda_; }

    // A step; false: it has ended, or come to where it was to pause.
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
                // What rises faster than the cone never meets it.
                const double free = closing > 0 ? room / closing * kShorterShare : 1;
                after += std::max(0.0, free - Query::kMargin);
            }
            // Below the apex it is above the cell alone.
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
    double left_;  // steps
    double out_ = 0;
    AxisCell x_, y_;
    bool testing_ = false;  // the cell itself is to be tested
    bool paused_ = false;
    Outcome outcome_ = Outcome::Unset;
};
using PackedWalk = PackedConeWalk<FirstHit>;

// All walks, each a step in turn: each waits for memory at every step, and so they wait together. What has come to its
// end is given to end().
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
