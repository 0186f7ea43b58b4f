#include "painting/drawing.h"

#include <array>
#include <string_view>

namespace reliefui {

std::string labelText(const Label& label, relief::Language language) {
    const std::string text = relief::sentence(label.text, language);
    if (label.part < 0) return text;
    constexpr std::string_view kBetween = " · ";
    std::size_t begin = 0;
    for (int n = 0; n < label.part; ++n) {
        const std::size_t at = text.find(kBetween, begin);
        if (at == std::string::npos) return {};
        begin = at + kBetween.size();
    }
    return text.substr(begin, text.find(kBetween, begin) - begin);
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

Drawing messageDrawing(relief::MessageId message) {
    Drawing drawing;
    drawing.bounds = {0, 0, 300, 100};
    Label label;
    label.at = drawing.bounds.center();
    label.text = relief::Message(message);
    label.anchor = Anchor::Center;
    drawing.add({}, Role::Label, std::move(label));
    return drawing;
}

relief::Message plainText(std::string text) {
    return relief::Message(relief::MessageId::DrawPlain, {{"text", std::move(text)}});
}

}  // namespace reliefui
