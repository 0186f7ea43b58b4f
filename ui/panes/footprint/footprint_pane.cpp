#include "panes/footprint/footprint_pane.h"

#include "panes/footprint/footprint_figure.h"
#include "panes/footprint/footprint_view.h"

namespace reliefui {

PaneKind footprintPane() {
    PaneKind kind;
    kind.name = QStringLiteral("footprint");
    kind.title = FootprintView::tr("Footprint");
    kind.tab = FootprintView::tr("Footprint", "tab");
    kind.help = FootprintView::tr("The part of the texture that the pixel covers, and the weight of each texel");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<FootprintView>;
    kind.figures = {{"footprint", true, [](std::shared_ptr<const Snapshot> s, int, const PaneStates& p) {
                         FootprintOptions options;
                         options.neighbours = p.footprint.neighbours;
                         options.weights = p.footprint.weights;
                         return footprintFigure(std::move(s), options);
                     }}};
    return kind;
}

}  // namespace reliefui
