#include "workspace/render_worker.h"

#include <chrono>
#include <new>

#include <QCoreApplication>

#include "workspace/language.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

// If a drag pauses for this long, the full picture is drawn, although the end of the drag was not reported.
constexpr auto kRest = std::chrono::milliseconds(150);
constexpr auto kBetweenProgress = std::chrono::milliseconds(50);

// Limit for drawing the pixels of a picture during a drag, if a coarser one is possible.
constexpr auto kTooSlow = std::chrono::milliseconds(200);

QString notesOf(const relief::Assets& assets) {
    QString text;
    for (const relief::Message& note : assets.height->notes) {
        text += (text.isEmpty() ? "" : " ") + QString::fromStdString(relief::sentence(note, uiLanguage()));
    }
    return text;
}

}  // namespace

RenderWorker::RenderWorker(const QObject* receiver, WorkerListener listener, relief::AssetStore store)
    : mailbox_(receiver),
      listener_(std::move(listener)),
      maker_(std::move(store)),
      thread_([this](const std::stop_token& quit) { run(quit); }) {}

RenderWorker::~RenderWorker() {
    thread_.request_stop();
    {
        const std::lock_guard lock(mutex_);
        stop_.request_stop();
    }
    wake_.notify_all();
}

void RenderWorker::render(RenderJob job) {
    {
        const std::lock_guard lock(mutex_);
        resting_ = !job.live;
        nextRender_ = std::move(job);
        toRefine_.reset();
        if (running_ == Running::Full) stop_.request_stop();
    }
    wake_.notify_all();
}

void RenderWorker::finishInteraction() {
    {
        const std::lock_guard lock(mutex_);
        if (nextRender_) nextRender_->live = false;
        resting_ = true;
        refineAt_ = Clock::now();
    }
    wake_.notify_all();
}

void RenderWorker::load(LoadJob job) {
    {
        const std::lock_guard lock(mutex_);
        nextLoad_ = std::move(job);
        if (running_ == Running::Load) stop_.request_stop();
    }
    wake_.notify_all();
}

void RenderWorker::cancelLoad() {
    const std::lock_guard lock(mutex_);
    nextLoad_.reset();
    if (running_ == Running::Load) stop_.request_stop();
}

void RenderWorker::cancel() {
    const std::lock_guard lock(mutex_);
    std::optional<RenderJob> dropped;
    dropped.swap(nextRender_);
    // The job's coarse picture may still be on its way to the receiver.
    if (!dropped) dropped.swap(toRefine_);
    toRefine_.reset();
    if (dropped) post([this, version = dropped->version] { listener_.failure({version, {}}); });
    if (nextLoad_) post([this, id = nextLoad_->id] { listener_.loaded({id, {}, {}, {}, true}); });
    nextLoad_.reset();
    if (running_ != Running::Nothing) {
        userCancel_ = true;
        stop_.request_stop();
    }
}

void RenderWorker::post(std::function<void()> call) {
    mailbox_.post(std::move(call));
}

void RenderWorker::postProgress(std::string_view what, double fraction) {
    {
        const std::lock_guard lock(progressMutex_);
        const auto now = Clock::now();
        if (fraction >= 0 && now - lastProgress_ < kBetweenProgress) return;
        lastProgress_ = now;
    }
    post([this, text = QString::fromUtf8(what.data(), static_cast<int>(what.size())), fraction] {
        listener_.progress(text, fraction);
    });
}

void RenderWorker::run(const std::stop_token& quit) {
    while (!quit.stop_requested()) {
        std::optional<LoadJob> load;
        std::optional<RenderJob> job;
        bool refining = false;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex_);
            const auto due = [&] { return toRefine_ && Clock::now() >= refineAt_; };
            const auto ready = [&] { return nextLoad_ || nextRender_ || due(); };
            if (toRefine_) {
                wake_.wait_until(lock, quit, refineAt_, ready);
            } else {
                wake_.wait(lock, quit, ready);
            }
            if (quit.stop_requested()) return;
            if (nextLoad_) {
                load.swap(nextLoad_);
            } else if (nextRender_) {
                job.swap(nextRender_);
            } else if (due()) {
                refining = true;
                job.swap(toRefine_);
            } else {
                continue;
            }
            stop_ = std::stop_source();
            stop = stop_.get_token();
            userCancel_ = tooSlow_ = false;
            drawingSince_.reset();
            running_ = load ? Running::Load : Running::Full;
        }
        relief::Work work(0, stop, [this](std::string_view what, double done) {
            watch(what);
            postProgress(what, done);
        });
        if (load) {
            runLoad(*load, work);
        } else {
            runRender(*job, refining, work);
        }
        const std::lock_guard lock(mutex_);
        running_ = Running::Nothing;
        postProgress({}, -1);
    }
}

// Runs body(). On an error, calls failed() with a one-line description; if the user cancelled, with an empty string.
// Work cancelled by newer work is not reported.
template <class Body>
void RenderWorker::guarded(const Body& body, const std::function<void(const QString& problem)>& failed) {
    QString problem;
    try {
        body();
        return;
    } catch (const relief::Cancelled&) {
        const std::lock_guard lock(mutex_);
        if (!userCancel_) return;
    } catch (const relief::InputError& error) {
        problem = QString::fromStdString(error.text(uiLanguage()));
    } catch (const std::bad_alloc&) {
        problem = QCoreApplication::translate("reliefui::RenderWorker", "not enough memory for this");
    } catch (const std::exception& error) {
        problem = QString::fromUtf8(error.what());
    }
    failed(problem);
}

void RenderWorker::runLoad(const LoadJob& job, relief::Work& work) {
    LoadResult result;
    result.id = job.id;
    result.scenario = job.scenario;
    guarded(
        [&] {
            const StateReaders& readers = job.readers ? *job.readers : StateReaders{};
            if (!job.path.isEmpty()) result.scenario = loadWindowScenario(job.path.toStdString(), readers);
            result.notes = notesOf(maker_.load(result.scenario.pictures, work));
        },
        [&](const QString& problem) {
            result.problem = problem;
            result.cancelled = problem.isEmpty();
        });
    if (work.stopped() && result.problem.isEmpty()) {
        const std::lock_guard lock(mutex_);
        if (!userCancel_) return;  // replaced by a newer load
        result.cancelled = true;
    }
    post([this, result] { listener_.loaded(result); });
}

// The renderer reports "frame" when it starts drawing pixels. Earlier stages, such as building maps, run once and are
// not limited.
void RenderWorker::watch(std::string_view what) {
    if (what != "frame") return;
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (!drawingSince_) drawingSince_ = now;
    if (running_ != Running::Moving || noCoarser_ || now - *drawingSince_ < kTooSlow) return;
    tooSlow_ = true;
    stop_.request_stop();
}

// Tells the renderer that the cancelled frame takes at least the time it has run.
void RenderWorker::learnFromCancelled(const RenderJob& job) {
    const std::lock_guard lock(mutex_);
    if (userCancel_ || !drawingSince_) return;
    const bool coarser = maker_.gaveUp(std::chrono::duration<double>(Clock::now() - *drawingSince_).count());
    if (!tooSlow_) return;
    noCoarser_ = !coarser;
    if (!nextRender_) nextRender_ = job;
}

void RenderWorker::drawMoving(const RenderJob& job, SnapshotOrder order, relief::Work& work) {
    {
        const std::lock_guard lock(mutex_);
        running_ = Running::Moving;
    }
    order.moving = true;
    const auto snapshot = maker_.make(order, work);
    post([this, snapshot] { listener_.snapshot(snapshot); });
    const std::lock_guard lock(mutex_);
    noCoarser_ = false;
    // Cancelled too late to be noticed by the drawing: the coarse picture stays, and no full one follows.
    if (userCancel_) return post([this, version = job.version] { listener_.failure({version, {}}); });
    if (!snapshot->coarse || nextRender_) return;
    toRefine_ = job;
    refineAt_ = Clock::now() + (resting_ ? std::chrono::milliseconds(0) : kRest);
}

void RenderWorker::runRender(const RenderJob& job, bool refining, relief::Work& work) {
    const auto failed = [&](const QString& problem) {
        post([this, failure = RenderFailure{job.version, problem}] { listener_.failure(failure); });
    };
    const SnapshotOrder order{job.scenario, job.version, job.layer, false, job.lastStep, job.levels, job.renewed};
    guarded(
        [&] {
            try {
                if (!refining && (job.live || maker_.takesLong(order, work))) return drawMoving(job, order, work);
                const auto snapshot = maker_.make(order, work);
                post([this, snapshot] { listener_.snapshot(snapshot); });
            } catch (const relief::Cancelled&) {
                learnFromCancelled(job);
                throw;
            }
        },
        failed);
}

}  // namespace reliefui
