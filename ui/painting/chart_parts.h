// Lines and words that charts are made of. Points.
#pragma once

#include <algorithm>
#include <string>

#include "painting/drawing.h"
#include "painting/text_width.h"

namespace reliefui::chart {

inline constexpr double kTextSize = kChartText;
inline constexpr double kTick = 3;

inline void text(Drawing& drawing, Point at, relief::Message message, Anchor anchor, Point offset,
                 Role role = Role::Legend, Emphasis emphasis = Emphasis::Normal) {
    Label label;
    label.at = at;
    label.text = std::move(message);
    label.anchor = anchor;
    label.size = kTextSize;
    label.offset = offset;
    drawing.add({}, role, std::move(label), emphasis);
}

inline constexpr double kTitleLine = 11;

// At the upper left corner of a room, as large as fits into its width, in either language; a title of two parts
// (" · ") in two lines where one would be small. How many lines it takes.
inline int title(Drawing& drawing, relief::Message message, const Box& room, Role role = Role::Legend) {
    constexpr double kSmallest = 0.65;
    constexpr double kSmall = 0.9;
    const auto fitting = [&](const Label& label) {
        double width = 1;
        for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
            width = std::max(width, textWidth(labelText(label, language)));
        }
        return (room.width() - 4) / width;
    };
    Label label;
    label.at = {room.x0, room.y0};
    label.text = std::move(message);
    label.anchor = Anchor::TopLeft;
    label.offset = {2, 0};
    Label second = label;
    second.part = 1;
    const bool two = fitting(label) < kSmall && !labelText(second, relief::Language::English).empty();
    label.part = two ? 0 : -1;
    label.size =
        kTextSize * std::clamp(two ? std::min(fitting(label), fitting(second)) : fitting(label), kSmallest, 1.0);
    second.size = label.size;
    second.offset.y = kTitleLine;
    drawing.add({}, role, std::move(label));
    if (two) drawing.add({}, role, std::move(second));
    return two ? 2 : 1;
}

inline void line(Drawing& drawing, Point from, Point to, Role role = Role::Frame) {
    drawing.add({}, role, Polyline{{from, to}, false});
}

// A value of the vertical axis.
inline void side(Drawing& drawing, const Box& plot, double y, std::string value) {
    line(drawing, {plot.x0, y}, {plot.x1, y}, Role::Grid);
    line(drawing, {plot.x0 - kTick, y}, {plot.x0, y});
    text(drawing, {plot.x0, y}, plainText(std::move(value)), Anchor::Right, {-kTick - 2, 0});
}

}  // namespace reliefui::chart
