// What every call that can take long is given: where to report progress, when to stop, on which threads to run, and
// where to count. A value of references: two workspaces with two configurations run side by side.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>

#include "relief/errors.h"
#include "relief/messages.h"
#include "relief/thread_team.h"

namespace relief {

// Totals of what was done and what was skipped, each by its message (MessageId::CountRaysTraced). Hot loops count in
// locals and add once a tile. Thread safe.
class Counters {
  public:
    void add(MessageId what, double amount) {
        const std::lock_guard lock(mutex_);
        values_[what] += amount;
    }
    void clear() {
        const std::lock_guard lock(mutex_);
        values_.clear();
    }
    std::map<MessageId, double> values() const {
        const std::lock_guard lock(mutex_);
        return values_;
    }

  private:
    mutable std::mutex mutex_;
    std::map<MessageId, double> values_;
};

// Progress of one piece of work: `what` is said once, `done` of `total` units may be added from any thread.
// The listener is called from the working threads, at most once per thousandth of the total.
class Progress {
  public:
    // what: name of the running stage; fraction in [0, 1].
    using Listener = std::function<void(std::string_view what, double fraction)>;

    Progress() = default;
    explicit Progress(Listener listener) : listener_(std::move(listener)) {}

    void begin(std::string_view what, std::int64_t total) {
        if (!whole_) restart(what, total);
    }
    void advance(std::int64_t amount = 1) {
        if (!whole_) add(amount);
    }

  private:
    friend class WholeProgress;

    void restart(std::string_view what, std::int64_t total) {
        const std::lock_guard lock(mutex_);
        what_ = what;
        total_ = total;
        done_ = 0;
        told_ = -1;
        if (listener_) listener_(what_, 0.0);
    }
    void add(std::int64_t amount) {
        const std::int64_t done = done_.fetch_add(amount) + amount;
        if (!listener_) return;
        const std::int64_t total = total_;
        const std::int64_t permille = total > 0 ? done * 1000 / total : 1000;
        if (permille == told_.load(std::memory_order_relaxed)) return;
        const std::lock_guard lock(mutex_);
        if (permille <= told_) return;
        told_ = permille;
        listener_(what_, static_cast<double>(permille) / 1000.0);
    }

    std::mutex mutex_;
    std::string what_;
    Listener listener_;
    std::atomic<std::int64_t> total_{0};
    std::atomic<std::int64_t> done_{0};
    std::atomic<std::int64_t> told_{-1};
    std::atomic<bool> whole_{false};
};

// Work of several stages that is told as one piece: stages that begin while this lives are not told.
class WholeProgress {
  public:
    WholeProgress(Progress& progress, std::string_view what, std::int64_t total)
        : progress_(progress), outermost_(!progress.whole_.exchange(true)) {
        if (outermost_) progress_.restart(what, total);
    }
    ~WholeProgress() {
        if (outermost_) progress_.whole_ = false;
    }
    WholeProgress(const WholeProgress&) = delete;
    WholeProgress& operator=(const WholeProgress&) = delete;

    void advance(std::int64_t amount = 1) {
        if (outermost_) progress_.add(amount);
    }

  private:
    Progress& progress_;
    bool outermost_;
};

class Work {
  public:
    Work() : Work(0) {}
    // threads: 0 for all there are; more than that are not taken.
    explicit Work(int threads, std::stop_token stop = {}, Progress::Listener listener = {})
        : stop_(std::move(stop)), progress_(std::move(listener)), threads_(threads) {}

    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    bool stopped() const { return stop_.stop_requested(); }
    // To be called once a tile: long work ends here when nobody wants it any more.
    void throwIfStopped() const {
        if (stopped()) throw Cancelled();
    }
    void setStop(std::stop_token stop) { stop_ = std::move(stop); }
    Progress& progress() { return progress_; }
    Counters& counters() { return counters_; }
    ThreadTeam& threads() { return threads_; }

  private:
    std::stop_token stop_;
    Progress progress_;
    Counters counters_;
    ThreadTeam threads_;
};

}  // namespace relief
