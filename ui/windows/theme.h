// Font and colours of the window around the panes.
#pragma once

#include <QPalette>

#include "painting/style.h"

namespace reliefui {

QPalette themePalette(Theme theme);
// DejaVu Sans; 10 points at scale 1.
QFont windowFont(double scale);
// Scale of text and lines on a projector whose picture is `height` points high. Legibility from the last row depends on
// the size relative to the picture, so the scale grows with the height.
double projectorScale(int height);

}  // namespace reliefui
