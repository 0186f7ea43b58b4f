// Turns Ctrl-C into a stop request, so that the work ends regularly: partial files are removed, and the terminal is
// left clean.
#pragma once

#include <signal.h>

#include <atomic>
#include <stop_token>
#include <string>
#include <thread>

namespace relief::app {

// To be created before any other thread, because threads inherit the blocked signals. A second signal ends the program
// at once.
class SignalWatch {
  public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    std::stop_token stop() const { return source_.get_token(); }
    // Returns 128 + the signal's number, as shells do; 0 if there was no signal.
    int exitStatus() const { return status_; }

  private:
    void watch(const std::stop_token& end);

    sigset_t signals_{};
    bool watching_ = false;
    std::stop_source source_;
    std::atomic<int> status_{0};
    std::jthread thread_;
};

// Returns "SIGINT" for SignalWatch::exitStatus() after that signal.
std::string signalName(int status);

}  // namespace relief::app
