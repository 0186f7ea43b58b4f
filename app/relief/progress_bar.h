// How far long work is: on a terminal a bar with the time left, which is gone when the work is; elsewhere, where that
// is asked for, a line now and then. Both only for work over a second.
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
    // shown: draw the bar, if standard error is a terminal. lines: write lines where it is none.
    ProgressBar(bool shown, bool lines, Language language);
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
    bool lines_;
    Language language_;
    std::mutex mutex_;
    std::string what_;
    Clock::time_point begun_;  // of the running stage
    Clock::time_point drawn_;
    bool visible_ = false;
    bool said_ = false;  // a line of the running stage
};

// "3 s", "2 min 05 s"; rounded up, at least one second.
std::string durationText(double seconds);

// A line of a log: "tracing: 50%, 3 s left".
std::string progressSentence(std::string_view what, double fraction, double secondsLeft, Language language);

// One line, no wider than `columns`: "tracing  [#####-----]  50%  3 s left".
std::string progressLine(std::string_view what, double fraction, double secondsLeft, int columns, Language language);

}  // namespace relief::app
