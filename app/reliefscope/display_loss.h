// Ends the program in order when the X server goes away: the state of the window is saved, one line says so.
#pragma once

#include <functional>

namespace relief::app {

// For one object at a time, on the window's thread, created before the display is used.
class DisplayLoss {
  public:
    // The status with which the program then ends.
    static constexpr int kStatus = 1;
    // The status where no window can be opened, also of `reliefscope --check-display`.
    static constexpr int kNoDisplay = 2;

    DisplayLoss();
    ~DisplayLoss();
    DisplayLoss(const DisplayLoss&) = delete;
    DisplayLoss& operator=(const DisplayLoss&) = delete;

    // From now on the process ends with kNoDisplay, without a line, when the display goes: for `reliefscope
    // --check-display`. Needs no object.
    static void endQuietly();

    // Call it after the QApplication was created, which sets handlers of its own. save: saves the state of the window
    // on its thread, without the display; returns true if the next start finds it.
    void saveBy(std::function<bool()> save);
};

}  // namespace relief::app
