#include "panes/table_figure.h"

#include <algorithm>

#include "painting/painter.h"

namespace reliefui {

std::shared_ptr<const Figure> tableFigure(TableMaker table, FigureCaption caption) {
    const auto aspect = [table](const FigurePage& page) {
        const double points = page.widthMm / kMmPerPoint - kFigureMargins;
        const Drawing drawing = tableDrawing(table(page.style.language), points);
        // A table that is wider than the page is scaled to fit.
        const double height = drawing.bounds.height() * points / std::max(drawing.bounds.width(), 1.0);
        return (height + kFigureMargins) / (points + kFigureMargins);
    };
    const auto paint = [table](QPainter& painter, const Box& page, const Style& style) {
        const double points = page.width() / style.pixelsPerPoint() - kFigureMargins;
        const Drawing drawing = tableDrawing(table(style.language), points);
        paintFigure(painter, {&drawing}, {}, page, style);
    };
    return paintedFigure(paint, std::move(caption), aspect);
}

}  // namespace reliefui
