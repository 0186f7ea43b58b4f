// Requirements on a window of any size: nothing is truncated, nothing overlaps, and everything is inside the window.
#pragma once

#include <string>
#include <vector>

class QMainWindow;
class QSize;

namespace reliefui {

// Returns a line for each violation. size: the size that the window is to have.
std::vector<std::string> layoutFaults(QMainWindow& window, const QSize& size);

}  // namespace reliefui
