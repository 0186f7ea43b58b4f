#include "panes/formula/formula_pane.h"

#include "panes/formula/formula_figure.h"
#include "panes/formula/formula_view.h"

namespace reliefui {

PaneKind formulaPane() {
    PaneKind kind;
    kind.name = QStringLiteral("formula");
    kind.title = FormulaView::tr("Formulas");
    kind.help = FormulaView::tr("The papers' equations with the values of the chosen pixel and step");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<FormulaView>;
    const auto figure = [&](const char* name, std::optional<FormulaPart> part) {
        kind.figures.push_back(
            {name, true, [part](std::shared_ptr<const Snapshot> snapshot, const relief::Scenario& now) {
                 return formulaFigure(std::move(snapshot), now.step, part);
             }});
    };
    figure("formula", std::nullopt);
    figure("formula-mapping", FormulaPart::Mapping);
    figure("formula-ray", FormulaPart::Ray);
    figure("formula-footprint", FormulaPart::Footprint);
    return kind;
}

}  // namespace reliefui
