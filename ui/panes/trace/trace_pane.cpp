#include "panes/trace/trace_pane.h"

#include "panes/trace/trace3d_view.h"
#include "panes/trace/trace_figure.h"
#include "panes/trace/trace_state.h"

namespace reliefui {

PaneKind tracePane() {
    PaneKind kind;
    kind.name = QStringLiteral("trace");
    kind.title = Trace3dView::tr("Trace 3-D");
    kind.tab = Trace3dView::tr("Trace 3-D", "tab");
    kind.help = Trace3dView::tr("The ray through the relief, in space");
    kind.place = DockPlace::UpperRight;
    kind.make = makePane<Trace3dView>;
    const auto figure = [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now, std::optional<double> turn) {
        const auto pane = stateOf<TracePane>(now);
        return traceFigure(std::move(s), now.step, {pane.heights, stepColors(pane.colors), {}, turn});
    };
    kind.figures = {{"trace", true,
                     [figure](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return figure(std::move(s), now, {});
                     },
                     figure}};
    kind.states = {readerOf<TracePane>()};
    return kind;
}

}  // namespace reliefui
