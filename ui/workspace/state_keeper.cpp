#include "workspace/state_keeper.h"

#include <utility>

#include <QFileInfo>
#include <QSettings>

#include "relief/errors.h"
#include "workspace/language.h"
#include "workspace/last_state.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

// Returns an empty string on success, otherwise a one-line explanation.
QString writeState(const relief::Scenario& scenario, const QVariantMap& layout, const QString& scenarioFile,
                   const QString& layoutFile) {
    // The layout is written first: whoever finds a scenario can rely on its layout.
    QSettings settings(layoutFile, QSettings::IniFormat);
    for (auto value = layout.begin(); value != layout.end(); ++value) settings.setValue(value.key(), value.value());
    settings.sync();
    try {
        relief::saveScenario(scenarioFile.toStdString(), scenario);
        return {};
    } catch (const relief::InputError& error) {
        return QString::fromStdString(error.text(uiLanguage()));
    }
}

// Ignores the step, which may have been clamped to the last one of the ray.
bool sameButStep(relief::Scenario a, const relief::Scenario& b) {
    a.step = b.step;
    return a == b;
}

}  // namespace

StateKeeper::StateKeeper(Workspace* workspace, SessionFiles files, const relief::Scenario& beginning,
                         std::function<QVariantMap()> layout)
    : workspace_(workspace), files_(std::move(files)), saved_(beginning), layout_(std::move(layout)) {
    writer_.setMaxThreadCount(1);
    connect(&timer_, &QTimer::timeout, this, &StateKeeper::checkForChanges);
    for (const auto changed : {&Workspace::scenarioChanged, &Workspace::notesChanged, &Workspace::panesChanged}) {
        connect(workspace_, changed, this, &StateKeeper::checkAdopted);
    }
    timer_.start(kEveryMs);
}

StateKeeper::~StateKeeper() {
    writer_.waitForDone();
}

void StateKeeper::adopt(SessionFiles left, const relief::Scenario& scenario) {
    adopted_ = std::move(left);
    adoptedScenario_ = scenario;
    adoptedShown_ = false;
    checkAdopted();
}

// Notes when the restored scenario is shown. If its pictures are missing, it never is, and its files are kept.
void StateKeeper::checkAdopted() {
    if (adopted_ && sameButStep(workspace_->scenario(), adoptedScenario_)) adoptedShown_ = true;
}

void StateKeeper::checkForChanges() {
    if (writing_ || workspace_->version() == 0) return;
    State now{workspace_->scenario(), layout_()};
    const auto snapshot = workspace_->snapshot();
    if (!shown_) layoutSaved_ = now.layout;
    if (!shown_ && snapshot && !snapshot->coarse) {
        // The first full picture has been there for some seconds, so the state can be opened safely.
        shown_ = true;
        files_.setStarting(false);
    }
    if (now.scenario == saved_ && now.layout == layoutSaved_) return;
    write(std::move(now));
}

void StateKeeper::write(State state) {
    if (!files_.take()) return written(state, tr("%1 cannot be written").arg(settingsFolder()));
    files_.setStarting(false);
    writing_ = true;
    writer_.start([this, state = std::move(state), scenario = files_.scenarioFile(), layout = files_.layoutFile()] {
        const QString fault = writeState(state.scenario, state.layout, scenario, layout);
        QMetaObject::invokeMethod(
            this, [this, state, fault] { written(state, fault); }, Qt::QueuedConnection);
    });
}

void StateKeeper::written(const State& state, const QString& fault) {
    writing_ = false;
    if (!fault.isEmpty()) {
        if (!std::exchange(reported_, true)) Q_EMIT problem(tr("Your work is not saved automatically: %1").arg(fault));
        return;
    }
    saved_ = state.scenario;
    layoutSaved_ = state.layout;
    if (adoptedShown_ && adopted_) adopted_->remove();
    if (adoptedShown_) adopted_.reset();
}

bool StateKeeper::keepNow() {
    timer_.stop();
    writer_.waitForDone();
    if (workspace_->version() == 0) return false;
    const relief::Scenario& now = workspace_->scenario();
    if (now != saved_ && files_.take()) {
        files_.setStarting(false);
        writeState(now, layoutSaved_, files_.scenarioFile(), files_.layoutFile());
    }
    return QFileInfo::exists(files_.scenarioFile());
}

std::string StateKeeper::end() {
    timer_.stop();
    writer_.waitForDone();
    // Before the first scenario is shown there is nothing to keep, and the last state stays.
    const std::string fault = workspace_->version() == 0 ? std::string() : keepState(workspace_->scenario());
    if (fault.empty()) {
        if (adoptedShown_ && adopted_) adopted_->remove();
        files_.remove();
    }
    return fault;
}

}  // namespace reliefui
