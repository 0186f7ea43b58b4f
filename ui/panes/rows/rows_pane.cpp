#include "panes/rows/rows_pane.h"

#include "panes/rows/row_flow.h"
#include "panes/rows/rows_figure.h"
#include "panes/rows/rows_state.h"
#include "panes/rows/rows_view.h"

namespace reliefui {

PaneKind rowsPane() {
    PaneKind kind;
    kind.name = QStringLiteral("rows");
    kind.title = RowsView::tr("Rows");
    kind.help = RowsView::tr("Texture coordinates along the pixel's row, computed in several ways");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<RowsView>;
    kind.figures = {{"rows", true,
                     [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return rowsFigure(std::move(s), rowsOptions(stateOf<RowsPane>(now)), {});
                     }},
                    {"row-flow", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return rowFlowFigure(std::move(s), stateOf<RowsPane>(now));
                     }}};
    kind.states = {readerOf<RowsPane>()};
    return kind;
}

}  // namespace reliefui
