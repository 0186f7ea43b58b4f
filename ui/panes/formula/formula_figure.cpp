#include "panes/formula/formula_figure.h"

#include "painting/painter.h"
#include "panes/formula/formula_drawing.h"

namespace reliefui {

namespace {

struct FormulaFigure : Figure {
    std::shared_ptr<const Snapshot> snapshot;
    std::optional<FormulaPart> part;

    Drawing sheet(double points, relief::Language language) const {
        std::vector<FormulaGroup> groups = formulas(*snapshot, language);
        std::erase_if(groups, [&](const FormulaGroup& group) { return part && group.part != *part; });
        return groups.empty() ? Drawing() : formulaSheet(groups, points).drawing;
    }
    double aspect(const FigurePage& page) const override {
        const double points = page.widthMm / kMmPerPoint - kFigureMargins;
        const double height = sheet(points, page.style.language).bounds.height();
        // Nothing but a sentence, else.
        return height > 0 ? (height + kFigureMargins) / (points + kFigureMargins) : Figure::aspect(page);
    }
    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        const Drawing drawing = sheet(page.width() / style.pixelsPerPoint() - kFigureMargins, style.language);
        if (drawing.items.empty()) return paintEmpty(painter, formulasMissing(*snapshot), page, style);
        paintFigure(painter, {&drawing}, {}, page, style);
    }
};

}  // namespace

std::shared_ptr<const Figure> formulaFigure(std::shared_ptr<const Snapshot> snapshot, std::optional<FormulaPart> part) {
    auto figure = std::make_shared<FormulaFigure>();
    figure->snapshot = std::move(snapshot);
    figure->part = part;
    return figure;
}

}  // namespace reliefui
