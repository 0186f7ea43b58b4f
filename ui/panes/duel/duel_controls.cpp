// Controls of the duel pane, and the division of its room between drawing and table.
#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QToolButton>

#include "panes/drawing_canvas.h"
#include "panes/duel/duel_view.h"
#include "panes/name_box.h"
#include "panes/pane_controls.h"
#include "scenario/variation.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

constexpr int kPlaces = 3;  // number of rivals of the scenario's own method
constexpr int kColumnLetters = 21;
constexpr int kDrawingLines = 26;
constexpr int kLowDrawingLines = 16;
constexpr int kTableLines = 6;
constexpr int kWideLines = 46;

}  // namespace

void DuelView::makeBar(QHBoxLayout* bar) {
    own_ = new QLabel(this);
    bar->addWidget(own_);
    for (int place = 0; place < kPlaces; ++place) {
        auto* const box = new NameBox(this);
        box->setObjectName(QStringLiteral("duel-method-%1").arg(place));
        box->setAccessibleName(tr("Opponent number %1").arg(place + 1));
        box->setToolTip(tr("Method to compete with; the compare pane uses the same methods"));
        box->addItem(QStringLiteral("–"), QString());
        for (const relief::MethodDescription& method : relief::tracerList()) {
            if (method.kind != relief::MethodKind::Tracer) continue;
            box->addItem(QString::fromStdString(method.name), QString::fromStdString(method.name));
        }
        connect(box, qOverload<int>(&QComboBox::activated), this,
                [this, box, place](int row) { setRival(place, box->itemData(row).toString()); });
        choosers_.push_back(box);
        bar->addWidget(box);
    }
    bar->addStretch(1);
    makeButtons(bar);
}

void DuelView::makeButtons(QHBoxLayout* bar) {
    const auto button = [&](const QString& sign, const QString& help, void (DuelView::*slot)()) {
        QToolButton* const made = addToolButton(bar, sign, help);
        connect(made, &QToolButton::clicked, this, slot);
        return made;
    };
    // The one that is wanted most, so it comes first: in a narrow pane the last ones have to be scrolled to.
    divergence_ = button(tr("divergence"), tr("Go to the first step that contradicts the exact answer (Ctrl+D)"),
                         &DuelView::toDivergence);
    divergence_->setObjectName(QStringLiteral("duel-divergence"));
    button(QStringLiteral("|◀"), tr("All methods to their first step"), &DuelView::first);
    button(QStringLiteral("◀"), tr("One step back in lockstep"), &DuelView::back);
    button(QStringLiteral("▶"), tr("One step forward in lockstep: the methods furthest behind take their next step"),
           &DuelView::forward);
    button(QStringLiteral("▶|"), tr("All methods to their answers"), &DuelView::last);
    near_ = addToolButton(bar, tr("near the ray"), tr("Show only the heights that the ray passes"), true);
    near_->setObjectName(QStringLiteral("duel-near"));
    near_->setChecked(options_.nearRay);
    connect(near_, &QToolButton::toggled, this, &DuelView::showNearRay);
}

void DuelView::showChoosers() {
    const relief::Scenario& scenario = workspace_->scenario();
    own_->setText(tr("%1  against").arg(QString::fromStdString(scenario.method.name)));
    const std::vector<relief::MethodChoice> rivals = duelRivals(scenario);
    for (std::size_t place = 0; place < choosers_.size(); ++place) {
        const std::string name = place < rivals.size() ? rivals[place].name : std::string();
        choosers_[place]->setCurrentIndex(std::max(0, choosers_[place]->findData(QString::fromStdString(name))));
        choosers_[place]->setVisible(place <= rivals.size());
    }
    if (rivals != rivals_) refresh();
}

void DuelView::setRival(int place, const QString& method) {
    relief::Scenario changed = workspace_->scenario();
    const std::vector<relief::MethodChoice> shown = duelRivals(changed);
    std::vector<relief::MethodChoice>& others = changed.comparison.others;
    const auto at = static_cast<std::size_t>(place);
    // A compared choice that cannot be a rival, because it finds no hits, keeps its place.
    const auto there = at < shown.size() ? std::find(others.begin(), others.end(), shown[at]) : others.end();
    if (there != others.end() && there->name == method.toStdString()) return;
    if (method.isEmpty()) {
        if (there != others.end()) others.erase(there);
        workspace_->change(changed, changeName([] { return tr("Methods of the duel"); }));
        return showChoosers();
    }
    relief::Scenario methods = changed;
    methods.comparison.subject = relief::CompareSubject::Methods;
    const auto choice = relief::variedOption(methods, method.toStdString());
    if (!choice || (there == others.end() && others.size() + 1 >= relief::kMostCompared)) return showChoosers();
    if (there != others.end()) {
        *there = *choice;
    } else {
        others.push_back(*choice);
    }
    workspace_->change(changed, changeName([] { return tr("Methods of the duel"); }));
}

void DuelView::showNearRay(bool on) {
    options_.nearRay = on;
    near_->setChecked(on);
    canvas_->resetZoom();
    redraw();
}

void DuelView::applyFont() {
    QFont font = this->font();
    font.setPointSizeF(Style::kTextPoints * workspace_->style().scale());
    verdict_->setFont(font);
    table_->setFont(font);
    table_->verticalHeader()->setDefaultSectionSize(QFontMetrics(font).height() + 4);
}

// The drawing has priority: the table stands to its right in a wide pane, below it in a high one, and is hidden
// otherwise.
void DuelView::shareRoom() {
    const QFontMetrics letters(table_->font());
    const int line = letters.height();
    const int column = kColumnLetters * letters.averageCharWidth();
    table_->horizontalHeader()->setMinimumSectionSize(column);
    const int runs = duel_ ? static_cast<int>(duel_->runs.size()) : 1;
    const int needed = runs * column + table_->verticalScrollBar()->sizeHint().width() + 4;
    const bool beside = split_->width() - needed >= kDrawingLines * line;
    const bool below = split_->height() >= (kLowDrawingLines + kTableLines) * line;
    // Also available in the menu.
    for (QWidget* const part : {static_cast<QWidget*>(own_), static_cast<QWidget*>(near_)}) {
        part->setVisible(width() > kWideLines * line);
    }
    table_->setVisible(beside || below);
    if (duel_) showVerdict();
    if (!beside && !below) return;
    split_->setOrientation(beside ? Qt::Horizontal : Qt::Vertical);
    const int table = beside ? needed : std::max(kTableLines * line, split_->height() / 4);
    const int all = beside ? split_->width() : split_->height();
    split_->setSizes({all - table, table});
}

void DuelView::resizeEvent(QResizeEvent* event) {
    FigureView::resizeEvent(event);
    // Delayed until the layout is done.
    QTimer::singleShot(0, this, &DuelView::shareRoom);
}

}  // namespace reliefui
