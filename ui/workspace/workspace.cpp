#include "workspace/workspace.h"

#include <algorithm>

#include <QFileInfo>

#include "scenario/variation.h"
#include "workspace/change_name.h"
#include "workspace/hidden_answer.h"
#include "workspace/language.h"
#include "workspace/pane_store.h"
#include "workspace/range_json.h"
#include "workspace/render_worker.h"

namespace reliefui {

namespace {

// Returns true if the scenarios differ only in parts that need no computation.
bool onlyNotesDiffer(const relief::Scenario& a, const relief::Scenario& b) {
    return a == relief::withNotesOf(b, a);
}

void clampPixel(relief::Scenario& scenario) {
    if (!scenario.pixel) return;
    scenario.pixel->x = std::clamp(scenario.pixel->x, 0, std::max(0, scenario.width - 1));
    scenario.pixel->y = std::clamp(scenario.pixel->y, 0, std::max(0, scenario.height - 1));
}

// Returns true if pictures have to be loaded for the change; heights drawn by hand are already in memory.
bool needsLoading(const relief::Pictures& from, const relief::Pictures& to) {
    relief::Pictures same = to;
    if (!from.drawn.empty() && !to.drawn.empty()) same.drawn = from.drawn;
    return !(same == from);
}

// Limit of the picture's size, in addition to the core's own checks: larger values entered in a window are probably
// typing errors, and would need the machine's whole memory.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 25;

void checkForWindow(const relief::Scenario& scenario, const StateReaders* readers) {
    relief::checkScenario(scenario, {});
    if (readers != nullptr) checkStates(scenario, *readers, {});
    const std::int64_t pixels = std::int64_t{scenario.width} * scenario.height;
    if (pixels <= kMostPixels) return;
    throw relief::InputError(
        {}, relief::Message(relief::MessageId::OutOfRange,
                            {{"what", relief::MessageId::WordPictureSize},
                             {"value", pixels},
                             {"range", relief::Message(relief::MessageId::RangeAtMost, {{"high", kMostPixels}})}}));
}

int lastStep(const Snapshot& snapshot) {
    return std::max(0, static_cast<int>(snapshot.trace.steps.size()) - 1);
}

}  // namespace

Workspace::Workspace(std::shared_ptr<const StateReaders> readers, QObject* parent)
    : QObject(parent), readers_(std::move(readers)) {
    style_.language = uiLanguage();
}

// Ends the worker's thread: cancels the running job and waits for it.
Workspace::~Workspace() {
    worker_.reset();
}

void Workspace::start(const relief::Scenario& scenario, relief::AssetStore store) {
    WorkerListener listener;
    listener.snapshot = [this](std::shared_ptr<const Snapshot> snapshot) { takeSnapshot(std::move(snapshot)); };
    listener.failure = [this](const RenderFailure& failure) { fail(failure); };
    listener.loaded = [this](const LoadResult& result) { finishLoad(result); };
    listener.progress = [this](const QString& what, double fraction) { Q_EMIT progress(what, fraction); };
    worker_ = std::make_unique<RenderWorker>(this, std::move(listener), std::move(store));
    load({0, Action::Start, scenario, tr("Start"), {}, {}});
}

void Workspace::change(const relief::Scenario& scenario, const QString& what, const QString& mergeKey, bool live) {
    relief::Scenario requested = relief::keptApart(scenario_, scenario);
    clampPixel(requested);
    if (requested == scenario_ || past_.empty()) return;
    try {
        checkForWindow(requested, readers_.get());
    } catch (const relief::InputError& error) {
        Q_EMIT problem(QString::fromStdString(error.text(uiLanguage())));
        Q_EMIT scenarioChanged();  // resets the controls to the actual values
        return;
    }
    if (needsLoading(scenario_.pictures, requested.pictures)) {
        load({0, Action::Change, requested, what, mergeKey, {}});
        return;
    }
    if (pending_ && (pending_->action == Action::Undo || pending_->action == Action::Redo)) {
        pending_.reset();
        worker_->cancelLoad();
    }
    // If the chosen step was the ray's last one, it stays the last one when the ray changes.
    const bool atEnd = snapshot_ && scenario_.step >= lastStep(*snapshot_);
    if (atEnd && !keepStep_ && !onlyNotesDiffer(requested, scenario_)) toLastStep_ = true;
    past_.push({requested, what, mergeKey});
    apply(requested, live);
}

void Workspace::apply(const relief::Scenario& scenario, bool live) {
    const bool notesOnly = onlyNotesDiffer(scenario, scenario_) && version_ > 0;
    const bool agreed = goodVersion_ == version_;
    const bool step = scenario.step != scenario_.step;
    const bool panes = scenario.ui != scenario_.ui;
    const bool notes =
        panes || scenario.breakpoints != scenario_.breakpoints || scenario.bookmarks != scenario_.bookmarks;
    const auto range = [&](const relief::Scenario& of) { return rangesOf(of).of(*rangeOf(layer_)); };
    const bool recolor = notesOnly && panes && rangeOf(layer_) && range(scenario) != range(scenario_);
    scenario_ = scenario;
    if (panes) Q_EMIT panesChanged();
    if (notesOnly) {
        if (recolor) requestRender(false);  // recolours the existing picture
        if (agreed) good_ = past_;
        if (step) Q_EMIT stepChanged(scenario_.step);
        if (notes) Q_EMIT notesChanged();
        return;
    }
    version_ = ++lastVersion_;
    Q_EMIT scenarioChanged();
    requestRender(live);
}

void Workspace::requestRender(bool live) {
    waiting_ = true;
    requests_.emplace_back(version_, past_);
    if (requests_.size() > kMostRequested) requests_.pop_front();
    worker_->render({scenario_, version_, layer_, toLastStep_, live, levels_, renewed_});
    reportBusy();
}

void Workspace::finishInteraction() {
    past_.close();
    if (worker_) worker_->finishInteraction();
}

void Workspace::choosePixel(int x, int y) {
    relief::Scenario requested = scenario_;
    requested.pixel = relief::PixelChoice{x, y};
    clampPixel(requested);
    if (requested.pixel == scenario_.pixel || past_.empty()) return;
    toLastStep_ = raysFromEnd_;
    // Start at the beginning of the search, not at its result.
    if (!raysFromEnd_) requested.step = 0;
    // Each click is one undo entry. Arrow keys in succession share one, because no finishInteraction() comes between
    // them.
    keepStep_ = true;
    change(requested, changeName([] { return tr("Choose pixel"); }), QStringLiteral("pixel"));
    keepStep_ = false;
}

void Workspace::chooseStep(int step) {
    if (!snapshot_ || snapshot_->trace.steps.empty() || guessing_) return;
    relief::Scenario requested = scenario_;
    requested.step = std::clamp(step, 0, lastStep(*snapshot_));
    if (requested.step == scenario_.step) return;
    toLastStep_ = false;
    past_.push({requested, changeName([] { return tr("Choose step"); }), QStringLiteral("step")});
    apply(requested, false);
}

void Workspace::setBreakpoints(std::vector<relief::Breakpoint> breakpoints, const QString& what) {
    relief::Scenario requested = scenario_;
    requested.breakpoints = std::move(breakpoints);
    change(requested, what);
}

void Workspace::setBookmarks(std::vector<relief::Bookmark> bookmarks, const QString& what) {
    relief::Scenario requested = scenario_;
    requested.bookmarks = std::move(bookmarks);
    change(requested, what);
}

// Pixel and step are clamped to the picture and, if the bookmark's ray is the one shown, to that ray; the steps of
// another ray are known only after it is traced.
relief::Scenario Workspace::at(const relief::Bookmark& bookmark) const {
    relief::Scenario there = scenario_;
    there.camera = bookmark.camera;
    there.pixel = bookmark.pixel;
    there.step = bookmark.step;
    clampPixel(there);
    const bool traced = snapshot_ && snapshot_->version == version_ && onlyNotesDiffer(there, scenario_);
    if (traced) there.step = std::min(there.step, lastStep(*snapshot_));
    return there;
}

bool Workspace::isAt(const relief::Bookmark& bookmark) const {
    return at(bookmark) == scenario_;
}

void Workspace::goTo(const relief::Bookmark& bookmark) {
    toLastStep_ = false;
    keepStep_ = true;
    change(at(bookmark), changeName([to = QString::fromStdString(bookmark.name)] { return tr("Go to %1").arg(to); }));
    keepStep_ = false;
}

void Workspace::setGuessing(bool on) {
    if (on == guessing_) return;
    guessing_ = on;
    hideAnswer();
    Q_EMIT guessingChanged(on);
    Q_EMIT snapshotChanged();
}

void Workspace::hideAnswer() {
    hidden_ = guessing_ && snapshot_ ? withoutAnswer(*snapshot_) : nullptr;
}

void Workspace::setLayer(Layer layer) {
    if (layer == layer_) return;
    layer_ = layer;
    Q_EMIT layerChanged();
    if (worker_ && version_ > 0) requestRender(false);
}

void Workspace::setLevels(relief::PyramidKind levels) {
    if (levels == levels_) return;
    levels_ = levels;
    const bool have = snapshot_ && snapshot_->has(levels);
    if (!have && worker_ && version_ > 0) requestRender(false);
}

void Workspace::setStyle(const Style& style) {
    if (style == style_) return;
    style_ = style;
    Q_EMIT styleChanged();
}

void Workspace::open(const QString& path) {
    const QFileInfo file(path);
    Pending pending{0,         Action::Open,
                    scenario_, changeName([name = file.fileName()] { return tr("Open %1").arg(name); }),
                    {},        file.absoluteFilePath()};
    if (file.suffix().compare(QLatin1String("json"), Qt::CaseInsensitive) != 0) {
        const int memory = scenario_.pictures.memory;
        pending.scenario.pictures = {};
        pending.scenario.pictures.memory = memory;
        pending.scenario.pictures.height = file.absoluteFilePath().toStdString();
    }
    load(std::move(pending));
}

void Workspace::show(const relief::Scenario& scenario, const QString& what) {
    load({0, Action::Open, scenario, what, {}, {}, true});
}

void Workspace::load(Pending pending) {
    pending.id = ++lastLoad_;
    const bool json =
        pending.action == Action::Open && pending.path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
    pending_ = std::move(pending);
    worker_->load({pending_->id, pending_->scenario, json ? pending_->path : QString(), readers_});
    reportBusy();
}

void Workspace::finishLoad(const LoadResult& result) {
    if (!pending_ || pending_->id != result.id) return;
    Pending pending = std::move(*pending_);
    pending_.reset();
    if (result.cancelled || !result.problem.isEmpty()) {
        if (!result.problem.isEmpty()) Q_EMIT problem(result.problem);
        Q_EMIT scenarioChanged();  // resets the controls to the actual values
        reportBusy();
        return;
    }
    pending.scenario = result.scenario;
    try {
        checkForWindow(pending.scenario, readers_.get());
    } catch (const relief::InputError& error) {
        Q_EMIT problem(QString::fromStdString(error.text(uiLanguage())));
        reportBusy();
        return;
    }
    accept(pending);
    reportBusy();  // nothing is rendered if only notes differ
    if (!result.notes.isEmpty()) Q_EMIT notice(result.notes);
    if (pending.action == Action::Open && !pending.path.isEmpty()) Q_EMIT opened(pending.path);
}

void Workspace::accept(const Pending& pending) {
    relief::Scenario scenario = pending.scenario;
    toLastStep_ = false;
    if (pending.action == Action::Undo) {
        past_.undo();
    } else if (pending.action == Action::Redo) {
        past_.redo();
    } else {
        const bool wholeScenario = pending.whole || pending.path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
        if (!past_.empty() && !wholeScenario) {
            // Changes made while the pictures were loading are kept.
            scenario = scenario_;
            scenario.pictures = pending.scenario.pictures;
        }
        toLastStep_ = pending.action == Action::Change;
        past_.push({scenario, pending.what, pending.mergeKey});
    }
    apply(scenario, false);
}

void Workspace::travel(Action action) {
    const bool back = action == Action::Undo;
    if (back ? !past_.canUndo() : !past_.canRedo()) return;
    past_.close();
    const History::Entry& target = back ? past_.undone() : past_.redone();
    if (needsLoading(scenario_.pictures, target.scenario.pictures)) {
        load({0, action, target.scenario, target.what, {}, {}});
        return;
    }
    accept({0, action, target.scenario, target.what, {}, {}});
}

void Workspace::undo() {
    travel(Action::Undo);
}

void Workspace::redo() {
    travel(Action::Redo);
}

void Workspace::pointAtTexel(std::optional<std::size_t> texel) {
    if (texel == texel_) return;
    texel_ = texel;
    Q_EMIT texelChanged();
}

void Workspace::cancel() {
    tasks_.cancel();
    if (!worker_) return;
    worker_->cancel();
    if (snapshot_ && snapshot_->version == version_) waiting_ = false;  // a coarse picture stays
    reportBusy();
}

void Workspace::takeSnapshot(std::shared_ptr<const Snapshot> snapshot) {
    if (snapshot_ && snapshot->version < snapshot_->version) return;
    // The index refers to the list of another footprint.
    if (!snapshot_ || snapshot_->footprint != snapshot->footprint) texel_.reset();
    const auto unread = snapshot_ ? snapshot_->otherProblem : nullptr;
    snapshot_ = std::move(snapshot);
    hideAnswer();
    if (snapshot_->otherProblem && snapshot_->otherProblem != unread) {
        Q_EMIT problem(QString::fromStdString(snapshot_->otherProblem->text(uiLanguage())));
    }
    if (snapshot_->version == version_) {
        const int last = lastStep(*snapshot_);
        const int step = toLastStep_ ? last : std::clamp(scenario_.step, 0, last);
        toLastStep_ = false;
        if (step != scenario_.step) {
            scenario_.step = step;
            past_.amend(scenario_);
        }
        if (!snapshot_->coarse) waiting_ = false;
        good_ = past_;
        goodVersion_ = version_;
        requests_.clear();
    } else {
        // A snapshot of an older version: it becomes the state to return to if the later changes are cancelled.
        while (!requests_.empty() && requests_.front().first < snapshot_->version) requests_.pop_front();
        if (!requests_.empty() && requests_.front().first == snapshot_->version) {
            good_ = std::move(requests_.front().second);
            goodVersion_ = snapshot_->version;
        }
    }
    Q_EMIT snapshotChanged();
    // A step chosen while the worker was busy is kept.
    if (snapshot_->version == version_ && snapshot_->scenario.step != scenario_.step)
        Q_EMIT stepChanged(scenario_.step);
    reportBusy();
}

void Workspace::fail(const RenderFailure& failure) {
    if (failure.version != version_) return;
    if (!failure.problem.isEmpty()) Q_EMIT problem(failure.problem);
    waiting_ = false;
    if (goodVersion_ != version_) goBack();
    reportBusy();
}

// Returns to the last state that was shown, with its history.
void Workspace::goBack() {
    if (good_.empty()) return;
    toLastStep_ = false;
    past_ = good_;
    past_.close();
    scenario_ = past_.current().scenario;
    Q_EMIT panesChanged();
    const bool shown = snapshot_ && snapshot_->version == goodVersion_;
    version_ = shown ? goodVersion_ : ++lastVersion_;
    requests_.clear();
    Q_EMIT scenarioChanged();
    if (!shown) requestRender(false);
}

void Workspace::save(const QString& path) {
    try {
        relief::saveScenario(path.toStdString(), scenario_);
    } catch (const relief::InputError& error) {
        Q_EMIT problem(QString::fromStdString(error.text(uiLanguage())));
    }
}

void Workspace::renew() {
    if (!worker_ || version_ == 0) return;
    ++renewed_;
    requestRender(false);
}

QString Workspace::traceCommand() const {
    return QString::fromStdString(relief::traceCommand(scenario_));
}

bool Workspace::busy() const {
    return pending_.has_value() || waiting_;
}

void Workspace::reportBusy() {
    if (busy() == reportedBusy_) return;
    reportedBusy_ = busy();
    Q_EMIT busyChanged(reportedBusy_);
    // Panes without a snapshot show whether the first one is being computed.
    if (!snapshot_) Q_EMIT styleChanged();
}

}  // namespace reliefui
