#include "panes/trace/trace_pane.h"

#include "panes/trace/trace3d_view.h"
#include "panes/trace/trace_figure.h"

namespace reliefui {

PaneKind tracePane() {
    PaneKind kind;
    kind.name = QStringLiteral("trace");
    kind.title = Trace3dView::tr("Trace 3-D");
    kind.tab = Trace3dView::tr("Trace 3-D", "tab");
    kind.help = Trace3dView::tr("The ray through the relief, in space");
    kind.place = DockPlace::UpperRight;
    kind.make = makePane<Trace3dView>;
    kind.figures = {{"trace", false, [](std::shared_ptr<const Snapshot> s, int step, const PaneStates& p) {
                         return traceFigure(std::move(s), step, {p.trace.heights, stepColors(p.trace.colors), {}});
                     }}};
    return kind;
}

}  // namespace reliefui
