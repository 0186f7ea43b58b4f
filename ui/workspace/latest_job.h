// One thread for work that a pane waits for, apart from the pictures' own: the latest job wins and stops an older one.
// What is said about a job is said on the receiver's thread, in order, and only about the latest.
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
    // work: on the job's thread; may throw. done: after it, on the receiver's.
    struct Job {
        std::function<void(relief::Work&)> work;
        std::function<void()> done;
    };
    // Called on the receiver's thread. failed: a problem in one line; empty: cancelled by the user.
    struct Listener {
        std::function<void(const QString& problem)> failed;
        std::function<void(const QString& what, double fraction)> progress;
    };

    // To be made on the receiver's thread.
    LatestJob(const QObject* receiver, Listener listener);
    ~LatestJob();
    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    void start(Job job);
    // By the user: said to the listener.
    void cancel();
    // Nobody wants it any more: nothing is said.
    void drop();
    bool busy() const;

  private:
    using Clock = std::chrono::steady_clock;

    void run(const std::stop_token& quit);
    void runOne(const Job& job, std::uint64_t id, const std::stop_token& stop);
    // Calls back, unless a newer job has come meanwhile.
    void post(std::uint64_t id, std::function<void()> call);

    Mailbox mailbox_;
    Listener listener_;
    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Job> next_;
    std::uint64_t latest_ = 0;    // id of the job that was started last
    std::uint64_t answered_ = 0;  // the receiver was told the end of; its thread only
    std::stop_source stop_;
    bool userCancel_ = false;
    std::mutex progressMutex_;
    Clock::time_point progressTold_;
    std::jthread thread_;  // last: ends before the rest
};

}  // namespace reliefui
