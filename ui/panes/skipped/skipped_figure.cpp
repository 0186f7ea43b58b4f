#include "panes/skipped/skipped_figure.h"

#include <cmath>

#include <QCoreApplication>

#include "panes/figure_caption.h"
#include "rendering/skip_ledger.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// Translation context of the pane's texts.
struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::SkippedPanel)
};

QString rounded(double value) {
    return QString::fromStdString(relief::numberText(value, 3));
}

// Formats "1234 of 5678 (22 %)".
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

}  // namespace

TableSource skippedTable(const Snapshot& snapshot, relief::Language language) {
    TableSource table;
    table.titles = {Texts::tr("Not computed").toStdString(), Texts::tr("Count").toStdString(),
                    Texts::tr("Why").toStdString()};
    table.numbers = {false, false, false};
    if (!snapshot.request || !snapshot.frame) return table;
    const auto words = [&](const relief::Message& message) { return relief::sentence(message, language); };
    const double bound = snapshot.request->bounded;
    const QString lossless =
        snapshot.request->skip ? Texts::tr("Lossless: the picture does not change") : Texts::tr("Lossless: off");
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

std::shared_ptr<const Figure> skippedFigure(std::shared_ptr<const Snapshot> snapshot) {
    return tableFigure([snapshot](relief::Language language) { return skippedTable(*snapshot, language); },
                       figureCaption(snapshot));
}

}  // namespace reliefui
