#include "panes/pyramid/pyramid_pane.h"

#include "panes/pyramid/pyramid_figure.h"
#include "panes/pyramid/pyramid_view.h"

namespace reliefui {

PaneKind pyramidPane() {
    PaneKind kind;
    kind.name = QStringLiteral("pyramid");
    kind.title = PyramidView::tr("Pyramid");
    kind.tab = PyramidView::tr("Pyramid", "tab");
    kind.help = PyramidView::tr("The levels of the pyramid and the texels that the ray looked at");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<PyramidView>;
    kind.figures = {{"pyramid", true,
                     [](std::shared_ptr<const Snapshot> s, int step, const PaneStates& p) {
                         return pyramidFigure(std::move(s), step, pyramidOptions(p.pyramid, p.ranges));
                     }},
                    {"slabs", false, [](std::shared_ptr<const Snapshot> s, int step, const PaneStates& p) {
                         return slabsFigure(std::move(s), step, pyramidOptions(p.pyramid, p.ranges), {});
                     }}};
    return kind;
}

}  // namespace reliefui
