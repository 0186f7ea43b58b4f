#include "panes/compare/compare_view.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QMenu>
#include <QToolButton>

#include "measuring/bench/pareto.h"
#include "panes/compare/compare_figure.h"
#include "workspace/discard.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

// Set beside the first one, one after the other, where they are not there yet.
constexpr std::array<const char*, 4> kSuggested{"layers", "exact", "offset", "max-pyramid"};

}  // namespace

bool CompareView::settled() const {
    return !stale() && !job_->busy();
}

bool CompareView::outdated() const {
    return view_ && !(workspace_->snapshot() && view_->of(*workspace_->snapshot()));
}

void CompareView::showSnapshot() {
    const PauseLog::Part part("compare");
    const std::shared_ptr<const Snapshot> snapshot = workspace_->snapshot();
    showControls();
    const bool ready = snapshot && snapshot->request && snapshot->frame;
    if (!ready || snapshot->scenario.comparison.others.empty()) {
        job_->drop();
        coarseRunning_ = false;
        view_.reset();
        snapshot_ = snapshot;
        pictures_->show(nullptr, ready ? relief::MessageId::DrawCompareOne : workspace_->whyEmpty());
        return;
    }
    if (view_ && view_->of(*snapshot)) {
        snapshot_ = snapshot;  // another pixel, perhaps
        pictures_->relayout();
        if (!view_->coarse && view_->rays == 0 && !job_->busy()) startRates();
        return;
    }
    // A coarse picture in the making is finished first: a drag is to be seen while it goes on.
    if (coarseRunning_ && snapshot->coarse) return;
    startView();
}

// The frames of all methods, and the buffers they are made with.
void CompareView::letGo() {
    job_->drop();
    flicker_.stop();
    coarseRunning_ = false;
    pictures_->show(nullptr, relief::MessageId::DrawCompareDrawing);
    discard(std::exchange(comparer_, std::make_shared<Comparer>()));
    view_.reset();
    snapshot_.reset();
}

void CompareView::startView() {
    const std::shared_ptr<const Snapshot> snapshot = workspace_->snapshot();
    auto made = std::make_shared<std::shared_ptr<const ComparedView>>();
    const auto work = [made, snapshot, comparer = comparer_](relief::Work& w) { *made = comparer->view(*snapshot, w); };
    const auto done = [this, made, snapshot] {
        coarseRunning_ = false;
        view_ = *made;
        snapshot_ = snapshot;
        pictures_->show(view_, {});
        if (workspace_->snapshot() != snapshot) return refresh();
        if (!view_->coarse) startRates();
    };
    coarseRunning_ = snapshot->coarse;
    if (!view_) pictures_->show(nullptr, relief::MessageId::DrawCompareDrawing);
    job_->start({work, done});
}

void CompareView::startRates() {
    if (!view_ || view_->coarse || view_->rays > 0) return;
    auto made = std::make_shared<std::shared_ptr<const ComparedView>>();
    const auto work = [made, view = view_, snapshot = snapshot_](relief::Work& w) {
        *made = withRates(*view, *snapshot, w);
    };
    const auto done = [this, made] {
        view_ = *made;
        pictures_->show(view_, {});
    };
    job_->start({work, done});
}

void CompareView::cancel() {
    job_->cancel();
}

void CompareView::change(const relief::Comparison& comparison, const QString& what) {
    relief::Scenario scenario = workspace_->scenario();
    scenario.comparison = comparison;
    workspace_->settle();
    workspace_->change(scenario, what);
}

void CompareView::addMethod() {
    relief::Scenario scenario = workspace_->scenario();
    if (scenario.comparison.others.size() + 1 >= relief::kMostCompared) return;
    const std::vector<relief::MethodChoice> there = comparedMethods(scenario);
    relief::MethodChoice next;
    for (const char* const name : kSuggested) {
        const bool known = std::any_of(there.begin(), there.end(), [&](const auto& m) { return m.name == name; });
        if (known) continue;
        next.name = name;
        break;
    }
    scenario.comparison.others.push_back(next);
    scenario.comparison.dividers.clear();
    change(scenario.comparison, tr("Compare with another method"));
}

void CompareView::removeMethod() {
    relief::Comparison comparison = workspace_->scenario().comparison;
    if (comparison.others.empty()) return;
    comparison.others.pop_back();
    comparison.dividers.clear();
    change(comparison, tr("Compare with one method less"));
}

void CompareView::setMethod(std::size_t number, const QString& name) {
    relief::Scenario scenario = workspace_->scenario();
    if (number > scenario.comparison.others.size()) return;
    relief::MethodChoice& method = number == 0 ? scenario.method : scenario.comparison.others[number - 1];
    // Options belong to their method: another method does not inherit them.
    if (method.name != name.toStdString()) method = {name.toStdString(), {}};
    workspace_->settle();
    workspace_->change(scenario, tr("Method %1").arg(QChar(static_cast<char>('A' + number))));
}

void CompareView::swapWithA(std::size_t number) {
    relief::Scenario scenario = workspace_->scenario();
    if (number == 0 || number > scenario.comparison.others.size()) return;
    std::swap(scenario.method, scenario.comparison.others[number - 1]);
    workspace_->settle();
    workspace_->change(scenario, tr("Swap methods"));
}

void CompareView::setMode(relief::CompareMode mode) {
    relief::Comparison comparison = workspace_->scenario().comparison;
    comparison.mode = mode;
    change(comparison, tr("Way of comparing"));
}

void CompareView::setMeasure(relief::CompareMeasure measure) {
    relief::Comparison comparison = workspace_->scenario().comparison;
    comparison.measure = measure;
    change(comparison, tr("Difference"));
}

void CompareView::setReference(relief::CompareReference reference) {
    relief::Comparison comparison = workspace_->scenario().comparison;
    comparison.reference = reference;
    change(comparison, tr("Reference"));
}

void CompareView::tick() {
    if (outOfSight()) return flicker_.stop();
    pictures_->setShown(pictures_->shown() + 1);
}

void CompareView::tell(const QPointF& widget) {
    menuAt_ = widget.toPoint();
}

void CompareView::addToMenu(QMenu& menu) {
    const auto method = pictures_->methodAt(menuAt_);
    if (!method || *method == 0 || !view_ || *method >= view_->methods.size()) return;
    const QString name = QString::fromStdString(view_->methods[*method].name);
    menu.addAction(tr("Make %1 the method A").arg(name), this, [this, n = *method] { swapWithA(n); });
}

std::shared_ptr<const Figure> CompareView::figure() const {
    return view_ ? compareFigure(snapshot_, pictures_->shown()) : nullptr;
}

}  // namespace reliefui
