// Words that are too long for one line.
#pragma once

#include "painting/drawing.h"

namespace reliefui {

// Adds them in lines of at most `room` points, broken between words; the middle of all of them lies at `middle`. size:
// of the style's text.
void addParagraph(Drawing& drawing, Point middle, const relief::Message& words, double room, relief::Language language,
                  double size = 1);

}  // namespace reliefui
