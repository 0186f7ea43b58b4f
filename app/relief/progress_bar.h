// The bar on the terminal: only there, only for work over a second, with the time left, and gone when the work is.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

#include "relief/messages.h"
#include "relief/work.h"

namespace relief::app {

class ProgressBar {
  public:
    // shown: false keeps it silent (--quiet, or standard error is not a terminal).
    ProgressBar(bool shown, Language language);
    ~ProgressBar() { erase(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // Thread safe; the listener of a Work. Lives no longer than the bar.
    Progress::Listener listener();
    // Before anything else is written to the terminal.
    void erase();

  private:
    using Clock = std::chrono::steady_clock;

    void update(std::string_view what, double fraction);

    bool shown_;
    Language language_;
    std::mutex mutex_;
    std::string what_;
    Clock::time_point begun_;  // of the running stage
    Clock::time_point drawn_;
    bool visible_ = false;
};

// "3 s", "2 min 05 s"; rounded up, at least one second.
std::string durationText(double seconds);

// One line, no wider than `columns`: "tracing  [#####-----]  50%  3 s left".
std::string progressLine(std::string_view what, double fraction, double secondsLeft, int columns, Language language);

}  // namespace relief::app
