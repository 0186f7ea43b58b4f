#include "panes/duel/duel_view.h"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/core_texts.h"
#include "panes/drawing_canvas.h"
#include "panes/duel/duel_figure.h"
#include "panes/duel/duel_model.h"
#include "panes/narrow_bar.h"
#include "scenario/step_sentence.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kMostLegend = 0.12;  // as a share of the pane's height
constexpr int kLowLines = 20;         // a pane with fewer lines counts as low

}  // namespace

DuelView::DuelView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Duel"), QStringLiteral("duel"), tr("Export the duel"), parent),
      canvas_(new DrawingCanvas(this)),
      model_(new DuelModel(this)),
      table_(new QTableView(this)),
      verdict_(new QLabel(this)) {
    setFace(canvas_);
    options_.levels = LevelsShown::None;
    options_.nearRay = true;
    table_->setModel(model_);
    table_->setAccessibleName(tr("Steps of the methods in lockstep"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setWordWrap(false);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    verdict_->setWordWrap(true);
    verdict_->setMargin(6);
    verdict_->setObjectName(QStringLiteral("duel-verdict"));
    verdict_->setAccessibleName(tr("What each method did"));
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* const bar = new NarrowBar(this);
    makeBar(bar->row());
    split_ = new QSplitter(Qt::Horizontal, this);
    split_->addWidget(canvas_);
    split_->addWidget(table_);
    split_->setChildrenCollapsible(false);
    split_->setStretchFactor(0, 1);
    table_->hide();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(split_, 1);
    column->addWidget(verdict_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        if (!problem.isEmpty()) Q_EMIT workspace_->problem(problem);
        releaseContents();
        verdict_->setText(tr("There is no duel, because it was cancelled or failed."));
    };
    listener.progress = [this](const QString& what, double fraction) {
        if (fraction >= 0)
            verdict_->setText(
                tr("Preparing: %1, %2 %").arg(coreText(what.toStdString())).arg(static_cast<int>(100 * fraction)));
    };
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current, const QModelIndex&) {
                if (!following_ && current.isValid()) goTo(static_cast<std::size_t>(current.row()));
            });
    connect(canvas_, &DrawingCanvas::clicked, this, [this](const ItemId& id) {
        if (!duel_ || id.level < 0 || static_cast<std::size_t>(id.level) >= duel_->runs.size()) return;
        const auto run = static_cast<std::size_t>(id.level);
        const std::size_t end = std::max<std::size_t>(duel_->runs[run].steps.size(), 1) - 1;
        if (id.kind == ItemKind::Step) goTo(duel_->steps.momentOf(run, static_cast<std::size_t>(id.i)));
        if (id.kind == ItemKind::Hit) goTo(duel_->steps.momentOf(run, end));
    });
    connect(canvas_, &DrawingCanvas::resized, this, &DuelView::redraw);
    connect(canvas_, &DrawingCanvas::moved, this, &DuelView::redraw);
    connect(canvas_, &DrawingCanvas::pointed, this, &DuelView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(workspace_, &Workspace::scenarioChanged, this, &DuelView::showChoosers);
    connect(workspace_, &Workspace::stepChanged, this, &DuelView::followStep);
    connect(workspace_, &Workspace::styleChanged, this, &DuelView::refresh);
    showChoosers();
    refresh();
}

DuelView::~DuelView() = default;

QString DuelView::verdict() const {
    return verdict_->text();
}

bool DuelView::cancel() {
    return job_->cancel();
}

void DuelView::addToMenu(QMenu& menu) {
    QAction* const near = menu.addAction(near_->text(), this, &DuelView::showNearRay);
    near->setCheckable(true);
    near->setChecked(options_.nearRay);
}

void DuelView::readOut(const QPointF& widget) {
    if (!duel_ || !relief_) return setReadout({});
    const ProfileReading at = profileReading(source_.profile, frame_, canvas_->toDrawing(widget));
    const ItemId id = canvas_->itemAt(widget);
    QStringList parts;
    if (id.kind == ItemKind::Step && id.level >= 0 && static_cast<std::size_t>(id.level) < duel_->runs.size()) {
        const QString name = QString::fromStdString(duel_->runs[static_cast<std::size_t>(id.level)].name);
        parts << tr("%1, step %2").arg(name).arg(id.i + 1);
    }
    if (at.inside) {
        const auto number = [](double value) { return QString::fromStdString(relief::fixedText(value, 3)); };
        parts << tr("λ %1 · surface %2 · ray %3").arg(number(at.lambda), number(at.surface), number(at.rayHeight));
    }
    setReadout(parts.join(QStringLiteral(" · ")));
}

void DuelView::showSnapshot() {
    const PauseLog::Part part("duel");
    canvas_->setStyle(workspace_->style());
    applyFont();
    const auto snapshot = workspace_->snapshot();
    rivals_ = duelRivals(workspace_->scenario());
    if (!snapshot || !snapshot->request || !snapshot->trace.onRelief || snapshot->trace.hidden) {
        job_->drop();
        duel_.reset();
        jump_ = false;
        model_->show(nullptr, workspace_->style());
        verdict_->clear();
        const bool sky = snapshot && snapshot->scenario.pixel;
        return showEmpty(workspace_->guessing() ? relief::MessageId::DrawHidden
                         : sky                  ? relief::MessageId::DrawNoRelief
                                                : relief::MessageId::DrawDuelNoRay);
    }
    auto made = std::make_shared<std::shared_ptr<const Duel>>();
    const auto work = [made, snapshot, rivals = rivals_](relief::Work& w) { *made = makeDuel(snapshot, rivals, w); };
    job_->start({work, [this, made] { adopt(*made); }});
}

void DuelView::releaseContents() {
    job_->drop();
    duel_.reset();
    jump_ = false;
    source_ = {};
    model_->show(nullptr, workspace_->style());
    verdict_->clear();
    relief_.reset();
    axes_.reset();
    legend_.reset();
    canvas_->releaseContents();
    setReadout({});
}

void DuelView::adopt(std::shared_ptr<const Duel> duel) {
    // Recomputed only for another style: the current moment is kept.
    const bool same = duel_ && duel_->snapshot == duel->snapshot && duel_->steps.moments == duel->steps.moments;
    const double upTo = same ? source_.upTo : 0;
    const std::size_t moment = same ? moment_ : 0;
    duel_ = std::move(duel);
    source_ = duel_->source();
    source_.upTo = upTo;
    following_ = true;
    model_->show(duel_, workspace_->style());
    following_ = false;
    divergence_->setEnabled(duel_->first.has_value());
    showVerdict();
    shareRoom();
    moment_ = moment;
    redraw();
    if (same) {
        selectMoment();
    } else {
        followStep(workspace_->scenario().step);
    }
    if (jump_) goToDivergence();
    jump_ = false;
}

void DuelView::showUpTo(double lambda) {
    if (source_.upTo == lambda) return;
    source_.upTo = lambda;
    canvas_->resetZoom();
    redraw();
}

void DuelView::leaveCloseUp() {
    if (source_.upTo > 0 && !duel_->within(source_.upTo, moment_)) showUpTo(0);
}

// Describes the first departure in a sentence and the others in two words; the tool tip has all sentences.
void DuelView::showVerdict() {
    const relief::Language language = workspace_->style().language;
    const auto text = [&](const relief::Message& message) {
        return QString::fromStdString(relief::sentence(message, language)).toHtmlEscaped();
    };
    QStringList sentences;
    QStringList others;
    for (std::size_t r = 0; r < duel_->runs.size(); ++r) {
        const relief::DuelRun& run = duel_->runs[r];
        const relief::Judgement& judgement = duel_->judgements[r];
        sentences << text(relief::judgementSentence(run, judgement, duel_->exact));
        if (duel_->first == r) continue;
        const QString name = QString::fromStdString(run.name).toHtmlEscaped();
        const QString kind = text(relief::departureTitle(judgement));
        others << (judgement.kind == relief::Departure::None
                       ? QStringLiteral("%1: %2").arg(name, kind)
                       : tr("%1: %2, step %3").arg(name, kind).arg(judgement.step + 1));
    }
    const auto& compared = duel_->snapshot->scenario.comparison.others;
    for (const relief::MethodChoice& rival : rivals_) {
        if (std::find(compared.begin(), compared.end(), rival) != compared.end()) continue;
        others << tr("against %1, because no other method is chosen").arg(QString::fromStdString(rival.name));
    }
    const QString first =
        duel_->first ? QStringLiteral("<b>%1</b><br>").arg(sentences[static_cast<int>(*duel_->first)]) : QString();
    // A low pane has room for one line only; the sentence is in the tool tip.
    if (height() < kLowLines * fontMetrics().height() && duel_->first) {
        const std::size_t r = *duel_->first;
        others.prepend(QStringLiteral("<b>%1</b>")
                           .arg(tr("%1: %2, step %3")
                                    .arg(QString::fromStdString(duel_->runs[r].name).toHtmlEscaped(),
                                         text(relief::departureTitle(duel_->judgements[r])))
                                    .arg(duel_->judgements[r].step + 1)));
        verdict_->setText(others.join(QStringLiteral("  ·  ")));
    } else {
        verdict_->setText(first + others.join(QStringLiteral("  ·  ")));
    }
    verdict_->setToolTip(sentences.join(QStringLiteral("<br>")));
}

// The tracks are labelled as well, so the legend is left out if there is little room.
void DuelView::showLegend() {
    legend_ =
        canvas_->showLegend(duelLegend(source_, canvas_->legendWidth(), workspace_->style().language), kMostLegend);
}

void DuelView::redraw() {
    const PauseLog::Part part("duel: drawing");
    if (!duel_ || !isOnScreen()) return;
    const bool home = canvas_->atHome();
    if (home) {
        showLegend();
        frame_ = duelFrame(source_, options_, canvas_->room().width(), canvas_->room().height());
        auto bounds = std::make_shared<Drawing>();
        bounds->bounds = frame_.whole;
        canvas_->setLayers({std::move(bounds)}, legend_);
    }
    frame_.visible = home ? frame_.whole : canvas_->visible();
    frame_.zoom = home ? 1 : canvas_->zoom();
    relief_ = std::make_shared<const Drawing>(profileRelief(source_.profile, options_, frame_));
    axes_ = std::make_shared<const Drawing>(profileAxes(source_.profile, frame_, 0));
    redrawMarks();
}

void DuelView::redrawMarks() {
    if (!duel_ || !relief_) return;
    const auto& moments = duel_->steps.moments;
    const std::size_t at = std::min(moment_, moments.size() - 1);
    auto marks = std::make_shared<const Drawing>(duelMarks(source_, frame_, moments[at]));
    canvas_->setLayers({relief_, axes_, std::move(marks)}, legend_);
}

void DuelView::goTo(std::size_t moment) {
    if (moments() == 0) return;
    moment_ = std::min(moment, moments() - 1);
    following_ = true;
    workspace_->chooseStep(static_cast<int>(duel_->steps.moments[moment_][duel_->own()]));
    table_->setCurrentIndex(model_->index(static_cast<int>(moment_), 0));
    following_ = false;
    leaveCloseUp();
    redrawMarks();
}

void DuelView::followStep(int step) {
    if (following_ || !duel_ || !isOnScreen()) return;
    moment_ = duel_->steps.momentOf(duel_->own(), static_cast<std::size_t>(std::max(step, 0)));
    selectMoment();
    leaveCloseUp();
    redrawMarks();
}

void DuelView::first() {
    goTo(0);
}

void DuelView::back() {
    if (moment_ > 0) goTo(moment_ - 1);
}

void DuelView::forward() {
    goTo(moment_ + 1);
}

void DuelView::last() {
    if (moments() > 0) goTo(moments() - 1);
}

void DuelView::toDivergence() {
    // If the duel is still being computed, the jump follows when it is ready; if there is none, there is no jump.
    jump_ = !isUpToDate() || (!duel_ && workspace_->busy());
    if (duel_ && !jump_) goToDivergence();
}

void DuelView::goToDivergence() {
    const auto moment = duel_->firstMoment();
    if (!moment) return;
    showUpTo(duel_->closeUp());
    goTo(*moment);
}

void DuelView::selectMoment() {
    following_ = true;
    table_->setCurrentIndex(model_->index(static_cast<int>(moment_), 0));
    following_ = false;
}

void DuelView::showEmpty(relief::MessageId why) {
    relief_.reset();
    axes_.reset();
    canvas_->showText(why);
}

std::shared_ptr<const Figure> DuelView::figure() const {
    return duel_ ? duelFigure(duel_->snapshot, duel_, options_, moment_, source_.upTo) : nullptr;
}

}  // namespace reliefui
