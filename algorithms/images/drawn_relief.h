// A small relief whose heights somebody wrote down or dragged: few enough to look at one by one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "relief/image.h"

namespace relief {

inline constexpr int kLeastDrawnSide = 2;
inline constexpr int kMostDrawnSide = 32;

// width x height heights in [0, 1], rows top-down; or `width` of them, a profile that every row repeats. No heights:
// nothing is drawn.
struct DrawnRelief {
    int width = 0;
    int height = 0;
    std::vector<double> heights;

    bool empty() const { return heights.empty(); }
    bool profile() const { return heights.size() == static_cast<std::size_t>(width) && height > 1; }
    double at(int i, int j) const { return heights[static_cast<std::size_t>(profile() ? i : j * width + i)]; }
    bool operator==(const DrawnRelief&) const = default;
};

// Throws InputError naming `subject` for sides, counts and heights out of range.
void checkDrawn(const DrawnRelief& drawn, const std::string& subject);
// The heights as a picture; not of an empty one.
FloatImage drawnHeights(const DrawnRelief& drawn);

// Numbers as a person writes them, with commas between: one row, or all.
std::string drawnNumbers(const std::vector<double>& heights);
// Throws InputError naming `subject` for what is no number.
std::vector<double> parseDrawnNumbers(std::string_view text, const std::string& subject);

// "drawn:WxH:0.1,0.5,...", as --relief takes it.
inline constexpr std::string_view kDrawn = "drawn";
std::string drawnRecipe(const DrawnRelief& drawn);

}  // namespace relief
