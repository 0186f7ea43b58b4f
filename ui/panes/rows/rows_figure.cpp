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

std::shared_ptr<const Figure> rowsFigure(std::shared_ptr<const Snapshot> snapshot, const RowsOptions& options,
                                         const RowsRange& range) {
    using relief::MessageId;
    const std::optional<RowsPlace> place = rowsPlace(*snapshot);
    if (!place)
        throw EmptyFigure("rows", snapshot->scenario.pixel ? MessageId::ExportNoRelief : MessageId::ExportNoPixel);
    const std::vector<relief::RowMethod> methods = rowMethods(options, "--variants");
    if (methods.empty()) throw EmptyFigure("rows", MessageId::DrawRowNoVariant);
    return paintedFigure(
        [place, methods, options, range](QPainter& painter, const Box& page, const Style& style) {
            const RowsData data = rowsData(widened(*place, options.pixels), methods, options.inDouble);
            const double unit = style.pixelsPerPoint();
            const Drawing legend = rowsLegend(data, page.width() / unit - kFigureMargins, style.language);
            const Box room = figureRoom(legend, page, style);
            const RowsFrame frame = rowsFrame(data, options, range, room.width() / unit, room.height() / unit);
            const Drawing axes = rowsAxes(data, frame);
            const Drawing plots = rowsPlots(data, frame);
            paintFigure(painter, {&axes, &plots}, legend, page, style);
        },
        figureCaption(snapshot),
        [](const FigurePage&) {
            constexpr double kAspect = 0.78;  // two plots, and what they cost
            return kAspect;
        });
}

}  // namespace reliefui
