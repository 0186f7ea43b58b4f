// The thread on which everything is computed. The latest request wins: a newer one cancels a full picture in the
// making; the pictures of a drag are finished, so that it is seen while it goes on, except that one which takes far too
// long gives way to a coarser one.
// Results are handed over on the receiver's thread, in order.
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
    bool lastStep = false;  // the ray's last step is the chosen one
    bool live = false;      // something is being dragged: a picture in time now, the full one when it rests
    relief::PyramidKind levels = relief::PyramidKind::Max;  // what the pyramid's pane shows
};

// What is loaded before it becomes part of the open scenario: its pictures, and the scenario itself if `path` is given.
struct LoadJob {
    std::uint64_t id = 0;
    relief::Scenario scenario;
    QString path;
    std::shared_ptr<const StateReaders> readers;  // may be null
};

struct LoadResult {
    std::uint64_t id = 0;
    relief::Scenario scenario;
    QString notes;    // what was done to the heights, for people; may be empty
    QString problem;  // one line; empty: done, or cancelled
    bool cancelled = false;
};

struct RenderFailure {
    std::uint64_t version = 0;
    QString problem;  // one line; empty: cancelled by the user
};

// Called on the receiver's thread.
struct WorkerListener {
    std::function<void(std::shared_ptr<const Snapshot>)> snapshot;
    std::function<void(const RenderFailure&)> failure;
    std::function<void(const LoadResult&)> loaded;
    std::function<void(const QString& what, double fraction)> progress;  // fraction < 0: done
};

class RenderWorker {
  public:
    // Listeners are called on the calling thread, which is the receiver's.
    RenderWorker(const QObject* receiver, WorkerListener listener, relief::AssetStore store);
    ~RenderWorker();
    RenderWorker(const RenderWorker&) = delete;
    RenderWorker& operator=(const RenderWorker&) = delete;

    void render(RenderJob job);
    // The drag has ended: the full picture now.
    void settle();
    // A newer load replaces an older one that is not done.
    void load(LoadJob job);
    // Stops everything that is running or waiting; each says so to the listener.
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
    std::optional<RenderJob> toRefine_;  // was drawn coarse
    Clock::time_point refineAt_;
    bool resting_ = true;  // nothing is being dragged
    Running running_ = Running::Nothing;
    std::stop_source stop_;    // of what is running
    bool userCancel_ = false;  // it was stopped by the user, not by newer work
    std::optional<Clock::time_point> drawingSince_;
    bool tooSlow_ = false;  // it was stopped to be drawn coarser
    bool patient_ = false;  // nothing is coarser: it is waited for

    std::mutex progressMutex_;
    Clock::time_point progressTold_;

    std::jthread thread_;  // last: ends before the rest
};

}  // namespace reliefui
