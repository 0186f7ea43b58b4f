#include "images/drawn_relief.h"

#include <charconv>

#include "relief/errors.h"

namespace relief {

void checkDrawn(const DrawnRelief& drawn, const std::string& subject) {
    for (const int side : {drawn.width, drawn.height}) {
        if (side >= kLeastDrawnSide && side <= kMostDrawnSide) continue;
        throw InputError(subject,
                         Message(MessageId::OutOfRange, {{"what", MessageId::WordDrawnSide},
                                                         {"value", side},
                                                         {"range", rangeOf(kLeastDrawnSide, kMostDrawnSide)}}));
    }
    const auto all = static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(drawn.height);
    if (drawn.heights.size() != all && drawn.heights.size() != static_cast<std::size_t>(drawn.width)) {
        throw InputError(subject, Message(MessageId::DrawnCount,
                                          {{"count", drawn.heights.size()}, {"all", all}, {"row", drawn.width}}));
    }
    for (const double height : drawn.heights) {
        if (height >= 0 && height <= 1) continue;
        throw InputError(subject,
                         Message(MessageId::OutOfRange,
                                 {{"what", MessageId::WordDrawnHeight}, {"value", height}, {"range", rangeOf(0, 1)}}));
    }
}

FloatImage drawnHeights(const DrawnRelief& drawn) {
    FloatImage image(drawn.width, drawn.height);
    for (int j = 0; j < drawn.height; ++j) {
        for (int i = 0; i < drawn.width; ++i) image(i, j) = static_cast<float>(drawn.at(i, j));
    }
    return image;
}

std::string drawnNumbers(const std::vector<double>& heights) {
    std::string text;
    for (const double height : heights) text += (text.empty() ? "" : ",") + numberText(height);
    return text;
}

std::vector<double> parseDrawnNumbers(std::string_view text, const std::string& subject) {
    std::vector<double> heights;
    while (true) {
        const std::size_t comma = text.find(',');
        std::string_view part = text.substr(0, comma);
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
        double height = 0;
        const auto result = std::from_chars(part.data(), part.data() + part.size(), height);
        if (result.ec != std::errc() || result.ptr != part.data() + part.size()) {
            throw InputError(subject, Message(MessageId::NotANumber, {{"text", std::string(part)}}));
        }
        heights.push_back(height);
        if (comma == std::string_view::npos) return heights;
        text.remove_prefix(comma + 1);
    }
}

std::string drawnRecipe(const DrawnRelief& drawn) {
    return std::string(kDrawn) + ":" + std::to_string(drawn.width) + "x" + std::to_string(drawn.height) + ":" +
           drawnNumbers(drawn.heights);
}

}  // namespace relief
