#include "panes/compare/compare_view.h"

#include <algorithm>

#include <QComboBox>
#include <QMenu>
#include <QToolButton>

#include "panes/compare/compare_figure.h"
#include "panes/range_button.h"
#include "workspace/change_name.h"
#include "workspace/discard.h"
#include "workspace/pause_log.h"
#include "workspace/range_json.h"

namespace reliefui {

namespace {

QString textOf(relief::CompareSubject subject, const relief::MethodChoice& choice) {
    return QString::fromStdString(relief::variationText(subject, choice));
}

}  // namespace

bool CompareView::isUpToDate() const {
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
    if (!ready || relief::othersOf(snapshot->scenario.comparison).empty()) {
        job_->drop();
        ++run_;
        coarseRunning_ = false;
        view_.reset();
        snapshot_ = snapshot;
        pictures_->show(nullptr, ready ? relief::MessageId::DrawCompareOne : workspace_->whyEmpty());
        return;
    }
    if (view_ && view_->of(*snapshot)) {
        snapshot_ = snapshot;  // possibly with another pixel
        pictures_->relayout();
        return proceed();
    }
    // A coarse picture uses a cheaper filter, so it cannot be used to compare filters.
    if (snapshot->coarse && snapshot->scenario.comparison.subject == relief::CompareSubject::Filters) {
        job_->drop();
        ++run_;
        return pictures_->setProgress(0);
    }
    // A coarse picture in progress is completed, so that the pane follows the drag.
    if (coarseRunning_ && snapshot->coarse) return;
    startView();
}

// Releases the frames of all methods and their renderers.
void CompareView::releaseContents() {
    job_->drop();
    ++run_;
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
    const auto show = [this, snapshot](std::shared_ptr<const ComparedView> view) {
        view_ = std::move(view);
        snapshot_ = snapshot;
        pictures_->show(view_, {});
    };
    // Shows the view while it is being made, picture by picture.
    const auto part = [this, show, run = ++run_, parts = parts_.address()](std::shared_ptr<const ComparedView> view) {
        parts.post([this, show, run, view = std::move(view)] {
            if (run == run_ && isOnScreen()) show(view);
        });
    };
    const auto work = [=, comparer = comparer_, before = view_](relief::Work& w) {
        *made = comparer->view(*snapshot, before.get(), part, w);
    };
    const auto done = [=, this] {
        ++run_;  // ignores parts that arrive after the whole view
        coarseRunning_ = false;
        show(*made);
        if (workspace_->snapshot() != snapshot) return refresh();
        proceed();
    };
    coarseRunning_ = snapshot->coarse;
    view_ ? pictures_->setProgress(0) : pictures_->show(nullptr, relief::MessageId::DrawCompareDrawing);
    job_->start({work, done});
}

void CompareView::proceed() {
    if (!view_ || !view_->complete || view_->coarse || outdated()) return;
    const ColorRanges ranges = rangesOf(workspace_->scenario());
    if (!view_->inRanges(ranges)) {
        make([view = view_, ranges](relief::Work&) { return recolored(*view, ranges); });
    } else if (!view_->rated && !job_->busy()) {
        make([view = view_, snapshot = snapshot_](relief::Work& w) { return withRates(*view, *snapshot, w); });
    }
}

void CompareView::make(std::function<std::shared_ptr<const ComparedView>(relief::Work&)> work) {
    auto made = std::make_shared<std::shared_ptr<const ComparedView>>();
    const auto done = [this, made] {
        view_ = *made;
        pictures_->show(view_, {});
        range_->refresh();
        proceed();
    };
    job_->start({[made, work = std::move(work)](relief::Work& w) { *made = work(w); }, done});
}

bool CompareView::cancel() {
    return job_->cancel();
}

void CompareView::change(const relief::Comparison& comparison, const QString& what) {
    relief::Scenario scenario = workspace_->scenario();
    scenario.comparison = comparison;
    workspace_->finishInteraction();
    workspace_->change(scenario, what);
}

// If nothing is compared for this subject yet, adds the most common choice.
void CompareView::setSubject(relief::CompareSubject subject) {
    relief::Scenario scenario = workspace_->scenario();
    scenario.comparison.subject = subject;
    scenario.comparison.dividers.clear();
    if (const auto next = relief::nextVariation(scenario); next && relief::othersOf(scenario.comparison).empty()) {
        relief::othersOf(scenario.comparison).push_back(*next);
    }
    change(scenario.comparison, changeName([] { return tr("Kind of comparison"); }));
}

void CompareView::addOther() {
    relief::Scenario scenario = workspace_->scenario();
    std::vector<relief::MethodChoice>& others = relief::othersOf(scenario.comparison);
    const auto next = relief::nextVariation(scenario);
    if (!next || others.size() + 1 >= relief::kMostCompared) return;
    others.push_back(*next);
    scenario.comparison.dividers.clear();
    change(scenario.comparison, changeName([] { return tr("Add to comparison"); }));
}

void CompareView::removeOther() {
    relief::Comparison comparison = workspace_->scenario().comparison;
    std::vector<relief::MethodChoice>& others = relief::othersOf(comparison);
    if (others.empty()) return;
    others.pop_back();
    comparison.dividers.clear();
    change(comparison, changeName([] { return tr("Remove from comparison"); }));
}

void CompareView::setChoice(std::size_t number, const QString& name) {
    relief::Scenario scenario = workspace_->scenario();
    const relief::CompareSubject subject = scenario.comparison.subject;
    std::vector<relief::MethodChoice>& others = relief::othersOf(scenario.comparison);
    const std::vector<relief::MethodChoice> all = relief::comparedOf(scenario);
    if (number >= all.size() || all[number].name == name.toStdString()) return;
    // Options belong to a method or filter; another one starts with its defaults.
    relief::MethodChoice choice{name.toStdString(), {}};
    const auto there = std::find_if(others.begin(), others.end(),
                                    [&](const auto& one) { return relief::sameVariation(subject, one, choice); });
    if (number == 0) {
        scenario = relief::varied(scenario, subject, choice);
    } else if (there != others.end()) {
        std::swap(*there, others[number - 1]);
    } else if (const auto varied = relief::variedOption(scenario, choice.name)) {
        if (varied->options != choice.options) {
            Q_EMIT workspace_->notice(
                tr("%1 is already A; %2 is added instead.").arg(textOf(subject, all[0]), textOf(subject, *varied)));
        }
        others[number - 1] = *varied;
    } else {
        Q_EMIT workspace_->notice(
            tr("%1 is already A and has no option by which to compare it with itself.").arg(name));
        return showControls();
    }
    workspace_->finishInteraction();
    workspace_->change(scenario, changeName([letter = QChar(static_cast<char>('A' + number))] {
                           return tr("Compare: %1").arg(letter);
                       }));
}

void CompareView::swapWithA(std::size_t number) {
    relief::Scenario scenario = workspace_->scenario();
    const relief::CompareSubject subject = scenario.comparison.subject;
    std::vector<relief::MethodChoice>& others = relief::othersOf(scenario.comparison);
    if (number == 0 || number > others.size() || subject == relief::CompareSubject::Heights) return;
    const relief::MethodChoice own = std::exchange(others[number - 1], relief::ownVariation(scenario, subject));
    workspace_->finishInteraction();
    workspace_->change(relief::varied(scenario, subject, own), changeName([] { return tr("Swap with A"); }));
}

void CompareView::setMode(relief::CompareMode mode) {
    relief::Comparison comparison = workspace_->scenario().comparison;
    comparison.mode = mode;
    change(comparison, changeName([] { return tr("Comparison mode"); }));
}

void CompareView::setMeasure(relief::CompareMeasure measure) {
    relief::Comparison comparison = workspace_->scenario().comparison;
    comparison.measure = measure;
    change(comparison, changeName([] { return tr("Difference"); }));
}

void CompareView::setReference(relief::CompareReference reference) {
    relief::Comparison comparison = workspace_->scenario().comparison;
    comparison.reference = reference;
    change(comparison, changeName([] { return tr("Reference"); }));
}

void CompareView::tick() {
    if (markStaleIfHidden()) return flicker_.stop();
    pictures_->setShown(pictures_->shown() + 1);
}

void CompareView::readOut(const QPointF& widget) {
    menuAt_ = widget.toPoint();
}

void CompareView::addToMenu(QMenu& menu) {
    const auto number = pictures_->pictureAt(menuAt_);
    const relief::Scenario& scenario = workspace_->scenario();
    const std::vector<relief::MethodChoice> all = relief::comparedOf(scenario);
    const relief::CompareSubject subject = scenario.comparison.subject;
    if (!number || *number == 0 || *number >= all.size() || subject == relief::CompareSubject::Heights) return;
    menu.addAction(tr("Make %1 the one (A) that all panes show").arg(textOf(subject, all[*number])), this,
                   [this, n = *number] { swapWithA(n); });
}

// Uses the numbers shown in the pane; there are none while they are being measured.
std::shared_ptr<const Figure> CompareView::figure() const {
    const bool ready = view_ && view_->complete && !view_->coarse && view_->rated && !outdated();
    return ready ? compareFigure(snapshot_, view_, pictures_->shown()) : nullptr;
}

}  // namespace reliefui
