// Whether a window can be opened here. To be asked before Qt and VTK, which end the process where it cannot.
#pragma once

#include <string>

namespace reliefui {

// Empty: yes. Otherwise what is missing, in one line.
std::string displayProblem();

}  // namespace reliefui
