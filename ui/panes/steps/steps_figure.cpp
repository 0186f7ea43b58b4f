#include "panes/steps/steps_figure.h"

#include <algorithm>

#include "panes/figure_caption.h"
#include "panes/steps/step_table.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

std::string text(const QVariant& value) {
    return value.toString().toStdString();
}

}  // namespace

TableSource stepTable(const std::shared_ptr<const Snapshot>& shown, int step, relief::Language language) {
    Style style;
    style.language = language;
    StepModel model;
    model.show(shown, style);
    const PixelTrace& trace = shown->trace;
    TableSource table;
    const int columns = model.columnCount();
    for (int c = 0; c < columns; ++c) {
        table.titles.push_back(text(model.headerData(c, Qt::Horizontal, Qt::DisplayRole)));
        table.numbers.push_back(c != StepModel::Decision);
    }
    table.marked = StepModel::Decision;
    // The ray's height is 1 - lambda, and most steps end where the next one begins.
    table.spare = {StepModel::Height, StepModel::After};
    const auto& steps = trace.steps;
    if (steps.empty() || trace.hidden) return table;
    const auto chosen = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps.size()) - 1));
    const std::size_t first = steps.size() <= kMostTableRows ? 0
                                                             : std::min(chosen - std::min(chosen, kMostTableRows / 2),
                                                                        steps.size() - kMostTableRows);
    for (std::size_t k = first; k < std::min(steps.size(), first + kMostTableRows); ++k) {
        TableRow row;
        for (int c = 0; c < columns; ++c) {
            row.cells.push_back(text(model.data(model.index(static_cast<int>(k), c), Qt::DisplayRole)));
        }
        row.chosen = k == chosen;
        row.mark = steps[k].decision;
        table.rows.push_back(std::move(row));
    }
    table.below = relief::sentence(relief::stepSentence(steps, chosen, trace.ray, trace.exact), language);
    if (relief::answerError(trace.hit, trace.exact, trace.ray) > relief::kSameAnswer) {
        table.below += ' ' + relief::sentence(relief::answerSentence(trace.hit, trace.exact, trace.ray), language);
    }
    return table;
}

std::shared_ptr<const Figure> stepsFigure(std::shared_ptr<const Snapshot> snapshot, int step) {
    requireRay("steps", *snapshot);
    return tableFigure([snapshot, step](relief::Language language) { return stepTable(snapshot, step, language); },
                       figureCaption(snapshot, step));
}

}  // namespace reliefui
