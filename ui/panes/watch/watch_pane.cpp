#include "panes/watch/watch_pane.h"

#include "panes/watch/watch_figure.h"
#include "panes/watch/watch_view.h"

namespace reliefui {

PaneKind watchPane() {
    PaneKind kind;
    kind.name = QStringLiteral("watch");
    kind.title = WatchView::tr("Watch");
    kind.help = WatchView::tr("Values of the steps as graphs, with the current step; runs to the next change of one");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<WatchView>;
    kind.figures = {{"watch", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return watchFigure(std::move(s), now.step, stateOf<WatchPane>(now));
                     }}};
    kind.states = {readerOf<WatchPane>()};
    kind.open = false;  // opened from the menu or by its key: there is no room for more tabs at 1280 pixels
    return kind;
}

}  // namespace reliefui
