#include "panes/charts/charts_pane.h"

#include "panes/charts/charts_figure.h"
#include "panes/charts/charts_state.h"
#include "panes/charts/charts_view.h"

namespace reliefui {

PaneKind chartsPane() {
    PaneKind kind;
    kind.name = QStringLiteral("charts");
    kind.title = ChartsView::tr("Charts");
    kind.help = ChartsView::tr("Run time against error, steps and errors of all pixels");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<ChartsView>;
    kind.figures = {{"charts", true,
                     [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return measuredCharts(std::move(s), stateOf<ChartsPane>(now).error);
                     }},
                    {"pareto", true, {}}};
    kind.states = {readerOf<ChartsPane>()};
    return kind;
}

}  // namespace reliefui
