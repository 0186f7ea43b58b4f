// How wide words are, as the painter sets them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace reliefui {

inline constexpr double kChartText = 0.85;  // times the style's size

// Points, of text of `size` times the style's size. Any thread.
double textWidth(const std::string& text, double size = kChartText, bool bold = false);

// Lines of at most `room` points, broken between words; a longer word has a line of its own. width: of a line.
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
