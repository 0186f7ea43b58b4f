#include "panes/table_figure.h"

#include <algorithm>

#include "painting/painter.h"

namespace reliefui {

namespace {

struct TableFigure : Figure {
    TableMaker table;

    double aspect(const FigurePage& page) const override {
        const double points = page.widthMm / kMmPerPoint - kFigureMargins;
        const Drawing drawing = tableDrawing(table(page.style.language), points);
        // A table that wants more room is fitted into the page.
        const double height = drawing.bounds.height() * points / std::max(drawing.bounds.width(), 1.0);
        return (height + kFigureMargins) / (points + kFigureMargins);
    }
    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        const double points = page.width() / style.pixelsPerPoint() - kFigureMargins;
        const Drawing drawing = tableDrawing(table(style.language), points);
        paintFigure(painter, {&drawing}, {}, page, style);
    }
};

}  // namespace

std::shared_ptr<const Figure> tableFigure(TableMaker table) {
    auto figure = std::make_shared<TableFigure>();
    figure->table = std::move(table);
    return figure;
}

}  // namespace reliefui
