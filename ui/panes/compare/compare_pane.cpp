#include "panes/compare/compare_pane.h"

#include "panes/compare/compare_figure.h"
#include "panes/compare/compare_view.h"

namespace reliefui {

PaneKind comparePane() {
    PaneKind kind;
    kind.name = QStringLiteral("compare");
    kind.title = CompareView::tr("Compare");
    kind.tab = CompareView::tr("Compare", "tab");
    kind.help = CompareView::tr("Compare methods, filters, coordinates or heights");
    kind.place = DockPlace::UpperRight;
    kind.make = makePane<CompareView>;
    kind.figures = {{"compare", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario&) {
                         return compareFigure(std::move(s), nullptr, 0);
                     }}};
    return kind;
}

}  // namespace reliefui
