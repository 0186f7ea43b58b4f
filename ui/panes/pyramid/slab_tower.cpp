#include "panes/pyramid/slab_tower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "painting/view_map.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

using Place = Turntable::Place;

constexpr int kMostSlabs = 128;              // per side of a level
constexpr std::size_t kMostPathSteps = 400;  // number of steps before and after the chosen one
constexpr double kHighest = 0.15;            // largest height range, relative to the longer side of the ground
// smallest distance between the bottoms of two levels, relative to the height range
constexpr double kClearance = 1.15;
constexpr double kBeside = 0.25;  // distance between pyramids, relative to their width
// Share of each level that is visible below the next one: if only some slabs are drawn, and if all are.
constexpr double kSeenOfFew = 0.6;
constexpr double kSeenOfAll = 0.9;
constexpr double kTurnedAway = 0.3;  // in radians: angle by which the ray points away from the viewer

bool covers(const std::vector<Box>& boxes, Point point) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.contains(point); });
}

// Rounds to whole texels, or to tenths if that is too coarse.
double rounded(double texels) {
    return texels >= 4 ? std::ceil(texels) : std::ceil(10 * texels) / 10;
}

}  // namespace

SlabTower::SlabTower(const PyramidParts& parts) : parts_(&parts) {
    if (parts.parts.empty()) return;
    const PyramidSource& source = part(0).source;
    thick_ = source.field->slabTexels();
    levels_ = static_cast<int>(blocksOf(0).size());
    const double widest = std::max(domain(0).width(), domain(0).height());
    while (top_ + 1 < levels_ && std::ldexp(4.0, top_) <= widest) ++top_;
    if (source.hasRay && std::hypot(source.ray.a, source.ray.b) > 0) {
        const double turn = std::atan2(-source.ray.b, source.ray.a) + std::numbers::pi / 2 + kTurnedAway;
        viewDirection_ = {std::cos(turn), std::sin(turn)};
    }
    // The pyramids are arranged from left to right on the screen: right of the direction (x, y) is (y, -x).
    const Point right{viewDirection_.y, -viewDirection_.x};
    double offset = 0;
    for (std::size_t n = 0; n < parts.parts.size(); ++n) {
        offsets_.push_back({offset * right.x - domain(n).x0, offset * right.y + domain(n).y0});
        const double wide = std::abs(right.x) * domain(n).width() + std::abs(right.y) * domain(n).height();
        offset += wide * (1 + kBeside);
    }
    bool all = true;
    for (std::size_t n = 0; n < parts.parts.size(); ++n) {
        // Texels that the steps examine, by level. Those that a step descends into determine the slabs of the level
        // below.
        std::vector<std::vector<Box>> open(static_cast<std::size_t>(levels_) + 1);
        bool walked = false;
        const PyramidSource& from = part(n).source;
        if (from.hasRay && from.overCells && from.steps != nullptr) {
            for (const relief::Step& step : *from.steps) {
                if (step.level < 0 || step.level >= levels_ || step.as<relief::subject::Texel>() == nullptr) continue;
                walked = walked || step.level > 0;
                for (const Box& box : boxesOf(n, step)) {
                    std::vector<Box>& of = open[static_cast<std::size_t>(step.level)];
                    if (std::find(of.begin(), of.end(), box) == of.end()) of.push_back(box);
                }
            }
        }
        all = all && !walked;
        for (int level = 0; level <= top_; ++level) {
            std::vector<Box> here = open[static_cast<std::size_t>(level)];
            for (const relief::Step& step : walked ? *from.steps : std::vector<relief::Step>{}) {
                if (step.level != level + 1 || step.decision != relief::Decision::Descend) continue;
                for (const Box& box : boxesOf(n, step)) here.push_back(box);
            }
            addSlabs(n, level, here, !walked || level == 0);
        }
    }
    chooseScale(!all);
    for (Slab& slab : slabs_) {
        slab.foot = foot(slab.level);
        slab.top = heightOver(slab.level, static_cast<double>(slab.value));
    }
}

int SlabTower::drawnAs(std::size_t n, int level) const {
    const double side = std::max(domain(n).width(), domain(n).height());
    int drawn = level;
    while (drawn + 1 < levels_ && side > kMostSlabs * std::ldexp(1.0, drawn)) ++drawn;
    return drawn;
}

void SlabTower::addSlabs(std::size_t n, int level, const std::vector<Box>& open, bool all) {
    const int drawn = drawnAs(n, level);
    for (const Item& item : part(n).picture.levels.items) {
        const auto* const cells = std::get_if<Cells>(&item.primitive);
        if (cells == nullptr || item.id.level != drawn || cells->clip.empty()) continue;
        const CellRange range = visibleCells(*cells, cells->clip);
        for (int j = range.j0; j < range.j1; ++j) {
            for (int i = range.i0; i < range.i1; ++i) {
                const Box ground = blocksOf(n)[static_cast<std::size_t>(drawn)].toTexels(cellBox(*cells, i, j));
                if (ground.width() <= 0 || ground.height() <= 0) continue;
                if (!all && !covers(open, ground.center())) continue;
                slabs_.push_back({n, level, ground, 0, 0, (*cells->values)(i, j)});
            }
        }
    }
}

// Scales the heights by halving until a level's height range is small compared with its ground.
void SlabTower::chooseScale(bool few) {
    float low = 1;
    float high = 0;
    for (const Slab& slab : slabs_) {
        low = std::min(low, slab.value);
        high = std::max(high, slab.value);
    }
    low_ = static_cast<double>(low);
    double highest = static_cast<double>(high);
    for (std::size_t n = 0; n < parts_->parts.size(); ++n) {
        if (!part(n).source.hasRay) continue;
        low_ = std::min(low_, 1 - rayEnd(part(n).source));
        highest = 1;  // height of the ray's entry
    }
    const double most = kHighest * std::max(domain(0).width(), domain(0).height());
    const double range = std::max(highest - low_, 0.0) * thick_;
    while (range * factor_ > most) factor_ /= 2;
    // The levels' distance is such that the visible share of the level below is not covered, seen at the camera's
    // elevation.
    const double deep =
        std::abs(viewDirection_.x) * domain(0).width() + std::abs(viewDirection_.y) * domain(0).height();
    const double shown = (few ? kSeenOfFew : kSeenOfAll) * deep * std::tan(Turntable::kElevation);
    apart_ = rounded(std::max(shown, kClearance * range * factor_));
}

std::vector<Box> SlabTower::boxesOf(std::size_t n, const relief::Step& step) const {
    return wrapped(stepBox(*part(n).source.field, step, part(n).source.baseLevel), domain(n), part(n).picture.wraps);
}

std::vector<SlabMark> SlabTower::marks(std::size_t n, std::size_t chosen) const {
    std::vector<SlabMark> marks;
    const PyramidSource& source = part(n).source;
    if (!source.hasRay || !source.overCells || source.steps == nullptr) return marks;
    const std::vector<relief::Step>& steps = *source.steps;
    const std::size_t first = chosen > kMostPathSteps ? chosen - kMostPathSteps : 0;
    std::map<std::tuple<int, double, double>, std::size_t> known;
    for (std::size_t k = first; k < std::min(steps.size(), chosen + kMostPathSteps); ++k) {
        if (steps[k].level < 0 || steps[k].level > top_) continue;
        for (const Box& box : boxesOf(n, steps[k])) {
            const auto [at, added] = known.try_emplace({steps[k].level, box.x0, box.y0}, marks.size());
            if (added) {
                double z = foot(steps[k].level);
                for (const Slab& slab : slabs_) {
                    if (slab.part == n && slab.level == steps[k].level && slab.ground.contains(box.center()))
                        z = slab.top;
                }
                marks.push_back({box, z, k, k > chosen, false});
            }
            SlabMark& mark = marks[at->second];
            if (k <= chosen) mark.step = k;
            mark.chosen = mark.chosen || k == chosen;
        }
    }
    return marks;
}

namespace {

// A visible piece of the ray, and its lambdas.
struct Piece {
    Segment seen;
    double from = 0;
    double to = 0;
};

std::vector<Piece> piecesOf(const RayPath& path, double from, double to, const Box& domain, bool wraps) {
    std::vector<Piece> pieces;
    // Along a straight line the 1-norm is proportional to the length, and avoids a square root.
    const double pace = std::abs(path.run.x) + std::abs(path.run.y);
    const auto far = [](Point a, Point b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y); };
    double lambda = from;
    for (const Segment& seen : wrapped(Segment{path.at(from), path.at(to)}, domain, wraps)) {
        if (!(pace > 0)) {
            pieces.push_back({seen, from, to});
        } else if (wraps) {  // consecutive pieces, none cut off
            const double next = lambda + std::copysign(far(seen.first, seen.second) / pace, to - from);
            pieces.push_back({seen, lambda, next});
            lambda = next;
        } else {
            pieces.push_back({seen, far(seen.first, path.start) / pace, far(seen.second, path.start) / pace});
        }
    }
    return pieces;
}

}  // namespace

std::vector<SlabStretch> SlabTower::rayPath(std::size_t n, std::size_t chosen) const {
    std::vector<SlabStretch> rayPath;
    const PyramidSource& source = part(n).source;
    if (!source.hasRay || source.steps == nullptr) return rayPath;
    const std::vector<relief::Step>& steps = *source.steps;
    const RayPath path(*source.field, source.ray);
    const bool wraps = part(n).picture.wraps;
    const auto place = [&](Point texel, double lambda, int level) {
        return at(n, texel, heightOver(level, 1 - lambda));
    };
    const relief::Step* last = nullptr;
    const std::size_t first = chosen > kMostPathSteps ? chosen - kMostPathSteps : 0;
    for (std::size_t k = first; k < std::min(steps.size(), chosen + kMostPathSteps); ++k) {
        const relief::Step& step = steps[k];
        if (step.level < 0 || step.level >= levels_ || !std::isfinite(step.lambdaIn)) continue;
        const double in = std::clamp(step.lambdaIn, 0.0, 1.0);
        const double after = std::isfinite(step.lambdaAfter) ? std::clamp(step.lambdaAfter, 0.0, 1.0) : in;
        // Between levels, the path is vertical.
        if (last != nullptr && last->level != step.level) {
            const auto here = piecesOf(path, in, in, domain(n), wraps);
            if (!here.empty()) {
                const Point texel = here.front().seen.first;
                rayPath.push_back(
                    {place(texel, in, last->level), place(texel, in, step.level), roleOf(last->decision), k > chosen});
            }
        }
        for (const Piece& piece : piecesOf(path, in, after, domain(n), wraps)) {
            rayPath.push_back({place(piece.seen.first, piece.from, step.level),
                               place(piece.seen.second, piece.to, step.level),
                               k == chosen ? roleOf(step.decision) : Role::Ray, k > chosen});
        }
        last = &step;
    }
    return rayPath;
}

std::optional<Place> SlabTower::end(std::size_t n) const {
    const PyramidSource& source = part(n).source;
    if (!source.hasRay || source.hit.outcome != relief::Outcome::Hit) return std::nullopt;
    const RayPath path(*source.field, source.ray);
    const double lambda = source.hit.lambda;
    const auto here = piecesOf(path, lambda, lambda, domain(n), part(n).picture.wraps);
    if (here.empty()) return std::nullopt;
    return at(n, here.front().seen.first, heightOver(0, 1 - lambda));
}

SlabTower::Intersection SlabTower::intersect(const Place& from, const Place& to) const {
    Intersection found;
    double nearest = 2;
    for (const Slab& slab : slabs_) {
        const auto [x, y] = offsets_[slab.part];
        const std::array<std::array<double, 2>, 3> sides{{{slab.ground.x0 + x, slab.ground.x1 + x},
                                                          {y - slab.ground.y1, y - slab.ground.y0},
                                                          {std::min(slab.foot, slab.top), slab.top}}};
        double in = 0;
        double out = 1;
        for (std::size_t c = 0; c < 3; ++c) {
            const double run = to[c] - from[c];
            const double a = (sides[c][0] - from[c]) / run;
            const double b = (sides[c][1] - from[c]) / run;
            if (run == 0 && (from[c] < sides[c][0] || from[c] > sides[c][1])) out = -1;
            if (run == 0) continue;
            in = std::max(in, std::min(a, b));
            out = std::min(out, std::max(a, b));
        }
        if (in > out || in >= nearest) continue;
        nearest = in;
        // Tolerance for points on the side of a slab.
        constexpr double kInside = 1e-3;
        const Box within = slab.ground.grown(-kInside * std::min(slab.ground.width(), slab.ground.height()));
        found.slab = &slab;
        found.texel = {std::clamp(from[0] + in * (to[0] - from[0]) - x, within.x0, within.x1),
                       std::clamp(y - (from[1] + in * (to[1] - from[1])), within.y0, within.y1)};
    }
    return found;
}

}  // namespace reliefui
