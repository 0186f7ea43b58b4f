// The thread that computes snapshots and loads files. The latest request wins: a newer one cancels a full picture in
// progress. Pictures of a drag are completed, so that the view follows the drag, unless one takes far too long: it is
// cancelled and drawn coarser. Results are delivered on the receiver's thread, in order.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <QObject>
#include <QString>

#include "workspace/mailbox.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

struct StateReaders;

struct RenderJob {
    relief::Scenario scenario;
    std::uint64_t version = 0;
    Layer layer = Layer::Color;
    bool lastStep = false;  // choose the ray's last step
    bool live = false;      // part of a drag: draw a picture in time first, and the full one when the drag rests
    relief::PyramidKind levels = relief::PyramidKind::Max;  // shown in the pyramid pane
    std::uint64_t renewed = 0;                              // how often the other tracer's files were to be read again
};

// Loads what a new scenario needs before it is opened: its pictures, and the scenario itself if `path` is given.
struct LoadJob {
    std::uint64_t id = 0;
    relief::Scenario scenario;
    QString path;
    std::shared_ptr<const StateReaders> readers;  // may be null
};

struct LoadResult {
    std::uint64_t id = 0;
    relief::Scenario scenario;
    QString notes;    // what was done to the heights, as text for the user; may be empty
    QString problem;  // one line; empty if the load succeeded or was cancelled
    bool cancelled = false;
};

struct RenderFailure {
    std::uint64_t version = 0;
    QString problem;  // one line; empty if the user cancelled
};

// All members are called on the receiver's thread.
struct WorkerListener {
    std::function<void(std::shared_ptr<const Snapshot>)> snapshot;
    std::function<void(const RenderFailure&)> failure;
    std::function<void(const LoadResult&)> loaded;
    std::function<void(const QString& what, double fraction)> progress;  // fraction < 0: finished
};

class RenderWorker {
  public:
    // Must be called on the receiver's thread, on which the listener is then called.
    RenderWorker(const QObject* receiver, WorkerListener listener, relief::AssetStore store);
    ~RenderWorker();
    RenderWorker(const RenderWorker&) = delete;
    RenderWorker& operator=(const RenderWorker&) = delete;

    void render(RenderJob job);
    // Reports the end of a drag: the full picture is drawn at once.
    void finishInteraction();
    // Replaces an earlier load that is not finished.
    void load(LoadJob job);
    // Cancels all running and waiting work; each part is reported to the listener as cancelled.
    void cancel();
    void cancelLoad();

  private:
    enum class Running : std::uint8_t { Nothing, Load, Moving, Full };
    using Clock = std::chrono::steady_clock;

    void run(const std::stop_token& quit);
    void runLoad(const LoadJob& job, relief::Work& work);
    void runRender(const RenderJob& job, bool refining, relief::Work& work);
    void drawMoving(const RenderJob& job, SnapshotOrder order, relief::Work& work);
    void learnFromCancelled(const RenderJob& job);
    void watch(std::string_view what);
    template <class Body>
    void guarded(const Body& body, const std::function<void(const QString& problem)>& failed);
    void post(std::function<void()> call);
    void postProgress(std::string_view what, double fraction);

    Mailbox mailbox_;
    WorkerListener listener_;
    SnapshotMaker maker_;

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<LoadJob> nextLoad_;
    std::optional<RenderJob> nextRender_;
    std::optional<RenderJob> toRefine_;  // was drawn coarse; the full picture follows
    Clock::time_point refineAt_;
    bool resting_ = true;  // no drag in progress
    Running running_ = Running::Nothing;
    std::stop_source stop_;    // of the running job
    bool userCancel_ = false;  // stopped by the user, not by newer work
    std::optional<Clock::time_point> drawingSince_;
    bool tooSlow_ = false;    // stopped in order to be drawn coarser
    bool noCoarser_ = false;  // no coarser picture is possible, so the drawing time is not limited

    std::mutex progressMutex_;
    Clock::time_point lastProgress_;

    std::jthread thread_;  // last member: the thread ends before the others are destroyed
};

}  // namespace reliefui
