#include "panes/profile/profile_drawing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "panes/ray_geometry.h"
#include "panes/slice.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Decision;
using relief::Message;
using relief::MessageId;
using relief::Phase;

constexpr double kVerticalRun = 1e-9;  // in texels; rays with a shorter horizontal run are drawn over their descent
constexpr double kPixelsPerPoint = 2;  // fine enough for print

double runOf(const relief::ViewRay& ray) {
    return std::hypot(ray.a, ray.b);
}

// End of the visible part of the ray: somewhat beyond its hit or end.
double shownLambda(const ProfileSource& source) {
    constexpr double kBehind = 1.15;
    constexpr double kTexelsBehind = 1.5;
    constexpr double kLeast = 1e-9;
    const double end = rayEnd(source.hit, source.steps);
    return std::clamp(std::max(end * kBehind, end + kTexelsBehind / runOf(source.ray)), kLeast, 1.0);
}

SliceRange sliceRange(const ProfileFrame& frame) {
    const Box seen = frame.seen();
    SliceRange range;
    range.from = std::clamp(frame.lambdaAt(seen.x0), 0.0, frame.lambdaEnd);
    range.to = std::clamp(frame.lambdaAt(seen.x1), 0.0, frame.lambdaEnd);
    range.columns = std::max(1.0, seen.width() * frame.zoom * kPixelsPerPoint);
    range.rows = frame.plot.height() / (frame.high - frame.low) * frame.zoom * kPixelsPerPoint;
    return range;
}

// Clips the line to the plot's bottom: lower points are moved onto it.
std::vector<Point> onPlot(const std::vector<Point>& line, const ProfileFrame& frame) {
    std::vector<Point> points;
    Point before;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const Point p = line[k];
        if (k > 0 && (p.y < frame.low) != (before.y < frame.low)) {
            const double w = (frame.low - before.y) / (p.y - before.y);
            points.push_back(frame.at(before.x + w * (p.x - before.x), frame.low));
        }
        points.push_back(frame.at(p.x, std::max(p.y, frame.low)));
        before = p;
    }
    return points;
}

using TexelName = std::tuple<int, std::int64_t, std::int64_t, std::int64_t, std::int64_t>;
TexelName nameOf(const relief::Step& s) {
    return {s.level, s.i, s.j, s.periodX, s.periodY};
}

void addPlateaus(Drawing& drawing, const ProfileSource& source, const relief::PyramidWalk& walk,
                 const ProfileOptions& options, const ProfileFrame& frame) {
    std::set<TexelName> visited;
    if (source.steps != nullptr) {
        for (std::size_t k = 0; k < source.steps->size(); ++k) {
            if (stepShape((*source.steps)[k]) == StepShape::Plateau) visited.insert(nameOf((*source.steps)[k]));
        }
    }
    const SliceRange range = sliceRange(frame);
    std::vector<int> levels = profileLevels(source, options);
    // Drawn from coarse to fine, so that fine levels are on top.
    std::reverse(levels.begin(), levels.end());
    for (const bool knownPass : {false, true}) {
        for (const int level : levels) {
            for (const Plateau& plateau : plateausAlong(walk, source.ray, level, range)) {
                const relief::Step& s = plateau.texel;
                const bool known = !plateau.joined && visited.count(nameOf(s)) > 0;
                if (known != knownPass || s.value < frame.low || !(s.lambdaIn < frame.lambdaEnd)) continue;
                drawing.add({ItemKind::Texel, s.level, s.i, s.j}, Role::Plateau,
                            Polyline{{frame.at(s.lambdaIn, s.value),
                                      frame.at(std::min(s.lambdaOut, frame.lambdaEnd), s.value)}},
                            known ? Emphasis::Normal : Emphasis::Faint, {level, source.maxima->top() + 1});
            }
        }
    }
}

void addLayers(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame) {
    constexpr double kClosest = 5;  // in points
    const int layers = source.layers();
    const double gap = frame.plot.height() / (frame.high - frame.low) / std::max(layers, 1);
    const auto every = std::max<std::int64_t>(1, std::llround(std::ceil(kClosest / (gap * frame.zoom))));
    for (std::int64_t n = 0; n <= layers && layers > 0; n += every) {
        const double height = 1 - static_cast<double>(n) / layers;
        if (height < frame.low) break;
        drawing.add({ItemKind::Layer, 0, n, 0}, Role::Layer,
                    Polyline{{{frame.plot.x0, frame.yAt(height)}, {frame.plot.x1, frame.yAt(height)}}, false},
                    Emphasis::Faint);
    }
}

}  // namespace

bool ProfileSource::atPoints() const {
    return steps != nullptr && std::all_of(steps->begin(), steps->end(), [](const relief::Step& s) {
               return s.as<relief::subject::Point>() != nullptr || s.as<relief::subject::Layer>() != nullptr;
           });
}

int ProfileSource::layers() const {
    if (steps == nullptr) return 0;
    for (const relief::Step& s : *steps) {
        if (const auto* const layer = s.as<relief::subject::Layer>()) return layer->count;
    }
    return 0;
}

StepShape stepShape(const relief::Step& s) {
    if (s.phase == Phase::Refine) return StepShape::Point;
    if (s.trustsMap()) return StepShape::Body;
    const bool ends = s.decision == Decision::Start || s.decision == Decision::Miss || s.decision == Decision::Limit;
    if (ends && s.level == 0) return StepShape::Mark;
    if (s.as<relief::subject::Voxel>() != nullptr || s.as<relief::subject::Sphere>() != nullptr) return StepShape::Mark;
    if (!s.atPoint()) return StepShape::Plateau;
    return s.decision == Decision::Advance ? StepShape::Layer : StepShape::Point;
}

std::vector<int> profileLevels(const ProfileSource& source, const ProfileOptions& options) {
    std::set<int> levels;
    if (options.levels == LevelsShown::All) {
        for (int l = 0; l <= source.maxima->top(); ++l) levels.insert(l);
    } else if (options.levels == LevelsShown::Visited && source.steps != nullptr && !source.atPoints()) {
        for (std::size_t k = 0; k < source.steps->size(); ++k) {
            const relief::Step& step = (*source.steps)[k];
            // The apex of a cone is not the maximum of a texel.
            const bool maximum = step.as<relief::subject::Texel>() != nullptr;
            if (maximum && stepShape(step) == StepShape::Plateau) levels.insert(step.level);
        }
    }
    return {levels.begin(), levels.end()};
}

ProfileFrame profileFrame(const ProfileSource& source, const ProfileOptions& options, double width, double height) {
    constexpr double kHeadroom = 0.07;
    constexpr double kLeastSide = 8;
    ProfileFrame frame;
    frame.whole = frame.visible = {0, 0, width, height};
    frame.tracks = tracksHeight(source, height);
    frame.plot = chart::plotIn(frame.whole, {.top = 16, .right = 14, .bottom = chart::bottomOf(height) + frame.tracks});
    frame.run = runOf(source.ray);
    frame.vertical = frame.run < kVerticalRun;
    frame.lambdaEnd = shownLambda(source);
    if (options.nearRay) frame.low = std::max(0.0, 1 - frame.lambdaEnd * (1 + 2 * kHeadroom));
    frame.high = 1 + kHeadroom * (1 - frame.low);
    if (!options.trueAspect || frame.vertical) return frame;
    // Points per texel that fit in both directions.
    const double upwards = (frame.high - frame.low) * source.field->slabTexels();
    // A ray of a few texels in a deep slab would give a narrow strip, so more of its surroundings is shown.
    if (!options.nearRay && upwards > 0) {
        const double room = upwards * frame.plot.width() / frame.plot.height() / frame.run;
        frame.lambdaEnd = std::min(std::max(frame.lambdaEnd, room), 1.0);
    }
    const double across = frame.lambdaEnd * frame.run;
    const double scale = std::min(frame.plot.width() / across, upwards > 0 ? frame.plot.height() / upwards : across);
    const Point middle = frame.plot.center();
    const double halfX = std::max(across * scale, kLeastSide) / 2;
    const double halfY = std::max(upwards * scale, kLeastSide) / 2;
    frame.plot = {middle.x - halfX, middle.y - halfY, middle.x + halfX, middle.y + halfY};
    return frame;
}

Drawing profileRelief(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    if (frame.seen().empty()) return drawing;
    const relief::PyramidWalk walk(*source.field, source.maxima);
    const SurfaceLine surface = surfaceAlong(walk, source.ray, sliceRange(frame));
    std::vector<Point> line = onPlot(surface.points, frame);
    drawing.add({}, Role::HeightFill, Area{line, frame.plot.y1});
    if (!frame.vertical) addPlateaus(drawing, source, walk, options, frame);
    addLayers(drawing, source, frame);
    drawing.add({ItemKind::Surface, 0, 0, 0}, Role::Surface, Polyline{std::move(line), false});
    if (surface.thinned) {
        drawing.add({}, Role::Legend,
                    Label{.at = {frame.seen().x1 - 3 / frame.zoom, frame.seen().y0 + 2 / frame.zoom},
                          .text = Message(MessageId::DrawThinned),
                          .anchor = Anchor::Right,
                          .size = chart::kTextSize,
                          .offset = {0, 7}});
    }
    return drawing;
}

namespace {

// Adds an entry per level.
void addLevels(LegendRows& rows, const std::vector<int>& levels, int all) {
    constexpr double kShort = 10;
    bool first = true;
    for (const int level : levels) {
        const Message what =
            first ? Message(MessageId::DrawMaxima, {{"level", level}}) : plainText(std::to_string(level));
        rows.line(Role::Plateau, what, {level, all}, kShort);
        first = false;
    }
}

// Adds a single entry for all levels: their colours in a row, "level 0 – 10".
void addLevelRange(LegendRows& rows, const std::vector<int>& levels, int all) {
    if (levels.size() < 2) return addLevels(rows, levels, all);
    constexpr double kPiece = 6;
    const std::string range = std::to_string(levels.front()) + " – " + std::to_string(levels.back());
    const Message what(MessageId::DrawMaxima, {{"level", range}});
    const double length = kPiece * static_cast<double>(levels.size());
    const Point at = rows.place(length + 4 + rows.textRoom(what) + LegendRows::kBetween);
    double x = at.x;
    for (const int level : levels) {
        rows.add(Role::Plateau, Polyline{{{x, at.y}, {x + kPiece, at.y}}}, {level, all});
        x += kPiece;
    }
    rows.text({x + 4, at.y}, what);
}

}  // namespace

Drawing profileLegend(const ProfileSource& source, const ProfileOptions& options, double width,
                      relief::Language language, bool brief) {
    LegendRows rows(width, language);
    rows.line(Role::Surface, Message(MessageId::DrawSurface));
    if (!source.hasRay) return rows.take();
    if (source.point != nullptr) addPointLegend(rows, *source.point);
    rows.line(Role::Ray, Message(MessageId::DrawRay));
    const int levels = source.maxima->top() + 1;
    brief ? addLevelRange(rows, profileLevels(source, options), levels)
          : addLevels(rows, profileLevels(source, options), levels);
    if (source.steps != nullptr && runOf(source.ray) >= kVerticalRun) {
        rows.bodies(*source.steps, source.ray, source.exact);
    }
    if (source.layers() > 0) rows.line(Role::Layer, Message(MessageId::DrawLayer));
    if (source.atPoints()) {
        rows.sign(Role::Sample, Marker{{}, Shape::Dot, 5}, Message(MessageId::DrawSample));
    }
    if (!options.guessing && source.exact.outcome == relief::Outcome::Hit) {
        rows.sign(Role::Hit, Ring{{}, 5.5}, Message(MessageId::DrawExact));
    }
    if (!brief) rows.decisions(decisionsSeen(source.steps, source.hit.outcome == relief::Outcome::Hit));
    return rows.take();
}

ProfileReading profileReading(const ProfileSource& source, const ProfileFrame& frame, Point at) {
    ProfileReading reading;
    reading.inside = source.hasRay && frame.plot.contains(at);
    if (!reading.inside) return reading;
    reading.lambda = frame.lambdaAt(at.x);
    reading.across = frame.across(reading.lambda);
    reading.rayHeight = 1 - reading.lambda;
    reading.onRelief = reading.lambda <= lambdaInside(relief::PyramidWalk(*source.field, source.maxima), source.ray);
    reading.surface = surfaceAt(*source.field, source.ray, reading.lambda);
    const Point texel = RayPath(*source.field, source.ray).at(reading.lambda);
    reading.i = static_cast<std::int64_t>(std::floor(texel.x));
    reading.j = static_cast<std::int64_t>(std::floor(texel.y));
    if (source.steps == nullptr) return reading;
    for (std::size_t k = 0; k < source.steps->size(); ++k) {
        const relief::Step& s = (*source.steps)[k];
        if (s.lambdaIn <= reading.lambda && reading.lambda < s.lambdaOut) reading.step = static_cast<int>(k);
    }
    return reading;
}

}  // namespace reliefui
