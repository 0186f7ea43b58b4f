#include "windows/step_bar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "panes/watch/watch_state.h"
#include "relief/errors.h"
#include "windows/breakpoint_bar.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

// Steps per second.
constexpr std::array kSpeeds{0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0};
constexpr double kFirstSpeed = 2;

QString speedKey() {
    return QStringLiteral("playSpeed");
}

}  // namespace

StepBar::StepBar(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      slider_(new QSlider(Qt::Horizontal, this)),
      label_(new QLabel(this)),
      speed_(new QDoubleSpinBox(this)) {
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    const auto button = [&](const QString& sign, const QString& name, const QString& key, void (StepBar::*slot)()) {
        auto* const made = new QToolButton(this);
        made->setText(sign);
        made->setAutoRaise(true);
        made->setAccessibleName(name);
        made->setToolTip(QStringLiteral("%1 (%2)").arg(name, key));
        connect(made, &QToolButton::clicked, this, slot);
        row->addWidget(made);
        return made;
    };
    button(QStringLiteral("|◀"), tr("First step"), tr("Home"), &StepBar::first);
    button(QStringLiteral("◀"), tr("Previous step"), QStringLiteral(","), &StepBar::previous);
    button(QStringLiteral("▶"), tr("Next step"), QStringLiteral("."), &StepBar::next);
    button(QStringLiteral("▶|"), tr("Last step"), tr("End"), &StepBar::last);
    button(QStringLiteral("↷"), tr("Step over the steps on finer levels"), QStringLiteral("F10"), &StepBar::over);
    button(QStringLiteral("▶●"), tr("Run to the next breakpoint"), QStringLiteral("F5"), &StepBar::run);
    play_ = button(tr("Play"), tr("Play the steps"), tr("Space"), &StepBar::togglePlay);
    play_->setCheckable(true);
    makeSpeed();
    row->addWidget(speed_);
    slider_->setAccessibleName(tr("Step of the ray"));
    slider_->setToolTip(tr("Step of the ray; , and . go back and forward"));
    slider_->setObjectName(QStringLiteral("step-slider"));
    row->addWidget(slider_, 1);
    row->addWidget(label_);
    connect(&timer_, &QTimer::timeout, this, &StepBar::advance);
    connect(slider_, &QSlider::valueChanged, workspace_, &Workspace::chooseStep);
    connect(workspace_, &Workspace::snapshotChanged, this, &StepBar::refresh);
    connect(workspace_, &Workspace::stepChanged, this, &StepBar::refresh);
    connect(workspace_, &Workspace::scenarioChanged, this, &StepBar::refresh);
    connect(workspace_, &Workspace::notesChanged, this, &StepBar::refresh);
    refresh();
}

void StepBar::makeSpeed() {
    speed_->setObjectName(QStringLiteral("play-speed"));
    speed_->setAccessibleName(tr("Speed of playing"));
    speed_->setToolTip(tr("Steps per second while playing; ] faster, [ slower"));
    speed_->setRange(kSpeeds.front(), kSpeeds.back());
    speed_->setLocale(QLocale::c());  // as for all numbers of the window
    speed_->setDecimals(1);
    speed_->setSuffix(tr("/s"));
    // Arrows and the wheel move in round numbers.
    speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    speed_->setKeyboardTracking(false);
    connect(speed_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &StepBar::setSpeed);
    // The speed of the last session.
    const double kept = QSettings().value(speedKey(), kFirstSpeed).toDouble();
    speed_->setValue(kept);
    setSpeed(speed_->value());
}

void StepBar::setSpeed(double stepsASecond) {
    timer_.setInterval(static_cast<int>(std::lround(1000 / stepsASecond)));
    QSettings().setValue(speedKey(), stepsASecond);
}

void StepBar::faster() {
    const auto next = std::upper_bound(kSpeeds.begin(), kSpeeds.end(), speed_->value());
    if (next != kSpeeds.end()) speed_->setValue(*next);
}

void StepBar::slower() {
    const auto next = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), speed_->value());
    if (next != kSpeeds.begin()) speed_->setValue(*std::prev(next));
}

int StepBar::count() const {
    const auto snapshot = workspace_->snapshot();
    return snapshot ? static_cast<int>(snapshot->trace.steps.size()) : 0;
}

int StepBar::step() const {
    return std::clamp(workspace_->scenario().step, 0, std::max(0, count() - 1));
}

void StepBar::first() {
    workspace_->chooseStep(0);
}

void StepBar::previous() {
    workspace_->chooseStep(step() - 1);
}

void StepBar::next() {
    workspace_->chooseStep(step() + 1);
}

void StepBar::last() {
    workspace_->chooseStep(count() - 1);
}

void StepBar::over() {
    if (count() > 0) workspace_->chooseStep(levelStep(true));
}

void StepBar::overBack() {
    if (count() > 0) workspace_->chooseStep(levelStep(false));
}

int StepBar::levelStep(bool forward) const {
    const auto& steps = workspace_->snapshot()->trace.steps;
    return static_cast<int>(relief::stepOver(steps, static_cast<std::size_t>(step()), forward));
}

void StepBar::run() {
    runTo(true);
}

void StepBar::runBack() {
    runTo(false);
}

// Goes to the next breakpoint, or to the end of the ray if there is none.
void StepBar::runTo(bool forward) {
    if (count() == 0) return;
    goTo(relief::nextStop(workspace_->scenario().breakpoints, workspace_->snapshot()->trace.stopped(),
                          static_cast<std::size_t>(step()), forward),
         forward);
}

void StepBar::goTo(const std::optional<std::size_t>& step, bool forward) {
    const int end = forward ? count() - 1 : 0;
    workspace_->chooseStep(step ? static_cast<int>(*step) : end);
}

void StepBar::runToChange() {
    runToChange(true);
}

void StepBar::runBackToChange() {
    runToChange(false);
}

void StepBar::runToChange(bool forward) {
    if (count() == 0) return;
    const std::string value = stateOf<WatchPane>(workspace_->scenario()).chosenValue();
    if (value.empty()) {
        Q_EMIT workspace_->problem(tr("No value is watched: choose one in the pane Watch"));
        return;
    }
    try {
        const relief::WatchedValues watched = relief::watchedValues(value, workspace_->snapshot()->trace.columns());
        goTo(watched.nextChange(static_cast<std::size_t>(step()), forward), forward);
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
    }
}

// The enabled breakpoints that match the chosen step.
QString StepBar::stopsHere() const {
    QStringList names;
    if (count() == 0) return {};
    const relief::StoppedRay ray = workspace_->snapshot()->trace.stopped();
    for (const relief::Breakpoint& breakpoint : workspace_->scenario().breakpoints) {
        if (!breakpoint.on || !relief::stopsAt(breakpoint, ray, static_cast<std::size_t>(step()))) continue;
        names << breakpointText(breakpoint, workspace_->style().language);
    }
    return names.join(QStringLiteral(", "));
}

void StepBar::togglePlay() {
    const bool play = !timer_.isActive() && count() > 1;
    if (play && step() + 1 >= count()) first();
    play ? timer_.start() : timer_.stop();
    play_->setChecked(play);
}

void StepBar::advance() {
    if (step() + 1 < count()) next();
    const bool stop = step() + 1 >= count() || !stopsHere().isEmpty();
    if (stop && timer_.isActive()) togglePlay();
}

void StepBar::refresh() {
    const PauseLog::Part part("step bar");
    const QSignalBlocker quiet(slider_);
    slider_->setEnabled(count() > 1);
    slider_->setRange(0, std::max(0, count() - 1));
    slider_->setValue(step());
    if (count() == 0) {
        label_->setText(workspace_->guessing() ? tr("hidden until you guess") : tr("no ray"));
        return;
    }
    const QString stops = stopsHere();
    QString text = tr("step %1 of %2").arg(step() + 1).arg(count());
    if (!stops.isEmpty()) text += QStringLiteral("  ● ") + stops;
    label_->setText(text);
}

}  // namespace reliefui
