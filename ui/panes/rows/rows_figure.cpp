#include "panes/rows/rows_figure.h"

#include "painting/painter.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::optional<RowsPlace> rowsPlace(const Snapshot& s) {
    if (!s.scenario.pixel || !s.frame || s.coarse) return std::nullopt;
    const relief::PixelChoice pixel = *s.scenario.pixel;
    const relief::VisiblePolygons visible = s.frame->visible(*s.request);
    const relief::VisiblePolygon* polygon = visible.at(pixel.x, pixel.y, s.frame->width);
    if (polygon == nullptr) return std::nullopt;
    RowsPlace place;
    place.map = polygon->texelFromScreen;
    place.y = pixel.y + 0.5;
    place.line = pixel.y;
    place.span = polygon->span(pixel.y, s.frame->width);
    place.width = s.frame->width;
    place.chosen = pixel.x;
    return place;
}

RowsOptions rowsOptions(const RowsPane& pane) {
    return {pane.variants, pane.pixels, pane.inDouble, pane.logarithmic};
}

RowsPane paneOf(const RowsOptions& options) {
    return {options.methods, options.pixels, options.inDouble, options.logarithmic};
}

RowsData rowsOf(const Snapshot& snapshot, const RowsOptions& options, const char* figure) {
    using relief::MessageId;
    const std::optional<RowsPlace> place = rowsPlace(snapshot);
    if (!place)
        throw EmptyFigure(figure, snapshot.scenario.pixel ? MessageId::ExportNoRelief : MessageId::ExportNoPixel);
    const std::vector<relief::RowMethod> methods = rowMethods(options, "--variants");
    if (methods.empty()) throw EmptyFigure(figure, MessageId::DrawRowNoVariant);
    return rowsData(widened(*place, options.pixels), methods, options.inDouble);
}

std::shared_ptr<const Figure> rowsFigure(std::shared_ptr<const Snapshot> snapshot, const RowsOptions& options,
                                         const RowsRange& range) {
    const auto data = std::make_shared<const RowsData>(rowsOf(*snapshot, options, "rows"));
    const auto legend = [data](double width, relief::Language language) { return rowsLegend(*data, width, language); };
    const auto layers = [data, options, range](double width, double height, const Style&) {
        const RowsFrame frame = rowsFrame(*data, options, range, width, height);
        return std::vector{rowsAxes(*data, frame), rowsPlots(*data, frame)};
    };
    constexpr double kAspect = 0.78;  // for two plots and the table of costs
    return chartFigure({legend, layers, kAspect, kAspect - 0.15}, figureCaption(snapshot));
}

}  // namespace reliefui
