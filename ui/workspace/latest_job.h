// A thread for a pane's own computations, separate from the render worker. Starting a job cancels the previous one. The
// listener is called on the receiver's thread, in order, and only about the latest job.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <QObject>
#include <QString>

#include "relief/work.h"
#include "workspace/mailbox.h"

namespace reliefui {

class LatestJob {
  public:
    // work: runs on the job's thread; may throw. done: called afterwards on the receiver's thread.
    struct Job {
        std::function<void(relief::Work&)> work;
        std::function<void()> done;
    };
    // Called on the receiver's thread. failed: receives a one-line problem; empty if the user cancelled.
    struct Listener {
        std::function<void(const QString& problem)> failed;
        std::function<void(const QString& what, double fraction)> progress;
    };

    // Must be constructed on the receiver's thread.
    LatestJob(const QObject* receiver, Listener listener);
    ~LatestJob();
    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    void start(Job job);
    // Cancels the job on behalf of the user, and reports that to the listener; no result of the job follows. Returns
    // false if there is none.
    bool cancel();
    // Cancels the job without a report.
    void drop();
    bool busy() const;

  private:
    using Clock = std::chrono::steady_clock;

    void run(const std::stop_token& quit);
    void runOne(const Job& job, std::uint64_t id, const std::stop_token& stop);
    // Posts a call to the receiver's thread; it is dropped if a newer job has been started by then.
    void post(std::uint64_t id, std::function<void()> call);

    Mailbox mailbox_;
    Listener listener_;
    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Job> next_;
    std::uint64_t latest_ = 0;    // id of the job started last, or of its cancelling
    std::uint64_t answered_ = 0;  // id of the last job whose end was reported; receiver's thread only
    std::stop_source stop_;
    std::mutex progressMutex_;
    Clock::time_point lastProgress_;
    std::jthread thread_;  // last member: the thread ends before the others are destroyed
};

}  // namespace reliefui
