#include "painting/annotation.h"

#include <algorithm>
#include <cmath>

#include "painting/text_width.h"
#include "painting/view_map.h"

namespace reliefui {

namespace {

// Sizes in points; the text size is relative to the style's.
constexpr double kSize = 0.85;
constexpr double kTextHigh = 9.5;
constexpr double kPad = 2.4;        // of the plate, at each side of the text
constexpr double kDisc = 14;        // behind a number of one digit
constexpr double kTick = 4;         // ends of a bracket
constexpr double kBracketGap = 2;   // between a bracket and its text
constexpr double kShortest = 1e-9;  // of a bracket, drawing units

Box plateAt(Point center, const std::string& text, double unit) {
    const double w = (textWidth(text, kSize) / 2 + kPad) * unit;
    const double h = kTextHigh / 2 * unit;
    return {center.x - w, center.y - h, center.x + w, center.y + h};
}

// Moves the box into the room, along each side along which it fits.
Box within(const Box& box, const Box& room) {
    const auto shift = [](double low, double high, double from, double to) {
        if (high - low > to - from) return 0.0;
        return std::max(0.0, from - low) - std::max(0.0, high - to);
    };
    return box.moved({shift(box.x0, box.x1, room.x0, room.x1), shift(box.y0, box.y1, room.y0, room.y1)});
}

// Control characters, such as line ends, become spaces.
std::string oneLine(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return text;
}

void shapeBracket(AnnotationShape& shape, Point a, Point b, double unit) {
    const double length = std::max(std::hypot(b.x - a.x, b.y - a.y), kShortest);
    // To the left of the way from a to b, y downwards.
    const Point left{(b.y - a.y) / length, (a.x - b.x) / length};
    const double tick = kTick * unit;
    shape.line = {{a.x - left.x * tick, a.y - left.y * tick}, a, b, {b.x - left.x * tick, b.y - left.y * tick}};
    if (shape.text.empty()) return;
    shape.plate = plateAt({(a.x + b.x) / 2, (a.y + b.y) / 2}, shape.text, unit);
    const double away =
        std::abs(left.x) * shape.plate.width() / 2 + std::abs(left.y) * shape.plate.height() / 2 + kBracketGap * unit;
    shape.plate = shape.plate.moved({left.x * away, left.y * away});
}

Role roleOf(const Annotation& note) {
    const auto at = std::find(kAnnotationColors.begin(), kAnnotationColors.end(), note.color);
    return at == kAnnotationColors.end() ? kAnnotationRoles.front()
                                         : kAnnotationRoles[static_cast<std::size_t>(at - kAnnotationColors.begin())];
}

// Roles with thin lines are drawn as wide as the others.
Emphasis emphasisOf(Role role) {
    const bool thin = role == Role::Tested || role == Role::Searched || role == Role::Neighbour;
    return thin ? Emphasis::Strong : Emphasis::Normal;
}

}  // namespace

AnnotationShape annotationShape(const Annotation& note, const AnnotationFrame& frame, relief::Language language) {
    AnnotationShape shape;
    if (note.view != frame.view) return shape;
    const Point at = frame.toDrawing(note.at);
    const Point to = note.hasEnd() ? frame.toDrawing(note.to) : at;
    const Point middle{(at.x + to.x) / 2, (at.y + to.y) / 2};
    const bool bracket = note.kind == AnnotationKind::Bracket;
    // An arrow is about its tip, a bracket about all between its ends.
    shape.shown = frame.seen.contains(to) || (bracket && (frame.seen.contains(at) || frame.seen.contains(middle)));
    if (!shape.shown) return shape;
    shape.text = oneLine(note.textIn(language));
    if (bracket) {
        shapeBracket(shape, at, to, frame.unit);
    } else if (!shape.text.empty()) {
        shape.plate = plateAt(at, shape.text, frame.unit);
    }
    if (!shape.plate.empty()) shape.plate = within(shape.plate, frame.seen);
    if (note.kind == AnnotationKind::Arrow) shape.line = {shape.plate.empty() ? at : shape.plate.center(), to};
    return shape;
}

Drawing annotationDrawing(const std::vector<Annotation>& notes, const AnnotationFrame& frame,
                          relief::Language language) {
    Drawing drawing;
    for (const Annotation& note : notes) {
        const AnnotationShape shape = annotationShape(note, frame, language);
        if (!shape.shown) continue;
        const Role role = roleOf(note);
        const Emphasis emphasis = emphasisOf(role);
        for (std::vector<Point>& run : clippedTo(shape.line, frame.seen)) {
            const bool arrow = note.kind == AnnotationKind::Arrow;
            drawing.add({}, role, Polyline{std::move(run), arrow}, emphasis);
        }
        if (shape.plate.empty()) continue;
        if (note.kind == AnnotationKind::Number && shape.plate.width() < kDisc * frame.unit) {
            drawing.add({}, role, Marker{shape.plate.center(), Shape::Dot, kDisc}, emphasis);
        }
        Label label{.at = shape.plate.center(), .text = plainText(shape.text), .anchor = Anchor::Center, .size = kSize};
        label.plate = true;
        drawing.add({}, role, std::move(label), emphasis);
    }
    return drawing;
}

}  // namespace reliefui
