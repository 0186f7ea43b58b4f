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
    if (x_ > 0 && x_ + width > width_) {
        x_ = 0;
        y_ += kRow;
    }
    const Point at{x_, y_ + kRow / 2};
    right_ = std::max(right_, std::min(x_ + width, std::max(width_, x_)));
    x_ += width;
    return at;
}

double LegendRows::textRoom(const Message& message) const {
    return textWidth(relief::sentence(message, language_), kTextSize);
}

void LegendRows::add(Role role, Primitive primitive, LevelTint tint, Emphasis emphasis) {
    drawing_.items.push_back({{ItemKind::Legend, 0, 0, 0}, role, emphasis, std::move(primitive), tint});
}

// What is wider than a row goes on in the next ones, and nothing stands beside its end.
void LegendRows::text(Point at, Message message) {
    const auto put = [this](Point place, Message words) {
        Label label;
        label.at = place;
        label.text = std::move(words);
        label.size = kTextSize;
        add(Role::Legend, std::move(label));
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

void LegendRows::line(Role role, const Message& what, LevelTint tint, double length) {
    const Point at = place(length + 4 + textRoom(what) + kBetween);
    add(role, Polyline{{{at.x, at.y}, {at.x + length, at.y}}, false}, tint);
    text({at.x + length + 4, at.y}, what);
}

void LegendRows::swatch(Role role, const Message& what, LevelTint tint) {
    constexpr double kWide = 12;
    constexpr double kHigh = 8;
    const Point at = place(kWide + 4 + textRoom(what) + kBetween);
    const Box patch{at.x, at.y - kHigh / 2, at.x + kWide, at.y + kHigh / 2};
    add(role, Rectangle{patch, true, 0, 0}, tint, Emphasis::Strong);
    text({at.x + kWide + 4, at.y}, what);
}

void LegendRows::ramp(ColorMap map, const Message& what) {
    static constexpr int kRampCells = 64;
    constexpr double kBar = 56;
    const Point at = place(kBar + 5 + textRoom(what) + kBetween);
    static const auto values = [] {
        auto ramp = std::make_shared<relief::FloatImage>(kRampCells, 1);
        for (int i = 0; i < kRampCells; ++i) (*ramp)(i, 0) = static_cast<float>(i) / (kRampCells - 1);
        return std::shared_ptr<const relief::FloatImage>(ramp);
    }();
    Cells bar;
    bar.values = values;
    bar.x = at.x;
    bar.y = at.y - 5;
    bar.cellWidth = kBar / kRampCells;
    bar.cellHeight = 10;
    bar.clip = {bar.x, bar.y, bar.x + kBar, bar.y + 10};
    bar.map = map;
    add(Role::HeightFill, bar);
    add(Role::Frame, Rectangle{bar.clip, false, 0, 0});
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
    const MessageId promise = some.kind != StepBody::Kind::Cone ? MessageId::DrawPromisedSphere
                              : some.square                     ? MessageId::DrawPromisedSquareCone
                                                                : MessageId::DrawPromisedCone;
    line(Role::Empty, Message(promise));
    if (broken) line(Role::Overshoot, Message(MessageId::DrawPromiseBroken));
}

void LegendRows::decisions(const std::array<bool, relief::kDecisionNames.size()>& seen) {
    for (std::size_t d = 0; d < seen.size(); ++d) {
        if (!seen[d]) continue;
        const auto decision = static_cast<Decision>(d);
        const Message name(nameOf(decision));
        const Point at = place(kSign + textRoom(name) + kBetween);
        add(roleOf(decision), Marker{{at.x + 5, at.y}, shapeOf(decision), 8});
        text({at.x + kSign, at.y}, name);
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
