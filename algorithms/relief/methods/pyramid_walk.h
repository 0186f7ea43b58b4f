// What walks over the max pyramid in double share: nodes of the hierarchy, the ray's interval in them, the step to a
// neighbour or a child, and the start at the highest point. Only integers are stepped, and positions are not floored on
// the way, so that the walk agrees with the leaf's intervals to the last bit.
#pragma once

#include <array>

#include "relief/describe.h"
#include "relief/leaf.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/maps/mean_levels_map.h"
#include "relief/step_log.h"

namespace relief {

// A node of level l: on each axis the cells [index << l, min((index + 1) << l, cells)) of the period that begins at
// `base`.
struct PyramidNode {
    AxisCell x;
    AxisCell y;
};

class PyramidWalk {
  public:
    PyramidWalk(HeightField field, std::shared_ptr<const MaxPyramidMap> map)
        : PyramidWalk({field, 0, 1, 1}, field, std::move(map)) {}
    // With a base level above 0: rays and hits refer to the whole field, cells and heights to the base level.
    PyramidWalk(BaseField base, HeightField whole, std::shared_ptr<const MaxPyramidMap> map)
        : field_(std::move(base.field)),
          whole_(std::move(whole)),
          map_(std::move(map)),
          grid_(field_),
          base_(base.level),
          perS_(base.perS),
          perT_(base.perT) {
        for (int l = 0; l < map_->pyramid.levels(); ++l) levels_[static_cast<std::size_t>(l)] = &map_->pyramid.level(l);
    }

    // The field that is traced, and the one whose rays are given; they differ only with a base level above 0.
    const HeightField& field() const { return field_; }
    const HeightField& wholeField() const { return whole_; }
    int baseLevel() const { return base_; }
    const std::shared_ptr<const MaxPyramidMap>& map() const { return map_; }

    GridRay gridRay(const ViewRay& ray) const {
        if (base_ == 0) return GridRay(grid_, ray);
        // First reduce to the period of the whole field, whose size need not be a multiple of the base level's texels.
        const bool wraps = field_.address() == Address::Repeat;
        const double s = wraps ? reduceToPeriod(ray.s0, whole_.width()) : ray.s0;
        const double t = wraps ? reduceToPeriod(ray.t0, whole_.height()) : ray.t0;
        return GridRay(grid_, {s * perS_, t * perT_, ray.a * perS_, ray.b * perT_});
    }
    const CellGrid& grid() const { return grid_; }
    int top() const { return map_->top(); }
    double highest() const { return map_->highest(); }
    std::size_t bytes() const { return map_->bytes(); }

    float maximum(int level, const PyramidNode& node) const {
        const FloatImage* const values = levels_[static_cast<std::size_t>(level)];
        if (values == nullptr) [[unlikely]]
            return map_->tiled->maximum(level, node.x.index, node.y.index);
        return (*values)(node.x.index, node.y.index);
    }

    // Lambda at which the ray leaves the node through its x and y border.
    struct Exit {
        double x;
        double y;
        double first() const { return std::min(x, y); }
    };
    Exit exit(const GridRay& ray, int level, const PyramidNode& node) const {
        return {leave(grid_.x, ray.x, level, node.x), leave(grid_.y, ray.y, level, node.y)};
    }

    // Moves to the neighbour on the same level; across a corner to the diagonal one. Returns false if the ray leaves
    // the field (border).
    bool moveOn(const GridRay& ray, int level, Exit exit, PyramidNode& node) const {
        bool inside = true;
        if (exit.x <= exit.y) inside = moveOn(grid_.x, ray.x.side, level, node.x);
        if (exit.y <= exit.x) inside = moveOn(grid_.y, ray.y.side, level, node.y) && inside;
        return inside;
    }

    // The child that contains the ray at, and just after, lambda, which lies within its interval in the node.
    PyramidNode child(const GridRay& ray, int level, const PyramidNode& node, double lambda) const {
        return {child(grid_.x, ray.x, level, node.x, lambda), child(grid_.y, ray.y, level, node.y, lambda)};
    }

    static bool sameParent(const PyramidNode& p, const PyramidNode& q) {
        return p.x.base == q.x.base && p.y.base == q.y.base && (p.x.index >> 1) == (q.x.index >> 1) &&
               (p.y.index >> 1) == (q.y.index >> 1);
    }
    static void toParent(PyramidNode& node) {
        node.x.index >>= 1;
        node.y.index >>= 1;
    }

    // The top node (the whole texture, in one of its periods) that contains the ray at, and just after, lambda.
    // Requires lambda = 0 or a ray within the domain of exactness.
    PyramidNode topNode(const GridRay& ray, double lambda) const {
        return {topNode(grid_.x, ray.x, lambda), topNode(grid_.y, ray.y, lambda)};
    }

    std::optional<double> leaf(const GridRay& ray, const PyramidNode& cell) const {
        return leafHit(field_, grid_, ray, cell.x, cell.y);
    }
    std::uint32_t leafReads() const { return relief::leafReads(field_.surface()); }

    float minimum(const PyramidNode& cell) const {
        return withHeights(field_, [&](const auto& heights) {
            return field_.surface() == Surface::Bilinear
                       ? cellMinimum<Surface::Bilinear>(heights, grid_, cell.x.index, cell.y.index)
                       : cellMinimum<Surface::Columns>(heights, grid_, cell.x.index, cell.y.index);
        });
    }

    // The cell at lambda from its floored position. This is precise enough to check whether the start may be the
    // highest point, since the leaf of the true cell decides.
    PyramidNode roughCell(const GridRay& ray, double lambda) const {
        return {{roughCell(grid_.x, ray.x, lambda), 0}, {roughCell(grid_.y, ray.y, lambda), 0}};
    }

    // Step 3 of the procedure: returns true if the maximum is strictly below the ray over its whole interval, that is,
    // below its lowest point, the exit. The margin covers hits that are within the rounding of the leaf.
    static bool excluded(float maximum, double lambdaOut) {
        return static_cast<double>(maximum) + kExclusionMargin < 1 - lambdaOut;
    }

    // Upper bound of the number of nodes that a line visits, each once. It crosses at most run / 2^l + 2 lines of level
    // l on an axis, and on all levels the seams between periods, which cut their nodes.
    double nodeBound(const GridRay& ray) const {
        const double seams = std::min(ray.cellBound(), periods(grid_.x, ray.x) + periods(grid_.y, ray.y));
        return 2 * ray.cellBound() + (seams + 5) * (top() + 1);
    }
    // Upper bound of the number of records: each node is left once, and may be descended into and climbed out of; the
    // start and the end are added.
    double stepBound(const GridRay& ray) const { return 2 * nodeBound(ray) + 5; }

    Step record(Decision decision, int level, const PyramidNode& node, double in, double out, double value,
                double after) const {
        Step step;
        step.phase = decision == Decision::Start || decision == Decision::Advance ? Phase::Start : Phase::Search;
        step.decision = decision;
        step.level = base_ + level;
        step.i = node.x.index + (level == 0 ? grid_.x.firstName : 0);
        step.j = node.y.index + (level == 0 ? grid_.y.firstName : 0);
        step.periodX = node.x.base / grid_.x.cells;
        step.periodY = node.y.base / grid_.y.cells;
        step.lambdaIn = in;
        step.lambdaOut = out;
        step.value = value;
        step.lambdaAfter = after;
        step.subject = subject::Texel{step.level, step.i, step.j, value, {}};
        return step;
    }
    // Record of a descent into the node at lambda `in`, with the coordinates that double on the level below.
    Step descent(const GridRay& ray, int level, const PyramidNode& node, double in, double out, double value) const {
        Step step = record(Decision::Descend, level, node, in, out, value, in);
        const auto along = [&](const RayAxis& axis, const AxisCell& cell) {
            return std::ldexp(axis.start + in * axis.run - static_cast<double>(cell.base), -level);
        };
        std::get<subject::Texel>(step.subject).ray = {along(ray.x, node.x), along(ray.y, node.y)};
        return step;
    }

    // Record of the return to `level` without a hit, from the parent of `child`, which the ray left at lambda.
    Step ascent(int level, PyramidNode child, double lambda) const {
        toParent(child);
        return record(Decision::Ascend, level, child, lambda, lambda, static_cast<double>(maximum(level, child)),
                      lambda);
    }

  private:
    static double periods(const GridAxis& axis, const RayAxis& ray) {
        return axis.wraps ? std::abs(ray.run) / axis.cells + 1 : 0;
    }

    static double leave(const GridAxis& axis, const RayAxis& ray, int level, AxisCell node) {
        const int low = node.index << level;
        const int high = std::min(low + (1 << level), axis.cells);
        return ray.leave(axis, low, high, node.base);
    }

    static int roughCell(const GridAxis& axis, const RayAxis& ray, double lambda) {
        double x = ray.start + lambda * ray.run;
        if (axis.wraps) x -= std::floor(x / axis.cells) * axis.cells;
        return static_cast<int>(std::clamp(x, 0.0, axis.cells - 1.0));
    }

    static bool moveOn(const GridAxis& axis, int side, int level, AxisCell& node) {
        const int last = (axis.cells - 1) >> level;
        node.index += side;
        if (node.index >= 0 && node.index <= last) return true;
        if (!axis.wraps) return false;
        node.base += side * static_cast<std::int64_t>(axis.cells);
        node.index = side > 0 ? 0 : last;
        return true;
    }

    // Compares lambda with the middle line. Children that do not exist (odd sizes) are never chosen.
    static AxisCell child(const GridAxis& axis, const RayAxis& ray, int level, AxisCell node, double lambda) {
        const int first = node.index << 1;
        const int middle = (first + 1) << (level - 1);
        if (middle >= axis.cells) return {first, node.base};
        bool upper = false;
        if (ray.side == 0) {
            upper = ray.start >= static_cast<double>(node.base + middle);
        } else {
            const double crossing = ray.lambdaAt(static_cast<double>(node.base + middle));
            upper = ray.side > 0 ? lambda >= crossing : lambda < crossing;
        }
        return {first + (upper ? 1 : 0), node.base};
    }

    // Estimated from the position, then corrected by the comparisons that the walk makes.
    static AxisCell topNode(const GridAxis& axis, const RayAxis& ray, double lambda) {
        const std::int64_t startBase = axis.wraps ? ray.startCell(axis).base : 0;
        if (!axis.wraps || ray.side == 0 || lambda <= 0) return {0, startBase};
        const double periods = std::floor((ray.start + lambda * ray.run) / axis.cells);
        std::int64_t base = static_cast<std::int64_t>(periods) * axis.cells;
        while (ray.leave(axis, 0, axis.cells, base) <= lambda && lambda < 1) base += ray.side * axis.cells;
        while (base != startBase && ray.enter(axis, 0, axis.cells, base) > lambda) base -= ray.side * axis.cells;
        return {0, base};
    }

    HeightField field_;
    HeightField whole_;
    std::shared_ptr<const MaxPyramidMap> map_;
    CellGrid grid_;
    int base_;
    double perS_;
    double perT_;
    std::array<const FloatImage*, kMaxLevels> levels_{};  // null: the map is tiled
};

// The option `base` of max-pyramid and max-pyramid-paper.
template <class Options>
OptionField<Options> baseLevelField(std::string Options::*member) {
    return {
        {"base",
         OptionKind::Integer,
         "level",
         0,
         kMaxLevels - 1,
         1,
         {std::string(kBaseAuto)},
         "base level: above 0, this level of the mean pyramid is traced instead of the heights (the top level if there "
         "are fewer); auto: the highest level whose texels are no wider than the narrowest pixel of the view"},
        member};
}

// Step 1 of the procedure, for max-pyramid-paper and hybrid: the ray is advanced to the height of the highest point, at
// `lambda`. If the whole cell there is as high, nothing can occlude the start, and its leaf is tested immediately.
struct PyramidStart {
    double lambda = 0;
    PyramidNode node;                  // the top node at lambda
    std::optional<double> hit;         // lambda of the hit, if the start is the highest point
    PyramidNode cell;                  // the cell of the hit
    Outcome outcome = Outcome::Unset;  // Miss, Limit: the outcome is known already
};

template <class Sink>
PyramidStart pyramidStart(const PyramidWalk& walk, const GridRay& ray, Sink& sink) {
    PyramidStart start;
    const int top = walk.top();
    const double highest = walk.highest();
    start.node = walk.topNode(ray, 0);
    sink.read(1);
    sink.step([&] { return walk.record(Decision::Start, top, start.node, 0, 0, highest, 0); });
    if (ray.entersOutside(walk.grid())) {
        sink.step([&] { return walk.record(Decision::Miss, top, start.node, 0, 0, highest, 0); });
        start.outcome = Outcome::Miss;
        return start;
    }
    // The margin covers hits that are within the rounding of the leaf. A ray beyond the domain of exactness walks from
    // its very start, at most to the step bound.
    if (ray.inDomain()) start.lambda = std::max(0.0, 1 - highest - kExclusionMargin);
    if (start.lambda > 0) {
        if (walk.grid().bounded && walk.exit(ray, top, start.node).first() <= start.lambda) {
            const double out = walk.exit(ray, top, start.node).first();
            sink.step([&] { return walk.record(Decision::Miss, top, start.node, 0, out, highest, out); });
            start.outcome = Outcome::Miss;
            return start;
        }
        const double after = start.lambda;
        sink.step([&] { return walk.record(Decision::Advance, top, start.node, 0, after, highest, after); });
        start.node = walk.topNode(ray, start.lambda);
    }
    sink.read(walk.leafReads());
    if (static_cast<double>(walk.minimum(walk.roughCell(ray, start.lambda))) >= highest) {
        start.cell = start.node;
        for (int level = top; level > 0; --level) start.cell = walk.child(ray, level, start.cell, start.lambda);
        start.hit = walk.leaf(ray, start.cell);
        if (start.hit) {
            sink.startIsHighest();
            sink.step([&] {
                return walk.record(Decision::Hit, 0, start.cell, start.lambda, *start.hit, highest, *start.hit);
            });
        }
    }
    return start;
}

}  // namespace relief
