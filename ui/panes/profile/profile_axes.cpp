#include <algorithm>

#include "painting/chart.h"
#include "panes/profile/profile_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

using relief::Message;
using relief::MessageId;

Drawing profileAxes(const ProfileSource& source, const ProfileFrame& frame, double reserved) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    const Box seen = frame.seen();
    if (seen.empty()) return drawing;
    const double unit = 1 / frame.zoom;
    // The axes stay visible when the plot is zoomed beyond the pane.
    const Box all = frame.visible;
    const double x = std::max(frame.plot.x0, all.x0 + chart::kLeft * unit);
    const double y = std::min(frame.plot.y1, all.y1 - (chart::bottomOf(frame.whole.height()) + frame.tracks) * unit);
    for (const Box& edge : {Box{all.x0, all.y0, x, all.y1}, Box{all.x0, y, all.x1, all.y1}}) {
        drawing.add({}, Role::Background, Rectangle{edge, true, 0, 0}, Emphasis::Strong);
    }
    const Box room{all.x0, all.y0, all.x1, all.y1 - frame.tracks * unit};
    const chart::Axes axes(drawing, {x, seen.y0, seen.x1, y}, room, unit);
    axes.sides();
    axes.corner(Message(MessageId::DrawHeightAxis, {{"texels", relief::numberText(source.field->slabTexels(), 3)}}),
                reserved);
    const double low = std::max(frame.low, frame.heightAt(y));
    const double high = std::min(1.0, frame.heightAt(seen.y0));
    axes.left({low, high, frame.yAt(low), frame.yAt(high)});
    axes.below({frame.across(frame.lambdaAt(x)), frame.across(frame.lambdaAt(seen.x1)), x, seen.x1},
               Message(frame.vertical ? MessageId::DrawDescentAxis : MessageId::DrawDistanceAxis));
    return drawing;
}

}  // namespace reliefui
