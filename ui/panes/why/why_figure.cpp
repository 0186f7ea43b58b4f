#include "panes/why/why_figure.h"

#include "panes/figure_caption.h"
#include "panes/formula/formula_drawing.h"
#include "panes/formula/formula_figure.h"
#include "rendering/pixel_history_text.h"

namespace reliefui {

std::vector<FormulaGroup> whyGroups(const relief::PixelHistory& history, const relief::FrameRequest& request,
                                    relief::Language language) {
    std::vector<FormulaGroup> groups;
    for (const relief::HistoryStation& station : relief::historyStations(history, request)) {
        FormulaGroup group;
        group.title = relief::sentence(station.title, language);
        for (const relief::Message& note : station.notes) {
            group.note += (group.note.empty() ? "" : " ") + relief::sentence(note, language);
        }
        for (const relief::HistoryEquation& row : station.equations) {
            group.rows.push_back({row.formula, row.numbers, row.result, {}, {}});
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

std::shared_ptr<const Figure> whyFigure(std::shared_ptr<const Snapshot> snapshot,
                                        std::shared_ptr<const relief::PixelHistory> history) {
    const auto sheet = [snapshot, history](double points, relief::Language language) {
        return formulaSheet(whyGroups(*history, *snapshot->request, language), points).drawing;
    };
    return sheetFigure(sheet, figureCaption(snapshot));
}

std::shared_ptr<const Figure> whyFigure(std::shared_ptr<const Snapshot> snapshot) {
    if (!snapshot->scenario.pixel) throw EmptyFigure("why", relief::MessageId::ExportNoPixel);
    return computedFigure([snapshot](const FigurePage&, relief::Work& work) {
        const relief::PixelChoice pixel = *snapshot->scenario.pixel;
        return whyFigure(snapshot, std::make_shared<const relief::PixelHistory>(relief::pixelHistory(
                                       *snapshot->request, pixel.x, pixel.y, snapshot->maps, work)));
    });
}

}  // namespace reliefui
