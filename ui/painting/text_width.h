// How wide words are, as the painter sets them.
#pragma once

#include <string>

namespace reliefui {

inline constexpr double kChartText = 0.85;  // times the style's size

// Points, of text of `size` times the style's size. Any thread.
double textWidth(const std::string& text, double size = kChartText, bool bold = false);

}  // namespace reliefui
