#include "panes/formula/formula_pane.h"

#include "panes/formula/formula_figure.h"
#include "panes/formula/formula_view.h"

namespace reliefui {

PaneKind formulaPane() {
    PaneKind kind;
    kind.name = QStringLiteral("formula");
    kind.title = FormulaView::tr("Formulas");
    kind.help = FormulaView::tr("The papers' equations with the numbers of the chosen pixel and step put in");
    kind.home = Home::Low;
    kind.make = makePane<FormulaView>;
    kind.figures = {{"formula", true, plainFigure<formulaFigure>}};
    return kind;
}

}  // namespace reliefui
