#include "views/duel_view.h"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "views/drawing_canvas.h"
#include "views/duel_model.h"
#include "views/narrow_bar.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr int kPlaces = 3;  // beside the scenario's own method
constexpr int kShownLetters = 9;
constexpr int kColumnLetters = 21;
constexpr double kMostLegend = 0.25;  // of the pane's height

// The methods to be set against the scenario's own.
std::vector<relief::MethodChoice> rivalsOf(const relief::Scenario& scenario) {
    return scenario.comparison.others;
}

}  // namespace

DuelView::DuelView(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      canvas_(new DrawingCanvas(this)),
      model_(new DuelModel(this)),
      table_(new QTableView(this)),
      verdict_(new QLabel(this)) {
    setAccessibleName(tr("Duel"));
    setFocusProxy(canvas_);
    table_->setModel(model_);
    table_->setAccessibleName(tr("Steps of the methods in lock step"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setWordWrap(false);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setDefaultSectionSize(kColumnLetters * fontMetrics().averageCharWidth());
    verdict_->setWordWrap(true);
    verdict_->setMargin(6);
    verdict_->setObjectName(QStringLiteral("duel-verdict"));
    verdict_->setAccessibleName(tr("What each method did"));
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* const bar = new NarrowBar(this);
    makeBar(bar->row());
    auto* const split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(canvas_);
    split->addWidget(table_);
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(split, 1);
    column->addWidget(verdict_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        if (!problem.isEmpty()) Q_EMIT workspace_->problem(problem);
        verdict_->setText(tr("No duel: it was cancelled, or failed."));
    };
    listener.progress = [this](const QString& what, double fraction) {
        if (fraction >= 0) verdict_->setText(tr("Preparing: %1, %2 %").arg(what).arg(static_cast<int>(100 * fraction)));
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
    connect(workspace_, &Workspace::snapshotChanged, this, &DuelView::refresh);
    connect(workspace_, &Workspace::scenarioChanged, this, &DuelView::showChoosers);
    connect(workspace_, &Workspace::stepChanged, this, &DuelView::followStep);
    connect(workspace_, &Workspace::styleChanged, this, &DuelView::refresh);
    showChoosers();
    refresh();
}

DuelView::~DuelView() = default;

void DuelView::makeBar(QHBoxLayout* bar) {
    own_ = new QLabel(this);
    bar->addWidget(own_);
    for (int place = 0; place < kPlaces; ++place) {
        auto* const box = new QComboBox(this);
        box->setObjectName(QStringLiteral("duel-method-%1").arg(place));
        box->setAccessibleName(tr("Method against it, number %1").arg(place + 1));
        box->setToolTip(tr("A method that is set against it; those of the comparison are the same"));
        // The names may be long; the pane is not to be as wide as three of them.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kShownLetters);
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
    const auto button = [&](const QString& sign, const QString& help, void (DuelView::*slot)()) {
        auto* const made = new QToolButton(this);
        made->setText(sign);
        made->setAutoRaise(true);
        made->setAccessibleName(help);
        made->setToolTip(help);
        connect(made, &QToolButton::clicked, this, slot);
        bar->addWidget(made);
        return made;
    };
    button(QStringLiteral("|◀"), tr("All at their first step"), &DuelView::first);
    button(QStringLiteral("◀"), tr("Back in lock step"), &DuelView::back);
    button(QStringLiteral("▶"), tr("On in lock step: those furthest behind take their next step"), &DuelView::forward);
    button(QStringLiteral("▶|"), tr("All at their answers"), &DuelView::last);
    divergence_ = button(tr("first divergence"), tr("To the first step that the exact answer contradicts (Ctrl+D)"),
                         &DuelView::toDivergence);
    divergence_->setObjectName(QStringLiteral("duel-divergence"));
}

QString DuelView::verdict() const {
    return verdict_->text();
}

void DuelView::showChoosers() {
    const relief::Scenario& scenario = workspace_->scenario();
    own_->setText(tr("%1  against").arg(QString::fromStdString(scenario.method.name)));
    const std::vector<relief::MethodChoice> rivals = rivalsOf(scenario);
    for (std::size_t place = 0; place < choosers_.size(); ++place) {
        const std::string name = place < rivals.size() ? rivals[place].name : std::string();
        choosers_[place]->setCurrentIndex(std::max(0, choosers_[place]->findData(QString::fromStdString(name))));
        choosers_[place]->setEnabled(place <= rivals.size());
    }
    if (rivals != rivals_) refresh();
}

void DuelView::setRival(int place, const QString& method) {
    relief::Scenario wanted = workspace_->scenario();
    std::vector<relief::MethodChoice>& rivals = wanted.comparison.others;
    const auto at = std::min(static_cast<std::size_t>(place), rivals.size());
    const bool there = at < rivals.size();
    if (method.isEmpty()) {
        if (there) rivals.erase(rivals.begin() + static_cast<std::ptrdiff_t>(at));
    } else if (!there) {
        rivals.push_back({method.toStdString(), {}});
    } else if (rivals[at].name != method.toStdString()) {
        rivals[at] = {method.toStdString(), {}};
    }
    workspace_->change(wanted, tr("Methods of the duel"));
}

void DuelView::cancel() {
    job_->cancel();
}

void DuelView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (stale_) QTimer::singleShot(0, this, &DuelView::refresh);
}

void DuelView::refresh() {
    const PauseLog::Part part("duel");
    // Out of sight nothing is computed or drawn.
    stale_ = !inSight();
    if (stale_) return;
    canvas_->setStyle(workspace_->style());
    const auto snapshot = workspace_->snapshot();
    rivals_ = rivalsOf(workspace_->scenario());
    if (!snapshot || !snapshot->request || !snapshot->trace.onRelief || snapshot->trace.hidden) {
        job_->drop();
        duel_.reset();
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

void DuelView::adopt(std::shared_ptr<const Duel> duel) {
    duel_ = std::move(duel);
    source_ = duel_->source();
    following_ = true;
    model_->show(duel_, workspace_->style());
    following_ = false;
    divergence_->setEnabled(duel_->first.has_value());
    showVerdict();
    const double unit = workspace_->style().pixelsPerPoint();
    Drawing legend = duelLegend(source_, canvas_->width() / unit - 12, workspace_->style().language);
    // The tracks have names as well.
    if (legend.bounds.height() * unit > kMostLegend * canvas_->height()) legend = {};
    legend_ = std::make_shared<const Drawing>(std::move(legend));
    moment_ = 0;
    redraw();
    followStep(workspace_->scenario().step);
    const auto moment = duel_->firstMoment();
    if (jump_ && moment) goTo(*moment);
    jump_ = false;
}

// The first to depart in a sentence, the others in two words; their sentences in the tool tip.
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
        const QString kind = text(relief::departureTitle(judgement.kind));
        others << (judgement.kind == relief::Departure::None
                       ? QStringLiteral("%1: %2").arg(name, kind)
                       : tr("%1: %2, step %3").arg(name, kind).arg(judgement.step + 1));
    }
    const QString first =
        duel_->first ? QStringLiteral("<b>%1</b><br>").arg(sentences[static_cast<int>(*duel_->first)]) : QString();
    verdict_->setText(first + others.join(QStringLiteral("  ·  ")));
    verdict_->setToolTip(sentences.join(QStringLiteral("<br>")));
    QFont font = this->font();
    font.setPointSizeF(workspace_->style().projector ? 18 : 10);
    verdict_->setFont(font);
    table_->setFont(font);
    table_->verticalHeader()->setDefaultSectionSize(QFontMetrics(font).height() + 4);
}

void DuelView::redraw() {
    const PauseLog::Part part("duel: drawing");
    if (!duel_ || !inSight()) return;
    const bool home = canvas_->atHome();
    if (home) {
        canvas_->setLayers({}, legend_);
        frame_ = duelFrame(source_, canvas_->room().width(), canvas_->room().height());
        auto bounds = std::make_shared<Drawing>();
        bounds->bounds = frame_.whole;
        canvas_->setLayers({std::move(bounds)}, legend_);
    }
    frame_.visible = home ? frame_.whole : canvas_->visible();
    frame_.zoom = home ? 1 : canvas_->zoom();
    ProfileOptions options;
    options.levels = LevelsShown::None;
    relief_ = std::make_shared<const Drawing>(profileRelief(source_.profile, options, frame_));
    axes_ = std::make_shared<const Drawing>(profileAxes(source_.profile, frame_));
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
    // The window's step is that of the method whose steps all panes show.
    const bool other = duel_->snapshot->trace.fromFile;
    const std::size_t run = other ? duel_->runs.size() - 1 : 0;
    workspace_->chooseStep(static_cast<int>(duel_->steps.moments[moment_][run]));
    table_->setCurrentIndex(model_->index(static_cast<int>(moment_), 0));
    following_ = false;
    redrawMarks();
}

void DuelView::followStep(int step) {
    if (following_ || !duel_ || !inSight()) return;
    const bool other = duel_->snapshot->trace.fromFile;
    const std::size_t run = other ? duel_->runs.size() - 1 : 0;
    moment_ = duel_->steps.momentOf(run, static_cast<std::size_t>(std::max(step, 0)));
    following_ = true;
    table_->setCurrentIndex(model_->index(static_cast<int>(moment_), 0));
    following_ = false;
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
    // Asked for while it is being made: when it is there.
    jump_ = !duel_ || !settled();
    if (jump_) return;
    if (const auto moment = duel_->firstMoment()) goTo(*moment);
}

void DuelView::showEmpty(relief::MessageId why) {
    relief_.reset();
    axes_.reset();
    canvas_->showText(why);
}

}  // namespace reliefui
