// What holds for a window of any size: nothing is cut, nothing lies over another, all of it is inside the window.
#pragma once

#include <string>
#include <vector>

class QMainWindow;

namespace reliefui {

// A line for each place where it does not hold.
std::vector<std::string> layoutFaults(QMainWindow& window);

}  // namespace reliefui
