#include "panes/result/result_pane.h"

#include "panes/result/result_figure.h"
#include "panes/result/result_view.h"
#include "workspace/annotation_state.h"

namespace reliefui {

PaneKind resultPane() {
    PaneKind kind;
    kind.name = QStringLiteral("result");
    kind.title = ResultView::tr("Result");
    kind.help = ResultView::tr("The picture or one of its layers; choose a pixel to see how it was computed");
    kind.place = DockPlace::Center;
    kind.make = makePane<ResultView>;
    kind.figures = {{"result", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return resultFigure(std::move(s), stateOf<AnnotationState>(now).list);
                     }}};
    return kind;
}

}  // namespace reliefui
