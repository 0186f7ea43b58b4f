#include "painting/legend_rows.h"
#include "panes/pyramid/pyramid_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

using relief::Message;
using relief::MessageId;

Drawing pyramidLegend(const PyramidSource& source, const RangedValues& heights, double width, relief::Language language,
                      bool brief) {
    LegendRows rows(width, language);
    rows.block(rangeLegend(heights, width, brief));
    if (source.hasRay) {
        rows.line(Role::Ray, Message(MessageId::DrawRay));
        rows.decisions(
            decisionsSeen(source.overCells ? source.steps : nullptr, source.hit.outcome == relief::Outcome::Hit));
    }
    return rows.take();
}

}  // namespace reliefui
