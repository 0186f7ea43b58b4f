#include "views/table_figures.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "rendering/skip_ledger.h"
#include "scenario/step_sentence.h"
#include "views/step_table.h"

namespace reliefui {

namespace {

// The words of the pane.
struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::SkippedPanel)
};

QString rounded(double value) {
    return QString::fromStdString(relief::numberText(value, 3));
}

// "1234 of 5678 (22 %)".
QString amount(const relief::SkipRow& row) {
    const QString count = QString::number(row.count, 'f', 0);
    if (!(row.of > 0)) return count;
    return Texts::tr("%1 of %2 (%3 %)")
        .arg(count, QString::number(row.of, 'f', 0))
        .arg(std::lround(100 * row.count / row.of));
}

QString measured(const relief::SkipRow& row, const relief::BoundedError& error) {
    if (row.name == "little-parallax") {
        return Texts::tr("measured: %1 texels in the mean, %2 at most")
            .arg(rounded(error.rayMean), rounded(error.rayMax));
    }
    return Texts::tr("measured: %1 of linear light in the mean, %2 at most")
        .arg(rounded(error.colorMean), rounded(error.colorMax));
}

std::string text(const QVariant& value) {
    return value.toString().toStdString();
}

}  // namespace

TableSource stepTable(const Snapshot& snapshot, relief::Language language) {
    Style style;
    style.language = language;
    StepModel model;
    model.show(std::make_shared<const Snapshot>(snapshot), style);
    TableSource table;
    for (int c = 0; c < StepModel::Columns; ++c) {
        table.titles.push_back(text(model.headerData(c, Qt::Horizontal, Qt::DisplayRole)));
        table.numbers.push_back(c != StepModel::Decision);
    }
    table.marked = StepModel::Decision;
    const auto& steps = snapshot.trace.steps;
    if (steps.empty() || snapshot.trace.hidden) return table;
    const auto chosen =
        static_cast<std::size_t>(std::clamp(snapshot.scenario.step, 0, static_cast<int>(steps.size()) - 1));
    const std::size_t first = steps.size() <= kMostTableRows ? 0
                                                             : std::min(chosen - std::min(chosen, kMostTableRows / 2),
                                                                        steps.size() - kMostTableRows);
    for (std::size_t k = first; k < std::min(steps.size(), first + kMostTableRows); ++k) {
        TableRow row;
        for (int c = 0; c < StepModel::Columns; ++c) {
            row.cells.push_back(text(model.data(model.index(static_cast<int>(k), c), Qt::DisplayRole)));
        }
        row.chosen = k == chosen;
        row.mark = steps[k].decision;
        table.rows.push_back(std::move(row));
    }
    const PixelTrace& trace = snapshot.trace;
    table.below = relief::sentence(relief::stepSentence(steps, chosen, trace.ray, trace.exact), language);
    if (relief::answerError(trace.hit, trace.exact, trace.ray) > relief::kSameAnswer) {
        table.below += ' ' + relief::sentence(relief::answerSentence(trace.hit, trace.exact, trace.ray), language);
    }
    return table;
}

TableSource skippedTable(const Snapshot& snapshot, relief::Language language) {
    TableSource table;
    table.titles = {text(Texts::tr("Not computed")), text(Texts::tr("How many")), text(Texts::tr("Why"))};
    table.numbers = {false, false, false};
    if (!snapshot.request || !snapshot.frame) return table;
    const auto words = [&](const relief::Message& message) { return relief::sentence(message, language); };
    const double bound = snapshot.request->bounded;
    const QString lossless =
        snapshot.request->skip ? Texts::tr("Lossless: not a bit changes") : Texts::tr("Lossless: off");
    const QString bounded =
        bound > 0 ? Texts::tr("Bounded by %1 texels").arg(rounded(bound)) : Texts::tr("Bounded: off");
    const auto rows = relief::skipLedger(*snapshot.frame, *snapshot.request);
    for (const relief::Ledger ledger : {relief::Ledger::Lossless, relief::Ledger::Bounded}) {
        const bool exact = ledger == relief::Ledger::Lossless;
        TableRow heading;
        heading.heading = true;
        heading.cells = {(exact ? lossless : bounded).toStdString()};
        table.rows.push_back(std::move(heading));
        for (const relief::SkipRow& row : rows) {
            if (row.ledger != ledger) continue;
            std::string why = words(row.why);
            if (!exact && snapshot.bounded && row.count > 0) {
                why += "; " + measured(row, *snapshot.bounded).toStdString();
            }
            TableRow line;
            line.cells = {words(row.what), amount(row).toStdString(), why};
            table.rows.push_back(std::move(line));
        }
    }
    return table;
}

}  // namespace reliefui
