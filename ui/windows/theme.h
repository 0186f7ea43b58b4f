// The colours of the window around the panes.
#pragma once

#include <QPalette>

#include "painting/style.h"

namespace reliefui {

QPalette themePalette(Theme theme);
// DejaVu Sans, 10 points; 18 on a projector.
QFont windowFont(bool projector);
// Of the panes' tabs, which stand all in one row on a projector.
QFont tabFont(bool projector, int width = 0);

}  // namespace reliefui
