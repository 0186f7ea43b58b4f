#include "panes/compare/compare_figure.h"

#include <cmath>
#include <mutex>

#include "panes/compare/compare_painting.h"
#include "panes/figure_caption.h"
#include "workspace/resized_snapshot.h"

namespace reliefui {

namespace {

// Pictures in two columns where there are four.
std::size_t columnsOf(const relief::Comparison& how) {
    const std::size_t count = relief::othersOf(how).size() + 1;
    const bool beside = how.mode == relief::CompareMode::Tiles || how.mode == relief::CompareMode::Difference;
    return !beside ? 1 : count == 4 ? 2 : count;
}

double aspectOf(const Snapshot& snapshot) {
    const relief::Comparison& how = snapshot.scenario.comparison;
    const double picture = static_cast<double>(snapshot.scenario.height) / snapshot.scenario.width;
    constexpr double kText = 0.12;
    const auto columns = static_cast<double>(columnsOf(how));
    return picture * (columns == 2 && relief::othersOf(how).size() == 3 ? 2 : 1) / columns + kText;
}

// The comparison in the size that was painted last.
struct Redrawn {
    std::mutex mutex;
    int width = 0;
    std::shared_ptr<const Snapshot> snapshot;
    std::shared_ptr<const ComparedView> view;

    void make(const std::shared_ptr<const Snapshot>& of, int pixels) {
        if (pixels == width && view) return;
        relief::Work work;
        Comparer comparer;
        snapshot = resized(of, pixels, work);
        view = withRates(*comparer.view(*snapshot, nullptr, {}, work), *snapshot, work);
        width = pixels;
    }
};

}  // namespace

std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot, std::size_t shown) {
    const relief::CompareSubject subject = snapshot->scenario.comparison.subject;
    const std::vector<relief::MethodChoice> all = relief::comparedOf(snapshot->scenario);
    const bool methods = subject == relief::CompareSubject::Methods;
    const bool filters = subject == relief::CompareSubject::Filters;
    if (all.size() == 1) {
        emptyFigure("compare", methods ? relief::MessageId::ExportNoMethods : relief::MessageId::ExportNoOthers);
    }
    std::string names;
    for (const relief::MethodChoice& choice : all) {
        names += (names.empty() ? "" : ", ") + relief::variationText(subject, choice);
    }
    const auto paint = [snapshot, shown, redrawn = std::make_shared<Redrawn>()](QPainter& painter, const Box& page,
                                                                                const Style& style) {
        const std::scoped_lock lock(redrawn->mutex);
        const auto columns = static_cast<double>(columnsOf(snapshot->scenario.comparison));
        redrawn->make(snapshot, style.picturePixels(page.width() / columns));
        const Snapshot& drawn = *redrawn->snapshot;
        const relief::Comparison& how = drawn.scenario.comparison;
        const ComparePage parts = comparePage(compareSource(*redrawn->view, drawn.scenario, shown), page, style);
        paintCompare(painter, *redrawn->view, how, parts, page, style, drawn.scenario.pixel, {});
    };
    return paintedFigure(
        paint,
        redrawnCaption(figureCaption(snapshot, {}, methods ? names : std::string(), filters ? names : std::string())),
        [snapshot](const FigurePage&) { return aspectOf(*snapshot); });
}

}  // namespace reliefui
