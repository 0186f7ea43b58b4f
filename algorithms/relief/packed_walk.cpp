#include "relief/packed_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/cache_control.h>

#include "relief/leaf.h"
#include "relief/packed_cone_any.h"

namespace relief {

namespace {

// What all walks share.
struct Ground {
    const HeightField& field;
    const CellGrid& grid;
    const PackedCones& cones;
};

class Walk {
  public:
    // number: as the caller counts.
    Walk(const Ground& ground, const ViewRay& viewRay, std::size_t number, double from, double until)
        : number_(number),
          viewRay_(viewRay),
          ray_(ground.grid, viewRay),
          quadrant_(PackedConeAnyHit::quadrant(ray_)),
          run_(std::max(std::abs(ray_.x.run), std::abs(ray_.y.run))),
          end_(ray_.end(ground.grid)),
          lambda_(from),
          until_(until),
          left_(ray_.cellBound() + 2) {
        arrive(ground);
    }

    std::size_t number() const { return number_; }
    const Hit& hit() const { return hit_; }
    // Not at a hit or a miss: where it is.
    bool paused() const { return paused_; }
    const AxisCell& x() const { return x_; }
    const AxisCell& y() const { return y_; }

    // A step; false: it has ended, or come to where it was to pause.
    bool step(const Ground& ground) {
        double after = out_;
        if (testing_) {
            const Surface surface = ground.field.surface();
            const FloatImage& heights = ground.field.heights();
            const auto met = surface == Surface::Bilinear
                                 ? leafHit<Surface::Bilinear>(heights, ground.grid, ray_, x_, y_)
                                 : leafHit<Surface::Columns>(heights, ground.grid, ray_, x_, y_);
            if (met) return finish(Hit::at(viewRay_, *met));
            testing_ = false;
        } else {
            const std::uint32_t word = ground.cones.quadrant(quadrant_)[ground.cones.index(x_.index, y_.index)];
            if (!(ground.cones.heightAt(coneOwnDepth(word)) + kExclusionMargin < 1 - out_)) {
                testing_ = true;
                fetchHeights(ground);
                return true;
            }
            after += freeBehind(ground.cones, word);
        }
        lambda_ = after;
        if (!(lambda_ < end_)) return finish(Hit::none(Outcome::Miss));
        if (!(--left_ > 0)) return finish(Hit::none(Outcome::Limit));
        arrive(ground);
        paused_ = lambda_ >= until_;
        return !paused_;
    }

  private:
    bool finish(const Hit& hit) {
        hit_ = hit;
        return false;
    }
    // Lambda from the way out of the cell to where the ray meets its cone.
    double freeBehind(const PackedCones& cones, std::uint32_t word) const {
        const double room = 1 - out_ - cones.heightAt(coneApexDepth(word));
        const double free = room / (1 + static_cast<double>(coneSlope(word)) * run_) * PackedConeAnyHit::kShorter;
        return std::max(0.0, free - kExclusionMargin);
    }
    void arrive(const Ground& ground) {
        x_ = ray_.x.cellAt(ground.grid.x, lambda_);
        y_ = ray_.y.cellAt(ground.grid.y, lambda_);
        out_ = std::max(cellStay(ground.grid, ray_, x_, y_).out, lambda_);
        hwy::Prefetch(ground.cones.quadrant(quadrant_) + ground.cones.index(x_.index, y_.index));
    }
    void fetchHeights(const Ground& ground) const {
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
    ViewRay viewRay_;
    GridRay ray_;
    std::size_t quadrant_;
    double run_, end_;
    double lambda_, until_;
    double left_;  // steps
    double out_ = 0;
    AxisCell x_, y_;
    bool testing_ = false;  // the cell itself is to be tested
    bool paused_ = false;
    Hit hit_;
};

// All walks, each a step in turn; what has come to its end is given to end().
template <class End>
void walkAll(const Ground& ground, std::vector<Walk>& walks, const End& end) {
    while (!walks.empty()) {
        for (std::size_t n = 0; n < walks.size();) {
            if (walks[n].step(ground)) {
                ++n;
                continue;
            }
            end(walks[n]);
            walks[n] = walks.back();
            walks.pop_back();
        }
    }
}

}  // namespace

void packedHits(const HeightField& field, const CellGrid& grid, const PackedCones& cones, const RayBlock& rays,
                const std::vector<PackedStart>& starts, HitBlock& hits) {
    const Ground ground{field, grid, cones};
    static thread_local std::vector<Walk> walks;
    walks.clear();
    for (const PackedStart& start : starts) {
        const ViewRay ray = rays[start.ray];
        if (!ray.finite() || GridRay(grid, ray).entersOutside(grid)) {
            hits.set(start.ray, Hit::none(Outcome::Miss));
        } else {
            walks.emplace_back(ground, ray, start.ray, start.from, std::numeric_limits<double>::infinity());
        }
    }
    walkAll(ground, walks, [&](const Walk& walk) { hits.set(walk.number(), walk.hit()); });
}

void packedParts(const HeightField& field, const CellGrid& grid, const PackedCones& cones, const RayBlock& rays,
                 std::vector<PackedPart>& parts) {
    const Ground ground{field, grid, cones};
    static thread_local std::vector<Walk> walks;
    walks.clear();
    for (std::size_t n = 0; n < parts.size(); ++n) {
        walks.emplace_back(ground, rays[parts[n].ray], n, parts[n].from, parts[n].until);
    }
    walkAll(ground, walks, [&](const Walk& walk) {
        PackedPart& part = parts[walk.number()];
        part.ended = !walk.paused();
        part.hit = walk.hit();
        part.x = walk.x(), part.y = walk.y();
    });
}

}  // namespace relief
