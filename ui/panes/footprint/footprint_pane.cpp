#include "panes/footprint/footprint_pane.h"

#include "panes/footprint/footprint_figure.h"
#include "panes/footprint/footprint_state.h"
#include "panes/footprint/footprint_view.h"
#include "workspace/annotation_state.h"

namespace reliefui {

PaneKind footprintPane() {
    PaneKind kind;
    kind.name = QStringLiteral("footprint");
    kind.title = FootprintView::tr("Footprint");
    kind.tab = FootprintView::tr("Footprint", "tab");
    kind.help = FootprintView::tr("The part of the texture that the pixel covers, and the weight of each texel");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<FootprintView>;
    kind.figures = {{"footprint", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         const auto pane = stateOf<FootprintPane>(now);
                         FootprintOptions options;
                         options.neighbours = pane.neighbours;
                         options.weights = pane.weights;
                         return footprintFigure(std::move(s), options, stateOf<AnnotationState>(now).list);
                     }}};
    kind.states = {readerOf<FootprintPane>()};
    return kind;
}

}  // namespace reliefui
