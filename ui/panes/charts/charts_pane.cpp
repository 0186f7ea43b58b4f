#include "panes/charts/charts_pane.h"

#include "panes/charts/charts_figure.h"
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
                     [](std::shared_ptr<const Snapshot> s, int, const PaneStates& p) {
                         return measuredCharts(std::move(s), p.charts.error);
                     }},
                    {"pareto", true, {}}};
    return kind;
}

}  // namespace reliefui
