#include "panes/pyramid/pyramid_pane.h"

#include "panes/pyramid/pyramid_figure.h"
#include "panes/pyramid/pyramid_state.h"
#include "panes/pyramid/pyramid_view.h"
#include "workspace/annotation_state.h"

namespace reliefui {

namespace {

// Throws InputError if the heights are read by tiles: there are no pyramids in memory then.
std::shared_ptr<const Snapshot> withPyramids(std::shared_ptr<const Snapshot> snapshot) {
    static_cast<void>(snapshot->request->field.sharedHeights());
    return snapshot;
}

}  // namespace

PaneKind pyramidPane() {
    PaneKind kind;
    kind.name = QStringLiteral("pyramid");
    kind.title = PyramidView::tr("Pyramid");
    kind.tab = PyramidView::tr("Pyramid", "tab");
    kind.help = PyramidView::tr("The levels of the pyramid and the texels that the ray visited");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<PyramidView>;
    const auto slabs = [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now, std::optional<double> turn) {
        return slabsFigure(withPyramids(std::move(s)), now.step, pyramidOptions(now), {}, turn);
    };
    kind.figures = {{"pyramid", true,
                     [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return pyramidFigure(withPyramids(std::move(s)), now.step, pyramidOptions(now),
                                              stateOf<AnnotationState>(now).list);
                     }},
                    {"slabs", false,
                     [slabs](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return slabs(std::move(s), now, {});
                     },
                     slabs}};
    kind.states = {readerOf<PyramidPane>()};
    return kind;
}

}  // namespace reliefui
