// Measures text as the painter sets it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace reliefui {

inline constexpr double kChartText = 0.85;  // text size of charts, relative to the style's text size

// Width in points; `size` is relative to the style's text size. May be called from any thread.
double textWidth(const std::string& text, double size = kChartText, bool bold = false);

// Breaks a text between words into lines at most `room` wide; a word that is longer gets a line of its own. width(line)
// returns a line's width, in the unit of `room`.
template <class Width>
std::vector<std::string> wrappedText(const std::string& text, double room, const Width& width) {
    std::vector<std::string> lines{{}};
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t space = std::min(text.find(' ', from), text.size());
        const std::string word = text.substr(from, space - from);
        std::string& line = lines.back();
        if (!line.empty() && width(line + " " + word) > room) {
            lines.push_back(word);
        } else {
            line += (line.empty() ? "" : " ") + word;
        }
        from = space + 1;
    }
    return lines;
}

}  // namespace reliefui
