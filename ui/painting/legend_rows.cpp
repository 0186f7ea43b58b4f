#include "painting/legend_rows.h"

#include "painting/text_width.h"

#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Decision;
using relief::Message;
using relief::MessageId;

constexpr double kRow = 14;
constexpr double kTextSize = 0.9;

MessageId nameOf(Decision decision) {
    constexpr std::array<MessageId, 10> kNames{MessageId::DrawStart,  MessageId::DrawSkip,    MessageId::DrawDescend,
                                               MessageId::DrawAscend, MessageId::DrawAdvance, MessageId::DrawTest,
                                               MessageId::DrawRefine, MessageId::DrawHit,     MessageId::DrawMiss,
                                               MessageId::DrawLimit};
    return kNames[static_cast<std::size_t>(decision)];
}

}  // namespace

Point LegendRows::place(double width) {
    if (x_ + width > width_) newRow();
    const Point at{x_, y_ + kRow / 2};
    right_ = std::max(right_, std::min(x_ + width, std::max(width_, x_)));
    x_ += width;
    return at;
}

void LegendRows::newRow() {
    if (x_ == 0) return;
    x_ = 0;
    y_ += kRow;
}

double LegendRows::textRoom(const Message& message) const {
    return textWidth(relief::sentence(message, language_), kTextSize);
}

void LegendRows::add(Role role, Primitive primitive, LevelTint tint, Emphasis emphasis) {
    drawing_.add({ItemKind::Legend, 0, 0, 0}, role, std::move(primitive), emphasis, tint);
}

// An entry wider than a row continues in the next rows; no other entry follows in its last row.
void LegendRows::text(Point at, Message message) {
    const auto put = [this](Point place, Message words) {
        add(Role::Legend, Label{.at = place, .text = std::move(words), .size = kTextSize});
    };
    const double room = width_ - at.x;
    if (textRoom(message) <= room) return put(at, std::move(message));
    const auto lines = wrappedText(relief::sentence(message, language_), room,
                                   [](const std::string& line) { return textWidth(line, kTextSize); });
    for (const std::string& line : lines) {
        put(at, plainText(line));
        right_ = std::max(right_, at.x + textWidth(line, kTextSize));
        at.y += kRow;
    }
    y_ += kRow * static_cast<double>(lines.size() - 1);
    x_ = std::max(x_, width_);
}

Point LegendRows::sign(Role role, Primitive sign, const Message& what, LevelTint tint, Emphasis emphasis, double room) {
    constexpr double kHalf = 5;  // of the widest marker
    constexpr double kHalo = 3;  // a ring's line and the halo around it
    const auto* const round = std::get_if<Ring>(&sign);
    const double half = round != nullptr ? round->radius + kHalo : kHalf;
    room += 2 * (half - kHalf);
    const Point at = place(room + textRoom(what) + kBetween);
    const Point middle{at.x + half, at.y};
    if (auto* const marker = std::get_if<Marker>(&sign)) marker->at = middle;
    if (auto* const ring = std::get_if<Ring>(&sign)) ring->center = middle;
    if (auto* const circle = std::get_if<Circle>(&sign)) circle->center = middle;
    if (auto* const label = std::get_if<Label>(&sign)) label->at = middle;
    if (auto* const box = std::get_if<Rectangle>(&sign)) box->box = box->box.moved(middle);
    if (auto* const cells = std::get_if<Cells>(&sign)) {
        cells->clip = cells->clip.moved(middle);
        cells->x = cells->clip.x0;
        cells->y = cells->clip.y0;
    }
    add(role, std::move(sign), tint, emphasis);
    text({at.x + room, at.y}, what);
    return middle;
}

void LegendRows::words(const Message& message, double behind) {
    const Point at = place(textRoom(message) + behind);
    text(at, message);
}

void LegendRows::line(Role role, const Message& what, LevelTint tint, double length, Emphasis emphasis) {
    const Point at = place(length + 4 + textRoom(what) + kBetween);
    add(role, Polyline{{{at.x, at.y}, {at.x + length, at.y}}}, tint, emphasis);
    text({at.x + length + 4, at.y}, what);
}

void LegendRows::swatch(Role role, const Message& what, LevelTint tint, bool hatched) {
    const Box patch{-5, -4, 7, 4};
    const Point at =
        sign(role, Rectangle{patch, true, 0, 0}, what, tint, hatched ? Emphasis::Normal : Emphasis::Strong, kSign + 2);
    if (hatched) add(role, Hatch{patch.moved(at)});
}

void LegendRows::ramp(ColorMap map, const Message& what) {
    constexpr double kBar = 56;
    const Point at = place(kBar + 5 + textRoom(what) + kBetween);
    const Box bar{at.x, at.y - 5, at.x + kBar, at.y + 5};
    add(Role::HeightFill, colorBar(bar, map));
    add(Role::Frame, Rectangle{bar, false, 0, 0});
    text({at.x + kBar + 5, at.y}, what);
}

void LegendRows::block(Drawing drawing) {
    right_ = drawing.bounds.width();
    y_ = drawing.bounds.height();
    drawing_ = std::move(drawing);
}

void LegendRows::bodies(const std::vector<relief::Step>& steps, const relief::ViewRay& ray, const relief::Hit& exact,
                        const std::function<bool(const StepBody&)>& drawn) {
    StepBody some;
    bool broken = false;
    for (const relief::Step& step : steps) {
        const StepBody body = stepBody(step);
        if (!body) continue;
        some = body;
        broken = broken || (bodyRole(step, ray, exact) == Role::Overshoot && (!drawn || drawn(body)));
    }
    if (!some) return;
    const MessageId promise = some.refined                        ? MessageId::DrawPromisedRefined
                              : some.kind != StepBody::Kind::Cone ? MessageId::DrawPromisedSphere
                              : some.relaxed                      ? MessageId::DrawPromisedRelaxedCone
                              : some.square                       ? MessageId::DrawPromisedSquareCone
                                                                  : MessageId::DrawPromisedCone;
    line(Role::Empty, Message(promise));
    if (broken) line(Role::Overshoot, Message(MessageId::DrawPromiseBroken));
}

void LegendRows::decisions(const std::array<bool, relief::kDecisionNames.size()>& seen) {
    for (std::size_t d = 0; d < seen.size(); ++d) {
        if (!seen[d]) continue;
        const auto decision = static_cast<Decision>(d);
        sign(roleOf(decision), Marker{{}, shapeOf(decision), 8}, Message(nameOf(decision)));
    }
}

Drawing LegendRows::take() {
    drawing_.bounds = {0, 0, right_, x_ > 0 ? y_ + kRow : y_};
    return std::move(drawing_);
}

std::array<bool, relief::kDecisionNames.size()> decisionsSeen(const std::vector<relief::Step>* steps, bool hit) {
    std::array<bool, relief::kDecisionNames.size()> seen{};
    if (steps != nullptr) {
        for (const relief::Step& step : *steps) seen[static_cast<std::size_t>(step.decision)] = true;
    }
    seen[static_cast<std::size_t>(Decision::Hit)] = hit;
    return seen;
}

}  // namespace reliefui
