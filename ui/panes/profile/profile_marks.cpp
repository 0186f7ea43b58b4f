#include <algorithm>
#include <cmath>
#include <optional>

#include "painting/chart.h"
#include "panes/profile/profile_drawing.h"
#include "panes/slice.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Decision;
using relief::Message;
using relief::MessageId;
using relief::Phase;

// Sizes in points.
constexpr double kMarkSize = 8;
constexpr double kMarkHalf = 5.5;
constexpr double kRingHalf = 6.5;
constexpr double kExactHalf = 8;
constexpr double kRow = 12.5;  // distance by which a mark is moved up or down if there is no room
constexpr double kPlatePad = 5;
constexpr double kNumberSize = 0.8;
constexpr double kLevelSize = 0.75;
constexpr std::size_t kMostMarks = 300;
constexpr std::size_t kMostSamples = 200;

// Lambda of a step's mark: the middle of the interval it covers, or the point it examines.
double markLambda(const relief::Step& s, double shown) {
    switch (s.decision) {
        case Decision::Start:
            return s.lambdaIn;
        case Decision::Advance:
            if (s.phase == Phase::Search) return s.lambdaOut;
            break;
        case Decision::Ascend:
        case Decision::Refine:
        case Decision::Hit:
            return s.lambdaAfter;
        case Decision::Miss:
        case Decision::Limit:
            return s.lambdaOut;
        default:
            break;
    }
    // Middle of the visible part.
    return (s.lambdaIn + std::min(s.lambdaOut, shown)) / 2;
}

class Marks {
  public:
    Marks(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame, int step)
        : source_(source),
          options_(options),
          frame_(frame),
          unit_(1 / frame.zoom),
          chosen_(static_cast<std::size_t>(std::max(step, 0))) {
        drawing_.bounds = frame.whole;
        if (known()) chosen_ = std::min(chosen_, source.steps->size() - 1);
    }

    Drawing take() {
        if (known()) {
            stretch();
            addBodies(drawing_, source_, frame_, chosen_);
        }
        ray();
        if (known()) {
            samples();
            marks();
        }
        hit();
        exactHit();
        addGuess(drawing_, source_, options_, frame_);
        levelNames();
        return std::move(drawing_);
    }

  private:
    bool known() const { return source_.steps != nullptr && !source_.steps->empty(); }
    const relief::Step& step(std::size_t k) const { return (*source_.steps)[k]; }
    Emphasis emphasis(std::size_t k) const { return k > chosen_ ? Emphasis::Faint : Emphasis::Normal; }
    bool isHit() const { return source_.hit.outcome == relief::Outcome::Hit; }
    double clamped(double lambda) const { return std::clamp(lambda, 0.0, frame_.lambdaEnd); }
    Point points(Point p) const { return {p.x * frame_.zoom, p.y * frame_.zoom}; }
    Box points(const Box& b) const {
        return {b.x0 * frame_.zoom, b.y0 * frame_.zoom, b.x1 * frame_.zoom, b.y1 * frame_.zoom};
    }

    void stretch() {
        const relief::Step& s = step(chosen_);
        const double from = clamped(s.lambdaIn);
        const double to = clamped(s.lambdaOut);
        const Box band{frame_.xAt(from), frame_.plot.y0, frame_.xAt(to), frame_.plot.y1};
        const Role role = stretchRole(s.decision);
        drawing_.add({}, role, Rectangle{band, true, 0, 1}, Emphasis::Faint);
        for (const double x : {band.x0, band.x1}) {
            drawing_.add({}, role, Polyline{{{x, band.y0}, {x, band.y1}}, false}, Emphasis::Faint);
        }
        const int decimals = relief::distinguishingDecimals(s.lambdaIn, s.lambdaOut);
        drawing_.add({}, Role::Label,
                     Label{.at = {frame_.seen().x1, std::max(frame_.plot.y0, frame_.visible.y0 + 12 * unit_)},
                           .text = Message(MessageId::DrawStretch, {{"step", chosen_ + 1},
                                                                    {"from", relief::fixedText(s.lambdaIn, decimals)},
                                                                    {"to", relief::fixedText(s.lambdaOut, decimals)}}),
                           .anchor = Anchor::Right,
                           .size = chart::kTextSize,
                           .offset = {0, -7}},
                     Emphasis::Strong);
        if (stepShape(s) != StepShape::Plateau || s.value < frame_.low) return;
        // Highlights the maximum on which the decision was based.
        drawing_.add({}, Role::Plateau, Polyline{{frame_.at(from, s.value), frame_.at(to, s.value)}}, Emphasis::Strong,
                     {s.level, source_.maxima->top() + 1});
    }

    // White and black (hit and limit) are not used for the ray's parts, which keep the ray's own colour.
    static Role stretchRole(Decision decision) {
        const Role role = roleOf(decision);
        return role == Role::Hit || role == Role::Limit ? Role::Frame : role;
    }

    void line(double from, double to, Role role, Emphasis strength) {
        if (!(from < to)) return;
        // Not clipped to the plot's bottom: with `nearRay`, the ray never lies below it.
        drawing_.add({ItemKind::Ray, 0, 0, 0}, role, Polyline{{frame_.onRay(from), frame_.onRay(to)}, false}, strength);
    }

    void ray() {
        const double inside = lambdaInside(relief::PyramidWalk(*source_.field, source_.maxima), source_.ray);
        double end = isHit() ? source_.hit.lambda : 1;
        if (!isHit() && known()) end = std::clamp(step(source_.steps->size() - 1).lambdaAfter, 0.0, 1.0);
        end = std::min(end, inside);
        line(clamped(end), frame_.lambdaEnd, Role::Miss, Emphasis::Faint);
        line(0, clamped(end), Role::Ray, Emphasis::Normal);
        if (known()) {
            const relief::Step& s = step(chosen_);
            const Role role = stretchRole(s.decision);
            line(clamped(s.lambdaIn), std::min(clamped(s.lambdaOut), clamped(end)),
                 role == Role::Frame ? Role::Ray : role, Emphasis::Strong);
        }
        // Places along the ray that the names of levels must not cover.
        constexpr double kEvery = 6;
        const Box seen = points(frame_.seen());
        for (double x = seen.x0; x < seen.x1; x += kEvery) {
            const double y = frame_.onRay(frame_.lambdaAt(x * unit_)).y * frame_.zoom;
            rayPlaces_.push_back({x - kEvery / 2, y - 4, x + kEvery / 2, y + 4});
        }
    }

    // The heights that were read, with lines to the ray where they were compared with it.
    void samples() {
        std::size_t drawn = 0;
        const bool single = source_.atPoints() && source_.steps->size() <= 2;
        for (std::size_t k = 0; k < source_.steps->size() && drawn < kMostSamples; ++k) {
            const relief::Step& s = step(k);
            const StepShape shape = stepShape(s);
            const bool read = shape == StepShape::Point || shape == StepShape::Layer;
            if (!read || s.decision == Decision::Miss || s.decision == Decision::Limit) continue;
            // A method that reads a single height reads it where the ray enters.
            const double at = single ? 0 : (s.decision == Decision::Refine ? s.lambdaAfter : s.lambdaOut);
            const double height =
                s.decision == Decision::Refine ? surfaceAt(*source_.field, source_.ray, s.lambdaAfter) : s.value;
            if (at > frame_.lambdaEnd || height < frame_.low) continue;
            const Point dot = frame_.at(at, height);
            if (!frame_.visible.contains(dot)) continue;
            if (single) {
                drawing_.add({}, Role::Sample, Polyline{{dot, frame_.at(clamped(s.lambdaOut), height)}, false},
                             Emphasis::Strong);
            } else {
                drawing_.add({}, Role::Sample, Polyline{{dot, frame_.onRay(at)}, false}, Emphasis::Faint);
            }
            if (shape == StepShape::Layer) {
                drawing_.add({}, Role::Layer, Polyline{{{frame_.plot.x0, frame_.onRay(at).y}, frame_.onRay(at)}, false},
                             Emphasis::Faint);
            }
            drawing_.add(stepId(k), Role::Sample, Marker{dot, Shape::Dot, 5}, emphasis(k));
            ++drawn;
        }
    }

    // Places the chosen step's mark first, then the others in order; a mark without room on the ray is moved above it.
    void marks() {
        hitNumber();
        mark(chosen_, true);
        std::size_t placed = 0;
        for (std::size_t k = 0; k < source_.steps->size() && placed < kMostMarks; ++k) {
            if (k != chosen_ && mark(k, false)) ++placed;
        }
    }

    struct Unit {
        Point center;  // position of the mark, in points
        Box box;       // including its number
        bool numbered = true;
    };
    static Unit unit(Point center, double numberWidth) {
        return {center,
                {center.x - kMarkHalf, center.y - kMarkHalf, center.x + kMarkHalf + numberWidth, center.y + kMarkHalf},
                numberWidth > 0};
    }

    // Offsets in rows and columns to try for a mark, in order of preference: near before far, above before below or
    // sideways.
    static const std::vector<std::pair<int, int>>& shifts() {
        static const auto kShifts = [] {
            constexpr int kUp = 9;
            constexpr int kDown = 4;
            constexpr int kSideways = 3;
            std::vector<std::pair<double, std::pair<int, int>>> all;
            for (int row = -kUp; row <= kDown; ++row) {
                for (int column = -kSideways; column <= kSideways; ++column) {
                    const double upwards = row > 0 ? 6.0 * row : -row;
                    all.push_back({upwards + (column < 0 ? -5.6 : 5.5) * column, {row, column}});
                }
            }
            std::sort(all.begin(), all.end());
            std::vector<std::pair<int, int>> shifts;
            for (const auto& [cost, shift] : all) shifts.push_back(shift);
            return shifts;
        }();
        return kShifts;
    }

    // Right edge of the visible part, in points.
    double rim() const { return points(frame_.visible).x1; }

    std::optional<Unit> room(Point anchor, double numberWidth) const {
        const Box seen = points(frame_.seen());
        const double columnWidth = 2 * kMarkHalf + numberWidth + 1;
        for (const auto& [row, column] : shifts()) {
            const Unit next = unit({anchor.x + column * columnWidth, anchor.y + row * kRow}, numberWidth);
            const bool moved = row != 0 || column != 0;
            const bool inside =
                next.box.x0 >= seen.x0 && next.box.y0 >= seen.y0 && next.box.x1 <= seen.x1 && next.box.y1 <= seen.y1;
            // A mark at its own place may extend beyond the plot, but its number must stay inside the drawing.
            const bool whole = moved ? inside : next.box.x1 <= rim();
            if (whole && places_.free(next.box)) return next;
        }
        const Unit bare = unit(anchor, 0);
        if (places_.free(bare.box)) return bare;
        return std::nullopt;
    }

    // The hit has a ring instead of a mark; only its number is placed here.
    void hitNumber() {
        if (!isHit() || source_.hit.lambda > frame_.lambdaEnd) return;
        const Point on = frame_.onRay(source_.hit.lambda);
        const Point at = points(on);
        Box box{at.x - kRingHalf, at.y - kRingHalf, at.x + kRingHalf, at.y + kRingHalf};
        const std::size_t k = source_.steps->size() - 1;
        if (step(k).decision == Decision::Hit) {
            const std::string number = std::to_string(k + 1);
            // Left of the ring if it would be cut off at the right.
            const double width = numberWidth(number) + 1;
            const bool left = box.x1 + width > rim();
            (left ? box.x0 : box.x1) += left ? -width : width;
            drawing_.add({}, Role::Hit,
                         Label{.at = on,
                               .text = plainText(number),
                               .anchor = left ? Anchor::Right : Anchor::Left,
                               .size = kNumberSize,
                               .offset = {left ? -kRingHalf - 1 : kRingHalf + 1, 0},
                               .plate = true},
                         k == chosen_ ? Emphasis::Strong : emphasis(k));
            if (k == chosen_) drawing_.add(stepId(k), Role::Highlight, Rectangle{onDrawing(box), false, -1.5, 0});
        }
        places_.take(box);
    }
    static double numberWidth(const std::string& number) { return kPlatePad + textWidth(number, kNumberSize); }
    Box onDrawing(const Box& b) const { return {b.x0 * unit_, b.y0 * unit_, b.x1 * unit_, b.y1 * unit_}; }

    bool mark(std::size_t k, bool always) {
        const relief::Step& s = step(k);
        if (s.decision == Decision::Hit && isHit()) return false;  // drawn as the ring
        const StepBody body = stepBody(s);
        const double lambda = body ? body.lambda : markLambda(s, frame_.lambdaEnd);
        if (!(lambda <= frame_.lambdaEnd)) return false;
        const Point on = frame_.onRay(lambda);
        if (!frame_.visible.contains(on)) return false;
        const std::string number = std::to_string(k + 1);
        const double width = numberWidth(number);
        std::optional<Unit> place = room(points(on), width);
        if (!place && always) place = unit(points(on), width);
        if (!place) return false;
        places_.take(place->box);
        const Point center{place->center.x * unit_, place->center.y * unit_};
        const Role role = roleOf(s.decision);
        if (!(center == on)) drawing_.add({}, Role::Frame, Polyline{{on, center}, false});
        if (k == chosen_) {
            drawing_.add(stepId(k), Role::Highlight, Rectangle{onDrawing(place->box), false, -1.5, 0});
        }
        drawing_.add(stepId(k), role, Marker{center, shapeOf(s.decision), kMarkSize}, emphasis(k));
        if (!place->numbered) return true;
        drawing_.add({}, role,
                     Label{.at = center,
                           .text = plainText(number),
                           .size = kNumberSize,
                           .offset = {kMarkHalf, 0},
                           .plate = true,
                           .yields = !always},
                     k == chosen_ ? Emphasis::Strong : emphasis(k));
        return true;
    }

    void hit() {
        if (!isHit() || source_.hit.lambda > frame_.lambdaEnd) return;
        drawing_.add({ItemKind::Hit, 0, 0, 0}, Role::Hit, Ring{frame_.onRay(source_.hit.lambda), 5});
    }

    // The exact hit, with the distance of the method's answer from it if they differ.
    void exactHit() {
        const relief::Hit& exact = source_.exact;
        if (options_.guessing || exact.outcome != relief::Outcome::Hit || exact.lambda > frame_.lambdaEnd) return;
        const Point at = frame_.onRay(exact.lambda);
        drawing_.add({ItemKind::Hit, -1, 0, 0}, Role::Hit, Ring{at, kExactHalf});
        const double off = relief::answerError(source_.hit, exact, source_.ray);
        if (off <= relief::kSameAnswer) return;
        constexpr int kDigits = 2;
        const Message words = std::isfinite(off)
                                  ? Message(MessageId::DrawExactOff, {{"texels", relief::numberText(off, kDigits)}})
                                  : Message(MessageId::DrawExact);
        // Left of the ring if it would be cut off at the right, above it if on both sides.
        const double width = kExactHalf + 3 + kPlatePad + chart::widthOf(words) * kNumberSize / chart::kTextSize;
        const bool right = points(at).x + width <= rim();
        const bool left = points(at).x - width >= points(frame_.visible).x0;
        drawing_.add({}, Role::Label,
                     Label{.at = at,
                           .text = words,
                           .anchor = right  ? Anchor::Left
                                     : left ? Anchor::Right
                                            : Anchor::Bottom,
                           .size = kNumberSize,
                           .offset = right  ? Point{kExactHalf + 3, 0}
                                     : left ? Point{-kExactHalf - 3, 0}
                                            : Point{0, -kExactHalf - 3},
                           .plate = true,
                           .yields = true},
                     Emphasis::Strong);
    }

    // Adds each level's name once, next to one of its plateaus, clear of marks, lines and the ray.
    void levelNames() {
        if (frame_.vertical || frame_.seen().empty()) return;
        const Box seen = points(frame_.seen());
        SliceRange range;
        range.from = clamped(frame_.lambdaAt(frame_.seen().x0));
        range.to = clamped(frame_.lambdaAt(frame_.seen().x1));
        range.columns = std::max(1.0, seen.width());
        const relief::PyramidWalk walk(*source_.field, source_.maxima);
        constexpr std::size_t kMost = 40;  // only the longest plateaus are tried, which have the most room
        std::vector<std::pair<int, std::vector<Plateau>>> levels;
        for (const int level : profileLevels(source_, options_)) {
            std::vector<Plateau> plateaus = plateausAlong(walk, source_.ray, level, range);
            std::stable_sort(plateaus.begin(), plateaus.end(), [](const Plateau& a, const Plateau& b) {
                return a.texel.lambdaOut - a.texel.lambdaIn > b.texel.lambdaOut - b.texel.lambdaIn;
            });
            plateaus.resize(std::min(plateaus.size(), kMost));
            for (const Plateau& plateau : plateaus) linePlaces_.push_back(lineBox(plateau.texel));
            levels.emplace_back(level, std::move(plateaus));
        }
        for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
            const Message name(MessageId::DrawLevelName, {{"level", level->first}});
            for (const Plateau& plateau : level->second) {
                if (nameLevel(plateau, name, seen)) break;
            }
        }
    }

    Box lineBox(const relief::Step& s) const {
        const double y = frame_.yAt(s.value) * frame_.zoom;
        return {frame_.xAt(clamped(s.lambdaIn)) * frame_.zoom, y - 1.5, frame_.xAt(clamped(s.lambdaOut)) * frame_.zoom,
                y + 1.5};
    }

    bool nameLevel(const Plateau& plateau, const Message& name, const Box& seen) {
        const double width = chart::widthOf(name) * kLevelSize / chart::kTextSize;
        constexpr double kHeight = 9;
        const Box line = lineBox(plateau.texel);
        const double x0 = std::max(line.x0, seen.x0);
        const double x1 = std::min(line.x1, seen.x1);
        for (const double x : {x1 - width - 2, (x0 + x1 - width) / 2, x0 + 3}) {
            for (const double top : {line.y0 - kHeight - 0.5, line.y1 + 0.5}) {
                const Box box{x, top, x + width, top + kHeight};
                const auto hides = [&](const Box& other) { return other.overlaps(box); };
                const bool inside = x >= seen.x0 && box.x1 <= seen.x1 && top >= seen.y0 && box.y1 <= seen.y1;
                if (!inside || !places_.free(box) || std::any_of(rayPlaces_.begin(), rayPlaces_.end(), hides) ||
                    std::any_of(linePlaces_.begin(), linePlaces_.end(), hides)) {
                    continue;
                }
                places_.take(box);
                drawing_.add({ItemKind::Level, plateau.texel.level, 0, 0}, Role::Label,
                             Label{.at = {x * unit_, (top + kHeight / 2) * unit_},
                                   .text = name,
                                   .size = kLevelSize,
                                   .yields = true});
                return true;
            }
        }
        return false;
    }

    const ProfileSource& source_;
    const ProfileOptions& options_;
    const ProfileFrame& frame_;
    double unit_;  // drawing units per point
    std::size_t chosen_;
    LabelRoom places_;  // in points
    std::vector<Box> rayPlaces_;
    std::vector<Box> linePlaces_;
    Drawing drawing_;
};

}  // namespace

Drawing profileMarks(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame, int step) {
    if (!source.hasRay) return {};
    Drawing marks = Marks(source, options, frame, step).take();
    if (source.point != nullptr) {
        if (const auto plane = pointPlane(*source.point, source, frame)) addPointMarks(marks, *source.point, *plane);
    }
    addTracks(marks, source, frame, step);
    return marks;
}

}  // namespace reliefui
