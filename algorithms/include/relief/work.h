// The context of calls that can take long: progress, cancellation, threads and counters. There is no global state, so
// that two contexts with different settings can run at the same time.
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

// Totals of work done and skipped, by message (such as MessageId::CountRaysTraced). Hot loops count in local variables
// and add once per tile. Thread safe.
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

// Progress of one stage of work: begin() sets its name and number of units, and advance() may be called from any
// thread. The listener is called from the working threads, at most once per thousandth of the total.
class Progress {
  public:
    // what: name of the stage; fraction in [0, 1].
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
        reportedPermille_ = -1;
        if (listener_) listener_(what_, 0.0);
    }
    void add(std::int64_t amount) {
        const std::int64_t done = done_.fetch_add(amount) + amount;
        if (!listener_) return;
        const std::int64_t total = total_;
        const std::int64_t permille = total > 0 ? done * 1000 / total : 1000;
        if (permille == reportedPermille_.load(std::memory_order_relaxed)) return;
        const std::lock_guard lock(mutex_);
        if (permille <= reportedPermille_) return;
        reportedPermille_ = permille;
        listener_(what_, static_cast<double>(permille) / 1000.0);
    }

    std::mutex mutex_;
    std::string what_;
    Listener listener_;
    std::atomic<std::int64_t> total_{0};
    std::atomic<std::int64_t> done_{0};
    std::atomic<std::int64_t> reportedPermille_{-1};
    std::atomic<bool> whole_{false};
};

// Reports several stages as one: stages that begin during its lifetime are not reported.
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

// The context of one task. It must outlive the calls that use it. Thread safe.
class Work {
  public:
    Work() : Work(0) {}
    // threads: number of threads; limited to the number of hardware threads, which is also the meaning of 0.
    explicit Work(int threads, std::stop_token stop = {}, Progress::Listener listener = {})
        : stop_(std::move(stop)), progress_(std::move(listener)), threads_(threads) {}

    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    bool stopped() const { return stop_.stop_requested(); }
    // Throws Cancelled if a stop was requested. Long work calls it once per tile.
    void throwIfStopped() const {
        if (stopped()) throw Cancelled();
    }
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
