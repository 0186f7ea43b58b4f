// Bounds the time of a step of the advice, such as building one map.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "relief/work.h"

namespace relief {

// Requests a stop at the deadline or when the outer work is stopped, from a thread of its own. Keeps a reference to
// outer.
class BuildWatch {
  public:
    BuildWatch(const Work& outer, double seconds)
        : until_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
          thread_([this, &outer](const std::stop_token& over) { watch(outer, over); }) {}

    std::stop_token token() const { return source_.get_token(); }

  private:
    using Clock = std::chrono::steady_clock;

    void watch(const Work& outer, const std::stop_token& over) {
        constexpr auto kPollInterval = std::chrono::milliseconds(20);
        std::unique_lock lock(mutex_);
        while (!over.stop_requested()) {
            if (outer.stopped() || Clock::now() > until_) {
                source_.request_stop();
                return;
            }
            wake_.wait_for(lock, over, kPollInterval, [] { return false; });
        }
    }

    Clock::time_point until_;
    std::stop_source source_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread thread_;
};

}  // namespace relief
