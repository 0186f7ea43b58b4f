// The colours of the window around the panes.
#pragma once

#include <QPalette>

#include "painting/style.h"

namespace reliefui {

QPalette themePalette(Theme theme);
// DejaVu Sans, 10 points at scale 1.
QFont windowFont(double scale);
// How much larger everything is on a projector whose picture is so many points high: what is read from the last row is
// a share of the picture's height.
double projectorScale(int height);

}  // namespace reliefui
