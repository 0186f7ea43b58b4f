#include "panes/compare/compare_figure.h"

#include "painting/painter.h"
#include "panes/compare/compare_painting.h"
#include "panes/figure_caption.h"

namespace reliefui {

namespace {

// Four pictures are placed in two columns.
int columnsOf(const CompareSource& source) {
    const bool beside = source.mode == relief::CompareMode::Tiles || source.mode == relief::CompareMode::Difference;
    const auto count = static_cast<int>(source.tiles.size());
    return !beside ? 1 : count == 4 ? 2 : count;
}

// Width, in points, available for pictures and text on this page, and their height including the legend.
double roomOf(const FigurePage& page) {
    return page.widthMm / kMmPerPoint - kFigureMargins;
}
double heightOf(const CompareSource& source, const FigurePage& page) {
    const double width = roomOf(page);
    const relief::Language language = page.style.language;
    const double legend = compareLegend(source, width, language).bounds.height();
    // The width is rounded to whole pixels, which must not make the pictures narrower.
    const double pixel = page.widthMm / kMmPerPoint / page.pixels();
    return compareHeight(source, width, language) + legend + kFigureMargins + kFigureMargin + pixel;
}

FigureCaption captionOf(std::shared_ptr<const Snapshot> snapshot) {
    const relief::Scenario& scenario = snapshot->scenario;
    const relief::CompareSubject subject = scenario.comparison.subject;
    std::string names;
    for (const relief::MethodChoice& choice : relief::comparedOf(scenario)) {
        names += (names.empty() ? "" : ", ") + relief::variationText(subject, choice);
    }
    const bool methods = subject == relief::CompareSubject::Methods;
    const bool filters = subject == relief::CompareSubject::Filters;
    FigureCaption all = figureCaption(snapshot, {}, methods ? names : std::string(), filters ? names : std::string());
    return [all = std::move(all), width = scenario.width, height = scenario.height](relief::Language language) {
        const relief::Message redrawn(relief::MessageId::CaptionCompared, {{"width", width}, {"height", height}});
        return all(language) + " · " + relief::sentence(redrawn, language);
    };
}

}  // namespace

std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot,
                                            std::shared_ptr<const ComparedView> view, std::size_t shown) {
    if (relief::comparedOf(snapshot->scenario).size() == 1) {
        const bool methods = snapshot->scenario.comparison.subject == relief::CompareSubject::Methods;
        throw EmptyFigure("compare", methods ? relief::MessageId::ExportNoMethods : relief::MessageId::ExportNoOthers);
    }
    return computedFigure([snapshot, view, shown](const FigurePage& requested, relief::Work& work) {
        auto measured = view;
        if (!measured) measured = withRates(*Comparer().view(*snapshot, nullptr, {}, work), *snapshot, work);
        CompareSource source = compareSource(*measured, snapshot->scenario, shown);
        source.columns = columnsOf(source);
        const double height = heightOf(source, requested);
        // Width of a picture in the final layout.
        const double width =
            compareLayout(source, roomOf(requested), height, requested.style.language).rooms[0].width();
        const std::vector<QImage> pictures =
            redrawnPictures(*measured, *snapshot, requested.picturePixels(width), work);
        const auto paint = [snapshot, source, pictures](QPainter& painter, const Box& page, const Style& style) {
            paintRedrawn(painter, pictures, comparePage(source, page, style, true), page, style, snapshot->scenario);
        };
        return paintedFigure(paint, captionOf(snapshot), [source](const FigurePage& page) {
            return heightOf(source, page) / (page.widthMm / kMmPerPoint);
        });
    });
}

}  // namespace reliefui
