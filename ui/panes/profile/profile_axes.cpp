#include <algorithm>
#include <cmath>

#include "painting/axis_ticks.h"
#include "panes/profile/profile_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

constexpr double kTextSize = 0.8;
constexpr double kTick = 3;         // points
constexpr double kNumberRoom = 30;  // left of the height axis
constexpr double kTitleRoom = 29;   // below the other
constexpr double kLowTitleRoom = 16;

void addText(Drawing& drawing, Point at, Message text, Anchor anchor, Point offset, bool yields = false) {
    Label label;
    label.at = at;
    label.text = std::move(text);
    label.anchor = anchor;
    label.size = kTextSize;
    label.offset = offset;
    label.yields = yields;
    drawing.add({}, Role::Legend, std::move(label));
}

void addTick(Drawing& drawing, Point from, Point to) {
    drawing.add({}, Role::Frame, Polyline{{from, to}, false});
}

}  // namespace

Drawing profileAxes(const ProfileSource& source, const ProfileFrame& frame) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    const Box seen = frame.seen();
    if (seen.empty()) return drawing;
    const double unit = 1 / frame.zoom;
    // The axes stay in sight when the plot is larger than the pane.
    const double x = std::max(frame.plot.x0, frame.visible.x0 + kNumberRoom * unit);
    const double y = std::min(frame.plot.y1, frame.visible.y1 - (lowPane(frame) ? kLowTitleRoom : kTitleRoom) * unit);
    const Box all = frame.visible;
    drawing.add({}, Role::Background, Rectangle{{all.x0, all.y0, x, all.y1}, true, 0, 0}, Emphasis::Strong);
    drawing.add({}, Role::Background, Rectangle{{all.x0, y, all.x1, all.y1}, true, 0, 0}, Emphasis::Strong);
    addTick(drawing, {x, seen.y0}, {x, y});
    addTick(drawing, {x, y}, {seen.x1, y});

    const double low = std::max(frame.low, frame.heightAt(y));
    const double high = std::min(1.0, frame.heightAt(seen.y0));
    if (high > low) {
        const double step = niceStep(high - low, (y - seen.y0) * frame.zoom / 22);
        for (const double height : ticks(low, high, step)) {
            const double at = frame.yAt(height);
            addTick(drawing, {x - kTick * unit, at}, {x, at});
            addText(drawing, {x, at}, plainText(tickText(height, step)), Anchor::Right, {-kTick - 2, 0});
        }
    }
    // First: numbers give way to words.
    const Message title(frame.vertical ? MessageId::DrawDescentAxis : MessageId::DrawDistanceAxis);
    if (lowPane(frame)) {
        addText(drawing, {seen.x1, y}, title, Anchor::Right, {0, kTick + 6});
    } else {
        addText(drawing, {(x + seen.x1) / 2, y}, title, Anchor::Top, {0, kTick + 13});
    }
    const double from = frame.across(frame.lambdaAt(x));
    const double to = frame.across(frame.lambdaAt(seen.x1));
    if (to > from) {
        const double step = niceStep(to - from, (seen.x1 - x) * frame.zoom / 52);
        for (const double value : ticks(from, to, step)) {
            const double at = frame.xAt(frame.vertical ? value : value / frame.run);
            addTick(drawing, {at, y}, {at, y + kTick * unit});
            addText(drawing, {at, y}, plainText(tickText(value, step)), Anchor::Top, {0, kTick + 1}, true);
        }
    }
    addText(drawing, {std::max(seen.x0, all.x0), std::max(seen.y0, all.y0)},
            Message(MessageId::DrawHeightAxis, {{"texels", relief::numberText(source.field->slabTexels(), 3)}}),
            Anchor::BottomLeft, {kTick - kNumberRoom + 2, -2});
    return drawing;
}

}  // namespace reliefui
