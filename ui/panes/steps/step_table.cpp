#include "panes/steps/step_table.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTimer>

#include "painting/painter.h"
#include "panes/file_dialogs.h"
#include "panes/steps/step_sentence.h"
#include "scenario/ray_files.h"
#include "scenario/step_sentence.h"
#include "workspace/language.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

// The decision's colour and shape; colour is never the only cue.
QPixmap symbol(relief::Decision decision, const Style& style, int side) {
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color = toColor(style.color(roleOf(decision)));
    painter.setPen(QPen(color, side / 8.0));
    painter.setBrush(color);
    const double m = side * 0.2;
    const double n = side - m;
    const double c = side / 2.0;
    switch (shapeOf(decision)) {
        case Shape::Bar:
            painter.drawRect(QRectF(m, c - side * 0.12, n - m, side * 0.24));
            break;
        case Shape::TriangleRight:
            painter.drawPolygon(QPolygonF(QVector<QPointF>{{m, m}, {n, c}, {m, n}}));
            break;
        case Shape::TriangleDown:
            painter.drawPolygon(QPolygonF(QVector<QPointF>{{m, m}, {n, m}, {c, n}}));
            break;
        case Shape::TriangleUpHollow:
            painter.setBrush(Qt::NoBrush);
            painter.drawPolygon(QPolygonF(QVector<QPointF>{{m, n}, {n, n}, {c, m}}));
            break;
        case Shape::Diamond:
            painter.drawPolygon(QPolygonF(QVector<QPointF>{{c, m}, {n, c}, {c, n}, {m, c}}));
            break;
        case Shape::Cross:
            painter.drawLine(QPointF(m, m), QPointF(n, n));
            painter.drawLine(QPointF(m, n), QPointF(n, m));
            break;
        case Shape::Ring:
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(QPointF(c, c), c - m, c - m);
            break;
        case Shape::SquareHollow:
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(QRectF(m, m, n - m, n - m));
            break;
        case Shape::Dot:
        case Shape::DotSmall:
            painter.drawEllipse(QPointF(c, c), side * 0.25, side * 0.25);
            break;
    }
    return pixmap;
}

}  // namespace

void StepModel::show(std::shared_ptr<const Snapshot> snapshot, const Style& style) {
    beginResetModel();
    snapshot_ = std::move(snapshot);
    style_ = style;
    endResetModel();
}

int StepModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !snapshot_ ? 0 : static_cast<int>(snapshot_->trace.steps.size());
}

int StepModel::columnCount(const QModelIndex& parent) const {
    const int further = snapshot_ ? static_cast<int>(snapshot_->trace.further.size()) : 0;
    return parent.isValid() ? 0 : Columns + further;
}

const relief::FurtherColumn* StepModel::further(int column) const {
    return column < Columns ? nullptr : &snapshot_->trace.further[static_cast<std::size_t>(column - Columns)];
}

QString StepModel::text(const relief::Step& step, int row, int column) const {
    const QString arrow = QStringLiteral(" → ");
    const auto number = [this](double value) { return text(value); };
    switch (column) {
        case Number:
            return QString::number(row + 1);
        case Level:
            return QString::number(step.level);
        case Texel:
            return QStringLiteral("(%1, %2)").arg(step.i).arg(step.j);
        case Lambda:
            return number(step.lambdaIn) + arrow + number(step.lambdaOut);
        case Height:
            return number(step.zIn()) + arrow + number(step.zOut());
        case Value:
            return number(step.value);
        case Decision:
            return QString::fromStdString(relief::sentence(relief::decisionTitle(step.decision), style_.language));
        default:
            return number(step.lambdaAfter);
    }
}

// Large type has no room for the fourth digit.
QString StepModel::text(double value) const {
    return QString::fromStdString(relief::fixedText(value, style_.projector ? 3 : 4));
}

double StepModel::sortKey(const relief::Step& step, int row, int column) const {
    switch (column) {
        case Number:
            return row;
        case Level:
            return step.level;
        case Texel:
            // Sorted by rows of texels.
            return static_cast<double>(step.j) * 0x1p26 + static_cast<double>(step.i);
        case Lambda:
            return step.lambdaIn;
        case Height:
            return step.zIn();
        case Value:
            return step.value;
        case Decision:
            return static_cast<double>(step.decision);
        default:
            return step.lambdaAfter;
    }
}

QVariant StepModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    if (const relief::FurtherColumn* const column = further(index.column())) {
        const QString cell = QString::fromStdString(column->cells[static_cast<std::size_t>(index.row())]);
        if (role == Qt::DisplayRole) return cell;
        if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
        if (role != kSortRole) return {};
        bool isNumber = false;
        const double number = cell.toDouble(&isNumber);
        return isNumber ? QVariant(number) : QVariant(cell);
    }
    const relief::Step& step = snapshot_->trace.steps[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole) return text(step, index.row(), index.column());
    if (role == kSortRole) return sortKey(step, index.row(), index.column());
    if (role == Qt::DecorationRole && index.column() == Decision) return symbol(step.decision, style_, 14);
    if (role == Qt::TextAlignmentRole) {
        return static_cast<int>((index.column() == Decision ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    return {};
}

QVariant StepModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (const relief::FurtherColumn* const column = further(section)) {
        if (role == Qt::DisplayRole) return QString::fromStdString(column->name);
        return role == Qt::ToolTipRole ? QVariant(tr("column of the other program's file")) : QVariant();
    }
    const QString titles[Columns] = {
        tr("#"),     tr("level"),    tr("texel"),  tr("λ in → out"), tr("ray height in → out"),
        tr("value"), tr("decision"), tr("λ after")};
    if (role == Qt::DisplayRole) return titles[section];
    if (role != Qt::ToolTipRole) return {};
    const QString help[Columns] = {tr("number of the step"),
                                   tr("level of the pyramid, 0 the finest"),
                                   tr("texel of that level (cell of the surface on level 0)"),
                                   tr("descent of the ray, 0 the top of the slab, 1 its bottom"),
                                   tr("height of the ray, 1 the top of the slab"),
                                   tr("the stored value that decided, here the maximum of the texel"),
                                   tr("decision of the tracer"),
                                   tr("where the ray continued")};
    return help[section];
}

StepTable::StepTable(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      model_(new StepModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)),
      sentence_(new StepSentence(workspace, this)) {
    setAccessibleName(tr("Steps"));
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(StepModel::kSortRole);
    table_->setModel(sorted_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(StepModel::Number, Qt::AscendingOrder);
    table_->setAccessibleName(tr("Table of steps"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* const copy = new QAction(tr("Copy rows"), table_);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    copy->setToolTip(QStringLiteral("%1 (%2)").arg(copy->text(), copy->shortcut().toString(QKeySequence::NativeText)));
    auto* const save = new QAction(tr("Export steps as CSV..."), table_);
    table_->addActions({copy, save});
    connect(copy, &QAction::triggered, this, &StepTable::copyRows);
    connect(save, &QAction::triggered, this, &StepTable::exportRows);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(table_, 3);
    row->addWidget(sentence_, 2);
    connect(workspace_, &Workspace::snapshotChanged, this, &StepTable::refresh);
    connect(workspace_, &Workspace::stepChanged, this, &StepTable::followStep);
    connect(workspace_, &Workspace::styleChanged, this, &StepTable::refresh);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current, const QModelIndex&) {
                if (!following_ && current.isValid()) workspace_->chooseStep(stepOf(current));
            });
    refresh();
}

QString StepTable::sentence() const {
    return sentence_->text();
}

void StepTable::applyStyle() {
    QFont font = this->font();
    font.setPointSizeF(Style::kTextPoints * workspace_->style().scale());
    table_->setFont(font);
    table_->verticalHeader()->setDefaultSectionSize(QFontMetrics(font).height() + 4);
}

void StepTable::refresh() {
    const PauseLog::Part part("steps");
    following_ = true;
    applyStyle();
    model_->show(workspace_->snapshot(), workspace_->style());
    following_ = false;
    shareColumns();
    followStep(workspace_->scenario().step);
}

// Column widths from typical text lengths (not measured, because there may be hundreds of thousands of rows) and
// titles. If there is not enough room, columns are hidden instead of cut, starting with those whose content also
// appears in the next row, the profile or the sentence.
void StepTable::shareColumns() {
    const QFontMetrics metrics(table_->font());
    const int letter = metrics.horizontalAdvance(QLatin1Char('0'));
    const int shorter = workspace_->style().projector ? 1 : 0;  // one digit less per number
    constexpr int kFurtherLetters = 8;
    const int letters[StepModel::Columns] = {4,           4,  12,         15 - 2 * shorter, 15 - 2 * shorter,
                                             7 - shorter, 12, 7 - shorter};
    int widths[StepModel::Columns] = {};
    int all = 0;
    for (int c = 0; c < StepModel::Columns; ++c) {
        const QString title = model_->headerData(c, Qt::Horizontal, Qt::DisplayRole).toString();
        widths[c] = std::max(letters[c] * letter, metrics.horizontalAdvance(title)) + 2 * letter;
        all += widths[c];
    }
    for (int c = StepModel::Columns; c < model_->columnCount(); ++c) {
        const QString title = model_->headerData(c, Qt::Horizontal, Qt::DisplayRole).toString();
        const int width = std::max(kFurtherLetters * letter, metrics.horizontalAdvance(title)) + 2 * letter;
        table_->setColumnWidth(c, width);
        all += width;
    }
    const int room = table_->viewport()->width();
    bool shown[StepModel::Columns];
    std::fill(std::begin(shown), std::end(shown), true);
    // Where a map takes the ray beyond the cell of a step, only the last column tells how far.
    const auto beyond = [](const relief::Step& s) { return s.trustsMap() && s.lambdaAfter > s.lambdaOut; };
    const auto snapshot = workspace_->snapshot();
    const bool gaps = snapshot && std::any_of(snapshot->trace.steps.begin(), snapshot->trace.steps.end(), beyond);
    const int first = gaps ? StepModel::Height : StepModel::After;
    const int second = gaps ? StepModel::After : StepModel::Height;
    for (const int least : {first, second, int{StepModel::Value}, int{StepModel::Texel}}) {
        if (all <= room) break;
        shown[least] = false;
        all -= widths[least];
    }
    for (int c = 0; c < StepModel::Columns; ++c) {
        table_->setColumnHidden(c, !shown[c]);
        table_->setColumnWidth(c, widths[c]);
    }
}

void StepTable::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Delayed until the table has its final size; keeps the chosen row visible.
    QTimer::singleShot(0, this, [this] {
        shareColumns();
        table_->scrollTo(table_->currentIndex());
    });
}

void StepTable::followStep(int step) {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || snapshot->trace.steps.empty()) return;
    const QModelIndex index = indexOf(std::clamp(step, 0, static_cast<int>(snapshot->trace.steps.size()) - 1));
    // The step was chosen in the table: making its row current again would undo the selection of several rows.
    if (table_->currentIndex().row() == index.row()) return;
    following_ = true;
    table_->setCurrentIndex(index);
    table_->scrollTo(index);
    following_ = false;
}

QModelIndex StepTable::indexOf(int step) const {
    return sorted_->mapFromSource(model_->index(step, 0));
}

int StepTable::stepOf(const QModelIndex& index) const {
    return sorted_->mapToSource(index).row();
}

void StepTable::copyRows() {
    QModelIndexList rows = table_->selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    QString text;
    for (const QModelIndex& row : rows) {
        QStringList cells;
        for (int c = 0; c < model_->columnCount(); ++c) {
            cells << sorted_->data(sorted_->index(row.row(), c), Qt::DisplayRole).toString();
        }
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

void StepTable::exportRows() {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    const QString path = askSaveFile(this, QStringLiteral("tables"), tr("Export steps"), QStringLiteral("steps.csv"),
                                     tr("Tables (*.csv)"));
    if (path.isEmpty()) return;
    relief::StepLog log;
    log.steps = snapshot->trace.steps;
    log.begin.push_back(log.steps.size());
    std::string text = std::string(relief::kStepsHeader) + "\n";
    relief::appendStepLines(text, log, 0, 0);
    try {
        relief::writeTextFile(path.toStdString(), text);
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
    }
}

}  // namespace reliefui
