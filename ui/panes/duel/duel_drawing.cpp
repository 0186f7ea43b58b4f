#include "panes/duel/duel_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "painting/text_width.h"

namespace reliefui {

namespace {

using relief::Departure;
using relief::Message;
using relief::MessageId;

// Sizes in points.
constexpr double kTrack = 26;
constexpr double kAboveTracks = 4;
constexpr double kBelowTracks = 6;  // for the lower part of the title below the last track
constexpr double kMark = 6;
constexpr double kNow = 11;
constexpr double kRing = 6;
constexpr double kLeastGap = 4;  // between marks
constexpr double kNameSize = 0.9;
constexpr double kNumberSize = 0.8;
constexpr double kLeastNameSize = 0.65;
constexpr double kNameGap = 8;       // between a name and its track
constexpr double kMostNames = 0.3;   // as a share of the width
constexpr double kLeastWidth = 200;  // with names next to the tracks
constexpr double kMostTracks = 0.5;  // as a share of the height; the tracks remain distinguishable
constexpr double kLeastTrack = 13;

// Common text size of all tracks' names; smaller if the longest one does not fit.
double nameSize(const DuelSource& source, double width) {
    double longest = 1;
    for (const relief::DuelRun& run : *source.runs) longest = std::max(longest, textWidth(run.name, 1));
    return std::clamp((kMostNames * width - kNameGap) / longest, kLeastNameSize, kNameSize);
}

// Width of the tracks' names, left of the tracks.
double namesWidth(const DuelSource& source, double width) {
    if (width < kLeastWidth) return 0;
    double longest = 0;
    const double size = nameSize(source, width);
    for (const relief::DuelRun& run : *source.runs) longest = std::max(longest, textWidth(run.name, size));
    return longest + kNameGap + 2;
}

double tracksHeight(const DuelSource& source, double height) {
    const auto count = static_cast<double>(std::max<std::size_t>(source.count(), 1));
    const double room = kMostTracks * height - kAboveTracks - kBelowTracks;
    return kAboveTracks + count * std::clamp(room / count, kLeastTrack, kTrack) + kBelowTracks;
}

LevelTint tintOf(std::size_t run) {
    return {static_cast<int>(run), 4};
}

class DuelMarks {
  public:
    DuelMarks(const DuelSource& source, const ProfileFrame& frame, const std::vector<std::size_t>& moment)
        : source_(source), frame_(frame), moment_(moment), unit_(1 / frame.zoom) {
        drawing_.bounds = frame.whole;
    }

    Drawing take() {
        drawing_.add({ItemKind::Ray, 0, 0, 0}, Role::Ray,
                     Polyline{{frame_.onRay(0), frame_.onRay(frame_.lambdaEnd)}, false});
        for (std::size_t r = 0; r < source_.count(); ++r) track(r);
        exactHit();
        for (std::size_t r = 0; r < source_.count(); ++r) inSlice(r);
        return std::move(drawing_);
    }

  private:
    const relief::DuelRun& run(std::size_t r) const { return (*source_.runs)[r]; }
    const relief::Judgement& judgement(std::size_t r) const { return (*source_.judgements)[r]; }
    std::size_t now(std::size_t r) const { return r < moment_.size() ? moment_[r] : 0; }
    double xAt(double lambda) const { return frame_.xAt(std::clamp(lambda, 0.0, frame_.lambdaEnd)); }
    // Distance of the tracks above the plot; smaller if there is little room.
    double spacing() const {
        const double room = frame_.plot.y0 - kTopRoom - kAboveTracks - kBelowTracks;
        return std::clamp(room / static_cast<double>(std::max<std::size_t>(source_.count(), 1)), 1.0, kTrack);
    }
    double trackY(std::size_t r) const { return kAboveTracks + (static_cast<double>(r) + 0.5) * spacing(); }
    void add(std::size_t r, ItemId id, Primitive primitive, Emphasis emphasis = Emphasis::Normal) {
        drawing_.add(id, Role::Series, std::move(primitive), emphasis, tintOf(r));
    }

    void track(std::size_t r) {
        const double y = trackY(r);
        drawing_.add({}, Role::Grid, Polyline{{{xAt(0), y}, {xAt(frame_.lambdaEnd), y}}, false});
        name(r, y);  // first, because the text along the track yields to it
        departure(r, y);
        const auto& steps = run(r).steps;
        const std::size_t current = now(r);
        double last = -HUGE_VAL;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const double x = xAt(duelPlace(steps[k]));
            if (duelPlace(steps[k]) > frame_.lambdaEnd) break;
            if (k == current || (x - last) * frame_.zoom < kLeastGap) continue;
            last = x;
            add(r, stepId(k, static_cast<int>(r)), Marker{{x, y}, runShape(r), kMark},
                k > current ? Emphasis::Faint : Emphasis::Normal);
        }
        if (run(r).hit.outcome == relief::Outcome::Hit && run(r).hit.lambda <= frame_.lambdaEnd) {
            drawing_.add({ItemKind::Hit, static_cast<int>(r), 0, 0}, Role::Hit,
                         Ring{{xAt(run(r).hit.lambda), y}, kRing});
        }
        if (current < steps.size()) {
            const double x = xAt(duelPlace(steps[current]));
            add(r, stepId(current, static_cast<int>(r)), Marker{{x, y}, runShape(r), kNow}, Emphasis::Strong);
            // Above the ring if the step is the hit.
            const bool hit = steps[current].decision == relief::Decision::Hit;
            text({x, y}, plainText(std::to_string(current + 1)), Anchor::Bottom, {0, hit ? -kRing - 1 : 1 - kNow / 2},
                 kNumberSize);
        }
    }

    // Left of the track, or at its end if there is no room.
    void name(std::size_t r, double y) {
        const bool beside = frame_.plot.x0 > chart::kLeft;
        const double x = beside ? frame_.plot.x0 : frame_.plot.x1;
        text({x, y}, plainText(run(r).name), Anchor::Right, {beside ? -kNameGap : -2.0, beside ? 0 : -spacing() / 4},
             beside ? nameSize(source_, frame_.whole.width()) : kNameSize);
    }

    // Marks the section of the ray that the run's first fault concerns.
    void departure(std::size_t r, double y) {
        const relief::Judgement& fault = judgement(r);
        if (fault.kind == Departure::None) return;
        const double half = 0.26 * spacing() * unit_;
        const Box box{xAt(fault.from), y - half, xAt(fault.to), y + half};
        const bool first = source_.first == r;
        drawing_.add({}, Role::Overshoot, Rectangle{box, true, 0, 3}, Emphasis::Faint);
        drawing_.add({}, Role::Overshoot, Rectangle{box, false, 0, 3}, first ? Emphasis::Strong : Emphasis::Normal);
        // Tracks that are close together leave no room for the title; the text below the drawing names the fault as
        // well.
        constexpr double kLeastForTitle = 20;
        if (spacing() < kLeastForTitle) return;
        // Keeps the title clear of the tracks' names and within the plot.
        constexpr double kHalfTitle = 45;
        const double low = frame_.plot.x0 + kHalfTitle * unit_;
        const double middle =
            std::clamp((box.x0 + box.x1) / 2, low, std::max(low, frame_.plot.x1 - kHalfTitle * unit_));
        text({middle, box.y1}, relief::departureTitle(fault), Anchor::Top, {0, 1.5}, kNumberSize);
    }

    void exactHit() {
        if (source_.exact.outcome != relief::Outcome::Hit) return;
        const Point at = frame_.onRay(source_.exact.lambda);
        const double top = trackY(0) - kTrack / 2;
        drawing_.add({}, Role::Highlight, Polyline{{{at.x, top}, at}, false}, Emphasis::Faint);
        drawing_.add({ItemKind::Hit, -1, 0, 0}, Role::Hit, Ring{at, 7});
    }

    // Marks the run's current position and its answer on the ray.
    void inSlice(std::size_t r) {
        const auto& steps = run(r).steps;
        if (now(r) < steps.size()) {
            const double lambda = std::clamp(duelPlace(steps[now(r)]), 0.0, frame_.lambdaEnd);
            add(r, stepId(now(r), static_cast<int>(r)), Marker{frame_.onRay(lambda), runShape(r), kNow},
                Emphasis::Strong);
        }
        const bool ended = now(r) + 1 >= steps.size();
        if (!ended || run(r).hit.outcome != relief::Outcome::Hit) return;
        const Point at = frame_.onRay(std::clamp(run(r).hit.lambda, 0.0, frame_.lambdaEnd));
        add(r, {ItemKind::Hit, static_cast<int>(r), 0, 0}, Ring{at, 4.5 + 2.5 * static_cast<double>(r)});
    }

    void text(Point at, Message message, Anchor anchor, Point offset, double size) {
        drawing_.add({}, Role::Label,
                     Label{.at = at,
                           .text = std::move(message),
                           .anchor = anchor,
                           .size = size,
                           .offset = offset,
                           .yields = true});
    }

    static constexpr double kTopRoom = 14;  // for the title of the height axis

    const DuelSource& source_;
    const ProfileFrame& frame_;
    const std::vector<std::size_t>& moment_;
    double unit_;
    Drawing drawing_;
};

}  // namespace

double duelPlace(const relief::Step& step) {
    return step.decision == relief::Decision::Start ? step.lambdaIn : step.lambdaAfter;
}

Shape runShape(std::size_t run) {
    constexpr std::array kShapes{Shape::Dot, Shape::TriangleDown, Shape::Diamond, Shape::Bar, Shape::Cross};
    return kShapes[run % kShapes.size()];
}

ProfileFrame duelFrame(const DuelSource& source, const ProfileOptions& options, double width, double height) {
    constexpr double kLeastPlot = 58;
    const double room = std::min(tracksHeight(source, height), std::max(0.0, height - kLeastPlot));
    ProfileSource profile = source.profile;
    if (source.upTo > 0) {
        profile.hit.outcome = relief::Outcome::Hit;
        profile.hit.lambda = source.upTo;
    }
    ProfileFrame frame = profileFrame(profile, options, width, height - room);
    frame.plot.x0 = std::max(frame.plot.x0, namesWidth(source, width));
    frame.plot.y0 += room;
    frame.plot.y1 += room;
    frame.whole.y1 += room;
    // The plot may have become low, so its lower margin is computed again.
    frame.plot.y1 = std::max(frame.whole.y1 - chart::bottomOf(frame.whole.height()), frame.plot.y0 + 1);
    frame.visible = frame.whole;
    return frame;
}

Drawing duelMarks(const DuelSource& source, const ProfileFrame& frame, const std::vector<std::size_t>& moment) {
    return DuelMarks(source, frame, moment).take();
}

Drawing duelLegend(const DuelSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    for (std::size_t r = 0; r < source.count(); ++r) {
        rows.sign(Role::Series, Marker{{}, runShape(r), 9}, plainText((*source.runs)[r].name), tintOf(r));
    }
    rows.line(Role::Overshoot, Message(MessageId::StopDisagreement));
    rows.sign(Role::Hit, Ring{{}, 4.5}, Message(MessageId::DrawHit));
    return rows.take();
}

}  // namespace reliefui
