// Ends the program as closing its window does when the system asks it to end: SIGTERM, SIGINT, SIGHUP.
#pragma once

#include <array>
#include <memory>

class QSocketNotifier;

namespace relief::app {

// For one object at a time, on the window's thread, while a QApplication exists.
class EndSignals {
  public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

  private:
    std::array<int, 2> pipe_{-1, -1};
    std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace relief::app
