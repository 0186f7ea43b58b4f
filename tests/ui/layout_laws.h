// What holds for a window of any size: nothing is cut, nothing lies over another, all of it is inside the window.
#pragma once

#include <string>
#include <vector>

class QMainWindow;
class QSize;

namespace reliefui {

// A line for each place where it does not hold. size: that the window is to have.
std::vector<std::string> layoutFaults(QMainWindow& window, const QSize& size);

}  // namespace reliefui
