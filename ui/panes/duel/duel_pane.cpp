#include "panes/duel/duel_pane.h"

#include "panes/duel/duel_figure.h"
#include "panes/duel/duel_view.h"

namespace reliefui {

PaneKind duelPane() {
    PaneKind kind;
    kind.name = QStringLiteral("duel");
    kind.title = DuelView::tr("Duel");
    kind.help = DuelView::tr("Several methods on one ray, step by step");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<DuelView>;
    kind.figures = {{"duel", true, plainFigure<computedDuel>}};
    return kind;
}

}  // namespace reliefui
