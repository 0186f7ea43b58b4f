#include "panes/skipped/skipped_panel.h"

#include <algorithm>

#include <QHeaderView>
#include <QStyledItemDelegate>

#include "panes/skipped/skipped_figure.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

// Rows as high as their wrapped text in the width of its column.
class Wrapped : public QStyledItemDelegate {
  public:
    explicit Wrapped(QTreeWidget* tree) : QStyledItemDelegate(tree), tree_(tree) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        constexpr int kRoom = 8;
        constexpr int kEndless = 10000;
        const bool heading = !index.parent().isValid();
        const int width = heading ? kEndless : tree_->columnWidth(index.column()) - kRoom;
        const QRect text = tree_->fontMetrics().boundingRect(0, 0, width, kEndless, Qt::TextWordWrap,
                                                             index.data(Qt::DisplayRole).toString());
        // A heading spans all columns, so it requires no width.
        return {heading ? 0 : QStyledItemDelegate::sizeHint(option, index).width(), text.height() + 4};
    }

  private:
    QTreeWidget* tree_;
};

}  // namespace

SkippedPanel::SkippedPanel(Workspace* workspace, QWidget* parent) : QTreeWidget(parent), workspace_(workspace) {
    setObjectName(QStringLiteral("skipped"));
    setAccessibleName(tr("Work that the last frame skipped"));
    setHeaderLabels({tr("Not computed"), tr("Count"), tr("Why")});
    setSelectionMode(QAbstractItemView::NoSelection);
    // Reasons are sentences, which are wrapped in a narrow pane.
    setWordWrap(true);
    setItemDelegate(new Wrapped(this));
    setTextElideMode(Qt::ElideNone);
    setIndentation(fontMetrics().averageCharWidth());
    setRootIsDecorated(false);
    connect(workspace_, &Workspace::snapshotChanged, this, &SkippedPanel::refresh);
    connect(workspace_, &Workspace::styleChanged, this, &SkippedPanel::refresh);
    refresh();
}

void SkippedPanel::refresh() {
    const PauseLog::Part part("skipped");
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    clear();
    QTreeWidgetItem* heading = nullptr;
    std::vector<QTreeWidgetItem*> headings;
    for (const TableRow& row : skippedTable(*snapshot, workspace_->style().language).rows) {
        QStringList cells;
        for (const std::string& cell : row.cells) cells << QString::fromStdString(cell);
        if (row.heading) {
            heading = new QTreeWidgetItem(this, cells);
            headings.push_back(heading);
            continue;
        }
        auto* const item = new QTreeWidgetItem(heading, cells);
        item->setToolTip(2, cells.back());
    }
    expandAll();
    for (QTreeWidgetItem* const each : headings) each->setFirstColumnSpanned(true);
    shareWidth();
}

void SkippedPanel::shareWidth() {
    constexpr double kMost = 0.34;  // share of the width for the columns of kinds and amounts
    for (int column = 0; column < 2; ++column) {
        resizeColumnToContents(column);
        setColumnWidth(column, std::min(columnWidth(column), static_cast<int>(kMost * viewport()->width())));
    }
    scheduleDelayedItemsLayout();
}

void SkippedPanel::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    shareWidth();
}

}  // namespace reliefui
