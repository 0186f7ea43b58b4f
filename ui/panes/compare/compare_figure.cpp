#include "panes/compare/compare_figure.h"

#include "painting/painter.h"
#include "panes/compare/compare_painting.h"

namespace reliefui {

namespace {

// Pictures in two columns where there are more than three, with their numbers.
double aspectOf(const Snapshot& snapshot, const ComparedView* view) {
    if (view == nullptr) return kFigureAspect;
    const relief::CompareMode mode = snapshot.scenario.comparison.mode;
    const double picture = static_cast<double>(view->scenario.height) / view->scenario.width;
    const std::size_t count = view->methods.size();
    constexpr double kText = 0.12;
    const bool beside = mode == relief::CompareMode::Tiles || mode == relief::CompareMode::Difference;
    if (!beside) return picture + kText;
    const double columns = count == 4 ? 2 : static_cast<double>(count);
    return picture * (count == 4 ? 2 : 1) / columns + kText;
}

}  // namespace

std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot,
                                            std::shared_ptr<const ComparedView> view, std::size_t shown) {
    return paintedFigure(
        [snapshot, view, shown](QPainter& painter, const Box& page, const Style& style) {
            if (!view) return paintEmpty(painter, relief::MessageId::DrawCompareOne, page, style);
            const relief::Comparison& how = snapshot->scenario.comparison;
            const ComparePage parts = comparePage(compareSource(*view, how, shown), page, style);
            paintCompare(painter, *view, how, parts, page, style, snapshot->scenario.pixel, {});
        },
        [snapshot, view](const FigurePage&) { return aspectOf(*snapshot, view.get()); });
}

std::shared_ptr<const Figure> measuredComparison(std::shared_ptr<const Snapshot> snapshot) {
    std::shared_ptr<const ComparedView> view;
    if (!snapshot->scenario.comparison.others.empty()) {
        relief::Work work;
        Comparer comparer;
        view = withRates(*comparer.view(*snapshot, work), *snapshot, work);
    }
    return compareFigure(std::move(snapshot), std::move(view), 0);
}

}  // namespace reliefui
