#include "panes/formula/formula_figure.h"

#include "painting/painter.h"
#include "panes/figure_caption.h"
#include "panes/formula/formula_drawing.h"

namespace reliefui {

std::shared_ptr<const Figure> sheetFigure(SheetMaker sheet, FigureCaption caption) {
    const auto paint = [sheet](QPainter& painter, const Box& page, const Style& style) {
        const Drawing drawing = sheet(page.width() / style.pixelsPerPoint() - kFigureMargins, style.language);
        paintFigure(painter, {&drawing}, {}, page, style);
    };
    const auto aspect = [sheet](const FigurePage& page) {
        const double points = page.widthMm / kMmPerPoint - kFigureMargins;
        return (sheet(points, page.style.language).bounds.height() + kFigureMargins) / (points + kFigureMargins);
    };
    return paintedFigure(paint, std::move(caption), aspect);
}

std::shared_ptr<const Figure> formulaFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            std::optional<FormulaPart> part) {
    requireRay("formula", *snapshot);
    const auto sheet = [snapshot, step, part](double points, relief::Language language) {
        std::vector<FormulaGroup> groups = formulas(*snapshot, step, language);
        std::erase_if(groups, [&](const FormulaGroup& group) { return part && group.part != *part; });
        return groups.empty() ? messageDrawing(formulasMissing(*snapshot)) : formulaSheet(groups, points).drawing;
    };
    return sheetFigure(sheet, figureCaption(snapshot, step));
}

}  // namespace reliefui
