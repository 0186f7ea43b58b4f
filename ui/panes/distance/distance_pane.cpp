#include "panes/distance/distance_pane.h"

#include "panes/distance/distance_figure.h"
#include "panes/distance/distance_state.h"
#include "panes/distance/distance_view.h"
#include "panes/point_state.h"
#include "workspace/annotation_state.h"
#include "workspace/range_json.h"

namespace reliefui {

PaneKind distancePane() {
    PaneKind kind;
    kind.name = QStringLiteral("distance");
    kind.title = DistanceView::tr("Distance map");
    kind.tab = DistanceView::tr("Distance map", "tab");
    kind.help = DistanceView::tr("A slice through the map that the method uses");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<DistanceView>;
    kind.figures = {{"distance", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return distanceFigure(std::move(s), now.step,
                                               distanceOptions(stateOf<DistancePane>(now), rangesOf(now)),
                                               stateOf<PointState>(now).point, stateOf<AnnotationState>(now).list);
                     }}};
    kind.states = {readerOf<DistancePane>(), readerOf<PointState>()};
    return kind;
}

}  // namespace reliefui
