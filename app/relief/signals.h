// Ctrl-C asks the work to stop, so that it ends in order: partial files removed, the terminal left clean.
#pragma once

#include <signal.h>

#include <atomic>
#include <stop_token>
#include <thread>

namespace relief::app {

// Make it before any other thread: they inherit the blocked signals. A second signal ends the program at once.
class SignalWatch {
  public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    std::stop_token stop() const { return source_.get_token(); }
    // 128 + the signal's number, as shells count; 0 where there was none.
    int exitStatus() const { return status_; }

  private:
    void watch(const std::stop_token& end);

    sigset_t signals_{};
    bool watching_ = false;
    std::stop_source source_;
    std::atomic<int> status_{0};
    std::jthread thread_;
};

}  // namespace relief::app
