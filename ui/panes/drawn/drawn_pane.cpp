#include "panes/drawn/drawn_pane.h"

#include "panes/drawn/drawn_figure.h"
#include "panes/drawn/drawn_view.h"

namespace reliefui {

PaneKind drawnPane() {
    PaneKind kind;
    kind.name = QStringLiteral("drawn");
    kind.title = DrawnView::tr("By hand");
    kind.help = DrawnView::tr("A small relief, drawn texel by texel");
    kind.place = DockPlace::Left;
    kind.make = makePane<DrawnView>;
    kind.figures = {{"drawn", true, plainFigure<drawnFigure>}};
    return kind;
}

}  // namespace reliefui
