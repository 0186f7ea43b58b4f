// Tests whether a window can be opened, and whether it can show 3-D views. Call displayProblem() before Qt is
// initialised, which terminates the process if it cannot.
#pragma once

#include <string>

namespace reliefui {

// Returns an empty string if a display is available, otherwise a one-line explanation.
std::string displayProblem();
// Returns an empty string if the display has OpenGL, otherwise what is missing and what that means. Call it only if
// there is no displayProblem().
std::string glProblem();

// Returns true for a screen of at least 3200 x 2000 pixels whose desktop sets no scale (Xft.dpi is missing or 96):
// unscaled, 10-point letters would be about 2 mm high. Returns false if the user has set Qt's scale explicitly.
bool needsDoubleScale();

}  // namespace reliefui
