#include "windows/skipped_panel.h"

#include <cmath>

#include <QHeaderView>

#include "rendering/skip_ledger.h"
#include "workspace/language.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

QString rounded(double value) {
    return QString::fromStdString(relief::numberText(value, 3));
}

QString words(const relief::Message& message) {
    return QString::fromStdString(relief::sentence(message, uiLanguage()));
}

// "1234 of 5678 (22 %)".
QString amount(const relief::SkipRow& row) {
    const QString count = QString::number(row.count, 'f', 0);
    if (!(row.of > 0)) return count;
    return SkippedPanel::tr("%1 of %2 (%3 %)")
        .arg(count, QString::number(row.of, 'f', 0))
        .arg(std::lround(100 * row.count / row.of));
}

QString measured(const relief::SkipRow& row, const relief::BoundedError& error) {
    if (row.name == "little-parallax") {
        return SkippedPanel::tr("measured: %1 texels in the mean, %2 at most")
            .arg(rounded(error.rayMean), rounded(error.rayMax));
    }
    return SkippedPanel::tr("measured: %1 of linear light in the mean, %2 at most")
        .arg(rounded(error.colorMean), rounded(error.colorMax));
}

}  // namespace

SkippedPanel::SkippedPanel(Workspace* workspace, QWidget* parent) : QTreeWidget(parent), workspace_(workspace) {
    setObjectName(QStringLiteral("skipped"));
    setAccessibleName(tr("What the last frame did not compute"));
    setHeaderLabels({tr("Not computed"), tr("How many"), tr("Why")});
    setSelectionMode(QAbstractItemView::NoSelection);
    setUniformRowHeights(true);
    connect(workspace_, &Workspace::snapshotChanged, this, &SkippedPanel::refresh);
    refresh();
}

void SkippedPanel::refresh() {
    const PauseLog::Part part("skipped");
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    clear();
    const double bound = snapshot->request->bounded;
    auto* const lossless = new QTreeWidgetItem(this, {tr("Lossless: not a bit changes")});
    auto* const bounded =
        new QTreeWidgetItem(this, {bound > 0 ? tr("Bounded by %1 texels").arg(rounded(bound)) : tr("Bounded: off")});
    if (!snapshot->request->skip) lossless->setText(0, tr("Lossless: off"));
    for (const relief::SkipRow& row : relief::skipLedger(*snapshot->frame, *snapshot->request)) {
        const bool exact = row.ledger == relief::Ledger::Lossless;
        QString why = words(row.why);
        if (!exact && snapshot->bounded && row.count > 0)
            why += QStringLiteral("; ") + measured(row, *snapshot->bounded);
        auto* const item = new QTreeWidgetItem(exact ? lossless : bounded, {words(row.what), amount(row), why});
        item->setToolTip(2, why);
    }
    expandAll();
    for (int column = 0; column < 2; ++column) resizeColumnToContents(column);
}

}  // namespace reliefui
