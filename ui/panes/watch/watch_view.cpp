#include "panes/watch/watch_view.h"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/drawing_canvas.h"
#include "panes/pane_controls.h"
#include "panes/watch/watch_figure.h"
#include "relief/errors.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

WatchView::WatchView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Watch"), QStringLiteral("watch"), tr("Export the watched values"), parent),
      canvas_(new DrawingCanvas(this)) {
    setFace(canvas_);
    makeBar();
    connect(canvas_, &DrawingCanvas::clickedAt, this, &WatchView::choose);
    connect(canvas_, &DrawingCanvas::pointed, this, &WatchView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &WatchView::refresh);
    connect(workspace_, &Workspace::panesChanged, this, &WatchView::adopt);
    connect(workspace_, &Workspace::stepChanged, this, &WatchView::draw);
    connect(workspace_, &Workspace::styleChanged, this, &WatchView::refresh);
    pane_ = stateOf<WatchPane>(workspace_->scenario());
    refresh();
}

void WatchView::makeBar() {
    auto* const bar = new QHBoxLayout;
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(canvas_, 1);
    bar->setContentsMargins(4, 2, 6, 2);
    names_ = new QComboBox(this);
    names_->setObjectName(QStringLiteral("watch-value"));
    names_->setEditable(true);
    names_->setInsertPolicy(QComboBox::NoInsert);
    names_->setAccessibleName(tr("Value to watch"));
    names_->setToolTip(tr("Column of the steps, or an expression over them such as z_out - value; Enter adds it"));
    names_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    names_->setMinimumContentsLength(14);
    bar->addWidget(names_, 1);
    auto* const plus = addToolButton(bar, QStringLiteral("+"), tr("Watch this value"));
    plus->setObjectName(QStringLiteral("watch-add"));
    remove_ = addToolButton(bar, QStringLiteral("×"), tr("Stop watching the chosen value"));
    remove_->setObjectName(QStringLiteral("watch-remove"));
    bar->addStretch(1);
    connect(plus, &QToolButton::clicked, this, [this] { watch(names_->currentText()); });
    connect(names_->lineEdit(), &QLineEdit::returnPressed, this, [this] { watch(names_->currentText()); });
    connect(remove_, &QToolButton::clicked, this, &WatchView::removeChosen);
}

void WatchView::change(const WatchPane& pane) {
    workspace_->change(withState(workspace_->scenario(), pane), changeName([] { return tr("Watch: other values"); }));
    adopt();
}

void WatchView::adopt() {
    const auto pane = stateOf<WatchPane>(workspace_->scenario());
    if (pane == pane_) return;
    pane_ = pane;
    refresh();
}

void WatchView::watch(const QString& value) {
    const std::string text = value.trimmed().toStdString();
    WatchPane pane = pane_;
    const auto found = std::find(pane.values.begin(), pane.values.end(), text);
    pane.chosen = static_cast<int>(found - pane.values.begin());
    if (found == pane.values.end()) pane.values.push_back(text);
    try {
        pane.check("watch");
        // A name that no step has is most likely misspelt.
        if (const auto shown = workspace_->snapshot(); shown && !shown->trace.steps.empty()) {
            relief::watchedValues(text, shown->trace.columns());
        }
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
        return;
    }
    change(pane);
}

void WatchView::removeChosen() {
    WatchPane pane = pane_;
    if (pane.chosenValue().empty()) return;
    pane.values.erase(pane.values.begin() + pane.chosen);
    pane.chosen = std::clamp(pane.chosen, 0, std::max(0, static_cast<int>(pane.values.size()) - 1));
    change(pane);
}

// Lists the columns of the ray's steps; what is being typed stays.
void WatchView::fillNames() {
    const auto shown = workspace_->snapshot();
    QStringList names;
    for (const std::string& name : shown->trace.columns().names()) {
        const bool word =
            std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
        const QString text = QString::fromStdString(name);
        names << (word ? text : QStringLiteral("column('%1')").arg(text));
    }
    QStringList before;
    for (int n = 0; n < names_->count(); ++n) before << names_->itemText(n);
    if (names == before) return;
    const QSignalBlocker quiet(names_);
    const QString typed = names_->currentText();
    names_->clear();
    names_->addItems(names);
    names_->setEditText(before.isEmpty() ? QString() : typed);
}

void WatchView::showSnapshot() {
    const PauseLog::Part part("watch");
    canvas_->setStyle(workspace_->style());
    const auto shown = workspace_->snapshot();
    rows_.clear();
    if (!shown) return canvas_->showText(workspace_->whyEmpty());
    if (shown->trace.hidden) return canvas_->showText(relief::MessageId::DrawHidden);
    if (!shown->trace.onRelief) {
        return canvas_->showText(shown->scenario.pixel ? relief::MessageId::DrawNoRelief
                                                       : relief::MessageId::DrawNoRay);
    }
    fillNames();
    remove_->setEnabled(!pane_.chosenValue().empty());
    if (pane_.values.empty()) return canvas_->showText(relief::MessageId::WatchNothing);
    rows_ = watchRows(shown->trace, pane_);
    const QSizeF room = canvas_->room();
    frame_ = watchFrame(rows_, shown->trace.steps.size(), room.width(), room.height());
    draw();
}

void WatchView::draw() {
    if (markStaleIfHidden()) return;
    if (rows_.empty()) return;
    const auto step = static_cast<std::size_t>(std::max(0, workspace_->scenario().step));
    canvas_->setLayers({std::make_shared<const Drawing>(watchDrawing(
                           rows_, frame_, step, static_cast<std::size_t>(pane_.chosen), workspace_->style().language))},
                       nullptr);
}

void WatchView::choose(const QPointF& widget) {
    if (rows_.empty()) return;
    const Point at = canvas_->toDrawing(widget);
    const auto row = frame_.rowAt(at);
    if (!row) return;
    if (static_cast<int>(*row) != pane_.chosen) {
        WatchPane pane = pane_;
        pane.chosen = static_cast<int>(*row);
        change(pane);
    }
    if (const auto step = frame_.stepAt(at)) workspace_->chooseStep(static_cast<int>(*step));
}

void WatchView::readOut(const QPointF& widget) {
    if (rows_.empty()) return setReadout({});
    const Point at = canvas_->toDrawing(widget);
    const auto row = frame_.rowAt(at);
    const auto step = frame_.stepAt(at);
    if (!row || !step) return setReadout({});
    const WatchRow& shown = rows_[*row];
    if (shown.fault) {
        return setReadout(QString::fromStdString(relief::sentence(*shown.fault, workspace_->style().language)));
    }
    setReadout(tr("step %1 · %2 = %3")
                   .arg(*step + 1)
                   .arg(QString::fromStdString(shown.name), QString::fromStdString(shown.text(*step))));
}

void WatchView::releaseContents() {
    rows_.clear();
    canvas_->releaseContents();
    setReadout({});
}

std::shared_ptr<const Figure> WatchView::figure() const {
    const auto shown = workspace_->snapshot();
    if (!shown || rows_.empty()) return nullptr;
    return watchFigure(shown, workspace_->scenario().step, pane_);
}

}  // namespace reliefui
