// Whether a window can be opened here. To be asked before Qt and VTK, which end the process where it cannot.
#pragma once

#include <string>

namespace reliefui {

// Empty: yes. Otherwise what is missing, in one line.
std::string displayProblem();

// A screen of 3200 x 2000 pixels or more whose desktop says nothing of it (Xft.dpi is missing or 96): drawn pixel by
// pixel, letters of 10 points would be some 2 mm high. Not where the user has said how large Qt is to draw.
bool wantsTwiceTheSize();

}  // namespace reliefui
