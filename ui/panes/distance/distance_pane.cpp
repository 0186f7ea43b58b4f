#include "panes/distance/distance_pane.h"

#include "panes/distance/distance_figure.h"
#include "panes/distance/distance_view.h"

namespace reliefui {

PaneKind distancePane() {
    PaneKind kind;
    kind.name = QStringLiteral("distance");
    kind.title = DistanceView::tr("Distance map");
    kind.tab = DistanceView::tr("Distance map", "tab");
    kind.help = DistanceView::tr("A slice through what the method has stored");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<DistanceView>;
    kind.figures = {{"distance", true, [](std::shared_ptr<const Snapshot> s, int step, const PaneStates& p) {
                         return distanceFigure(std::move(s), step, distanceOptions(p.distance, p.ranges), p.query);
                     }}};
    return kind;
}

}  // namespace reliefui
