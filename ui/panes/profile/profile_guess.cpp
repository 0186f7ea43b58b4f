#include <algorithm>
#include <cmath>
#include <limits>

#include "painting/chart.h"
#include "panes/profile/profile_drawing.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

void addWords(Drawing& drawing, Point at, Message text, Anchor anchor, Point offset, double size) {
    drawing.add(
        {}, Role::Background,
        Label{.at = at, .text = std::move(text), .anchor = anchor, .size = size, .offset = offset, .plate = true},
        Emphasis::Strong);
}

// Returns the centre of a text that has to be inside the visible part of the plot, as near to `x` as possible.
double placeInside(double x, const Message& text, double size, const ProfileFrame& frame) {
    constexpr double kPad = 4;  // of the plate, points
    const Box seen = frame.seen();
    const double half = (chart::widthOf(text) * size / chart::kTextSize / 2 + kPad) / frame.zoom;
    return std::max(std::min(x, seen.x1 - half), seen.x0 + half);
}

}  // namespace

double guessError(const ProfileSource& source, double guess) {
    if (source.hit.outcome != relief::Outcome::Hit) return std::numeric_limits<double>::infinity();
    return std::abs(source.hit.lambda - guess) * std::max(1.0, std::hypot(source.ray.a, source.ray.b));
}

void addGuess(Drawing& drawing, const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame) {
    constexpr double kWords = 1.2;
    const Box seen = frame.seen();
    if (options.guessing) {
        addWords(drawing, {(seen.x0 + seen.x1) / 2, seen.y0}, Message(MessageId::DrawGuessHint), Anchor::Top, {0, 4},
                 kWords);
        return;
    }
    if (!options.guess) return;
    const double lambda = std::clamp(*options.guess, 0.0, frame.lambdaEnd);
    const Point at = frame.onRay(lambda);
    const bool hit = source.hit.outcome == relief::Outcome::Hit;
    const double error = guessError(source, *options.guess);
    if (hit) {
        const Point there = frame.onRay(std::clamp(source.hit.lambda, 0.0, frame.lambdaEnd));
        // Placed above both positions, clear of the steps' marks.
        const double y = std::max(seen.y0 + 26 / frame.zoom, std::min(at.y, there.y) - 34 / frame.zoom);
        for (const Point end : {at, there}) {
            drawing.add({}, Role::Highlight, Polyline{{{end.x, y}, end}, false}, Emphasis::Faint);
        }
        drawing.add({}, Role::Highlight, Polyline{{{at.x, y}, {there.x, y}}, true}, Emphasis::Normal);
        const Message answer(MessageId::DrawGuessAnswer, {{"texels", relief::numberText(error, 3)}});
        addWords(drawing, {placeInside((at.x + there.x) / 2, answer, kWords, frame), y}, answer, Anchor::Bottom,
                 {0, -3}, kWords);
    } else {
        addWords(drawing, {(seen.x0 + seen.x1) / 2, seen.y0}, Message(MessageId::DrawGuessMiss), Anchor::Top, {0, 4},
                 kWords);
    }
    drawing.add({}, Role::Highlight, Marker{at, Shape::Cross, 11}, Emphasis::Strong);
    const Message guessed(MessageId::DrawGuess);
    addWords(drawing, {placeInside(at.x, guessed, 1, frame), at.y}, guessed, Anchor::Top, {0, 7}, 1);
}

}  // namespace reliefui
