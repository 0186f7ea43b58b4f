// Progress of long work: on a terminal a bar with the remaining time, erased when the work ends; elsewhere, if
// requested, a line every few seconds. Both are shown only for work of more than a second.
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
    // shown: draws the bar, if standard error is a terminal. lines: writes lines if it is not.
    ProgressBar(bool shown, bool lines, Language language);
    ~ProgressBar() { erase(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // Returns the listener for a Work. Thread-safe; must not outlive the bar.
    Progress::Listener listener();
    // To be called before anything else is written to the terminal.
    void erase();

  private:
    using Clock = std::chrono::steady_clock;

    void update(std::string_view what, double fraction);

    bool shown_;
    bool lines_;
    Language language_;
    std::mutex mutex_;
    std::string what_;
    Clock::time_point begun_;  // start of the running stage
    Clock::time_point drawn_;
    bool visible_ = false;
    bool lineWritten_ = false;  // a line was written for the running stage
};

// Returns "3 s" or "2 min 05 s"; rounded up, at least one second.
std::string durationText(double seconds);

// Returns a line of a log: "tracing: 50%, 3 s left".
std::string progressSentence(std::string_view what, double fraction, double secondsLeft, Language language);

// Returns one line of at most `columns` characters: "tracing  [#####-----]  50%  3 s left".
std::string progressLine(std::string_view what, double fraction, double secondsLeft, int columns, Language language);

}  // namespace relief::app
