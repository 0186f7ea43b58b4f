#include <array>

#include "drawings/pyramid_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Decision;
using relief::Message;
using relief::MessageId;

constexpr double kRow = 14;
constexpr double kTextSize = 0.9;
constexpr int kRampCells = 64;

MessageId nameOf(Decision decision) {
    constexpr std::array<MessageId, 10> kNames{MessageId::DrawStart,  MessageId::DrawSkip,    MessageId::DrawDescend,
                                               MessageId::DrawAscend, MessageId::DrawAdvance, MessageId::DrawTest,
                                               MessageId::DrawRefine, MessageId::DrawHit,     MessageId::DrawMiss,
                                               MessageId::DrawLimit};
    return kNames[static_cast<std::size_t>(decision)];
}

// About the width of the text in points.
double roomFor(const Message& message, relief::Language language) {
    constexpr double kLetter = 6.1;
    std::size_t letters = 0;
    for (const char c : relief::sentence(message, language)) {
        letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;  // not inside a UTF-8 letter
    }
    return static_cast<double>(letters) * kLetter * kTextSize;
}

// Entries one after the other, in as many rows as it takes.
class Rows {
  public:
    explicit Rows(double width) : width_(width) {}

    // The place of an entry of this width; the middle of its row.
    Point place(double width) {
        if (x_ > 0 && x_ + width > width_) {
            x_ = 0;
            y_ += kRow;
        }
        const Point at{x_, y_ + kRow / 2};
        right_ = std::max(right_, x_ + width);
        x_ += width;
        return at;
    }
    Box bounds() const { return {0, 0, right_, y_ + kRow}; }

  private:
    double width_;
    double x_ = 0;
    double y_ = 0;
    double right_ = 0;
};

void addText(Drawing& drawing, Point at, Message message) {
    Label label;
    label.at = at;
    label.text = std::move(message);
    label.size = kTextSize;
    drawing.add({ItemKind::Legend, 0, 0, 0}, Role::Legend, std::move(label));
}

void addHeights(Drawing& drawing, Rows& rows, double slabTexels, relief::Language language) {
    constexpr double kBar = 56;
    constexpr double kDigit = 8;
    const Message name(MessageId::DrawHeightLegend, {{"texels", relief::numberText(slabTexels, 3)}});
    const Point at = rows.place(2 * kDigit + kBar + 14 + roomFor(name, language));
    static const auto ramp = [] {
        auto values = std::make_shared<relief::FloatImage>(kRampCells, 1);
        for (int i = 0; i < kRampCells; ++i) (*values)(i, 0) = static_cast<float>(i) / (kRampCells - 1);
        return std::shared_ptr<const relief::FloatImage>(values);
    }();
    Cells bar;
    bar.values = ramp;
    bar.x = at.x + kDigit;
    bar.y = at.y - 5;
    bar.cellWidth = kBar / kRampCells;
    bar.cellHeight = 10;
    bar.clip = {bar.x, bar.y, bar.x + kBar, bar.y + 10};
    addText(drawing, at, plainText("0"));
    drawing.add({ItemKind::Legend, 0, 0, 0}, Role::HeightFill, bar);
    drawing.add({}, Role::Frame, Rectangle{bar.clip, false, 0, 0});
    addText(drawing, {at.x + kDigit + kBar + 3, at.y}, plainText("1"));
    addText(drawing, {at.x + 2 * kDigit + kBar + 5, at.y}, name);
}

}  // namespace

Drawing pyramidLegend(const PyramidSource& source, double width, relief::Language language) {
    constexpr double kSign = 14;
    constexpr double kBetween = 9;
    Drawing drawing;
    Rows rows(width);
    addHeights(drawing, rows, source.field->slabTexels(), language);
    if (!source.hasRay) {
        drawing.bounds = rows.bounds();
        return drawing;
    }
    const Message ray(MessageId::DrawRay);
    const Point at = rows.place(kSign + 8 + roomFor(ray, language) + kBetween);
    drawing.add({}, Role::Ray, Polyline{{{at.x, at.y}, {at.x + kSign + 4, at.y}}, false});
    addText(drawing, {at.x + kSign + 8, at.y}, ray);
    std::array<bool, relief::kDecisionNames.size()> seen{};
    if (source.steps != nullptr && source.overCells) {
        for (const relief::Step& step : *source.steps) seen[static_cast<std::size_t>(step.decision)] = true;
    }
    seen[static_cast<std::size_t>(Decision::Hit)] = source.hit.outcome == relief::Outcome::Hit;
    for (std::size_t d = 0; d < seen.size(); ++d) {
        if (!seen[d]) continue;
        const auto decision = static_cast<Decision>(d);
        const Message name(nameOf(decision));
        const Point place = rows.place(kSign + roomFor(name, language) + kBetween);
        drawing.add({ItemKind::Legend, 0, 0, 0}, roleOf(decision),
                    Marker{{place.x + 5, place.y}, shapeOf(decision), 8});
        addText(drawing, {place.x + kSign, place.y}, name);
    }
    drawing.bounds = rows.bounds();
    return drawing;
}

}  // namespace reliefui
