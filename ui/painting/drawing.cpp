#include "painting/drawing.h"

#include <array>
#include <string_view>

namespace reliefui {

std::vector<std::string> textParts(const std::string& text) {
    constexpr std::string_view kBetween = " · ";
    std::vector<std::string> parts;
    std::size_t from = 0;
    while (true) {
        const std::size_t to = text.find(kBetween, from);
        parts.push_back(text.substr(from, to - from));
        if (to == std::string::npos) return parts;
        from = to + kBetween.size();
    }
}

std::string labelText(const Label& label, relief::Language language) {
    const std::string text = relief::sentence(label.text, language);
    if (label.part < 0) return text;
    const std::vector<std::string> parts = textParts(text);
    const auto part = static_cast<std::size_t>(label.part);
    return part < parts.size() ? parts[part] : std::string();
}

std::string idText(const ItemId& id) {
    constexpr std::array<std::string_view, 11> kNames{"",       "level",   "texel", "step",     "ray",      "hit",
                                                      "legend", "surface", "layer", "iso-line", "color-bar"};
    std::string text(kNames[static_cast<std::size_t>(id.kind)]);
    const auto part = [&](std::int64_t number) {
        text += '/';
        text += std::to_string(number);
    };
    switch (id.kind) {
        case ItemKind::Level:
            part(id.level);
            break;
        case ItemKind::Texel:
            part(id.level);
            part(id.i);
            part(id.j);
            break;
        case ItemKind::Step:
        case ItemKind::Layer:
            part(id.i);
            break;
        default:
            break;
    }
    return text;
}

Role roleOf(relief::Decision decision) {
    switch (decision) {
        case relief::Decision::Start:
            return Role::Start;
        case relief::Decision::Skip:
            return Role::Skipped;
        case relief::Decision::Descend:
            return Role::Descended;
        case relief::Decision::Ascend:
            return Role::Ascended;
        case relief::Decision::Advance:
            return Role::Advanced;
        case relief::Decision::Test:
            return Role::Tested;
        case relief::Decision::Refine:
            return Role::Refined;
        case relief::Decision::Hit:
            return Role::Hit;
        case relief::Decision::Miss:
            return Role::Miss;
        case relief::Decision::Limit:
            return Role::Limit;
    }
    return Role::Frame;
}

Shape shapeOf(relief::Decision decision) {
    switch (decision) {
        case relief::Decision::Start:
            return Shape::Dot;
        case relief::Decision::Skip:
            return Shape::TriangleRight;
        case relief::Decision::Descend:
            return Shape::TriangleDown;
        case relief::Decision::Ascend:
            return Shape::TriangleUpHollow;
        case relief::Decision::Advance:
            return Shape::Bar;
        case relief::Decision::Test:
            return Shape::Diamond;
        case relief::Decision::Refine:
            return Shape::DotSmall;
        case relief::Decision::Hit:
            return Shape::Ring;
        case relief::Decision::Miss:
            return Shape::SquareHollow;
        case relief::Decision::Limit:
            return Shape::Cross;
    }
    return Shape::Dot;
}

void Drawing::append(Drawing other) {
    bounds = bounds.joined(other.bounds);
    items.insert(items.end(), std::move_iterator(other.items.begin()), std::move_iterator(other.items.end()));
}

Cells colorBar(const Box& box, ColorMap map, const ColorScale& scale) {
    constexpr int kCells = 96;
    auto values = std::make_shared<relief::FloatImage>(kCells, 1);
    for (int i = 0; i < kCells; ++i) (*values)(i, 0) = static_cast<float>(scale.value((i + 0.5) / kCells));
    return {.values = std::move(values),
            .x = box.x0,
            .y = box.y0,
            .cellWidth = box.width() / kCells,
            .cellHeight = box.height(),
            .clip = box,
            .map = map,
            .scale = scale};
}

Drawing messageDrawing(relief::MessageId message) {
    Drawing drawing;
    drawing.bounds = {0, 0, 300, 100};
    drawing.add({}, Role::Label,
                Label{.at = drawing.bounds.center(), .text = relief::Message(message), .anchor = Anchor::Center});
    return drawing;
}

relief::Message plainText(std::string text) {
    return relief::Message(relief::MessageId::DrawPlain, {{"text", std::move(text)}});
}

}  // namespace reliefui
