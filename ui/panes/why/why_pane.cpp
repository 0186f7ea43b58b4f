#include "panes/why/why_pane.h"

#include "panes/why/why_figure.h"
#include "panes/why/why_view.h"

namespace reliefui {

PaneKind whyPane() {
    PaneKind kind;
    kind.name = QStringLiteral("why");
    kind.title = WhyView::tr("Why this colour");
    kind.tab = WhyView::tr("Why");
    kind.help = WhyView::tr("Coverage, ray, hit, filter and light of the pixel, with numbers that multiply out to it");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<WhyView>;
    kind.figures = {{"why", true, plainFigure<whyFigure>}};
    kind.open = false;  // opened from the menu or by its key: there is no room for more tabs at 1280 pixels
    return kind;
}

}  // namespace reliefui
