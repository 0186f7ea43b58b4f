#include "panes/watch/watch_figure.h"

#include <algorithm>

#include "panes/figure_caption.h"
#include "panes/watch/watch_drawing.h"

namespace reliefui {

std::shared_ptr<const Figure> watchFigure(std::shared_ptr<const Snapshot> snapshot, int step, const WatchPane& pane) {
    requireRay("watch", *snapshot);
    if (pane.values.empty()) throw EmptyFigure("watch", relief::MessageId::WatchNothing);
    const auto layers = [snapshot, step, pane](double width, double height, const Style& style) {
        const std::vector<WatchRow> rows = watchRows(snapshot->trace, pane);
        const WatchFrame frame = watchFrame(rows, snapshot->trace.steps.size(), width, height);
        return std::vector{watchDrawing(rows, frame, static_cast<std::size_t>(std::max(0, step)),
                                        static_cast<std::size_t>(pane.chosen), style.language)};
    };
    const auto legend = [](double, relief::Language) { return Drawing(); };
    constexpr double kRow = 0.11;  // height of a row / width of the page
    const double aspect = kRow * static_cast<double>(pane.values.size()) + 0.05;
    return chartFigure({legend, layers, aspect, aspect}, figureCaption(snapshot, step));
}

}  // namespace reliefui
