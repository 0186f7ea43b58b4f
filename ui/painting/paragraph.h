// Text that needs several lines.
#pragma once

#include "painting/drawing.h"

namespace reliefui {

// Adds the text in lines at most `room` points wide, broken between words. The block of lines is centred at `middle`.
// size: relative to the style's text size.
void addParagraph(Drawing& drawing, Point middle, const relief::Message& words, double room, relief::Language language,
                  double size = 1);

}  // namespace reliefui
