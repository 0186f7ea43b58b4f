// A small relief whose heights the user typed or dragged.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "relief/image.h"

namespace relief {

inline constexpr int kLeastDrawnSide = 2;
inline constexpr int kMostDrawnSide = 32;

// width x height heights in [0, 1], rows top-down; or `width` heights, a profile that every row repeats. Empty if there
// are no heights.
struct DrawnRelief {
    int width = 0;
    int height = 0;
    std::vector<double> heights;

    bool empty() const { return heights.empty(); }
    bool profile() const { return heights.size() == static_cast<std::size_t>(width) && height > 1; }
    double at(int i, int j) const { return heights[static_cast<std::size_t>(profile() ? i : j * width + i)]; }
    bool operator==(const DrawnRelief&) const = default;
};

// Throws InputError naming `subject` if a side, the number of heights or a height is out of range.
void checkDrawn(const DrawnRelief& drawn, const std::string& subject);
// Returns the heights as a picture. Precondition: `drawn` is not empty.
FloatImage drawnHeights(const DrawnRelief& drawn);

// Formats heights for people to read and edit, separated by commas.
std::string drawnNumbers(const std::vector<double>& heights);
// Parses numbers separated by commas. Throws InputError naming `subject` if an item is not a number.
std::vector<double> parseDrawnNumbers(std::string_view text, const std::string& subject);

// Prefix of a drawn relief as a value of --relief, "drawn:WxH:0.1,0.5,...", which drawnRecipe() returns.
inline constexpr std::string_view kDrawn = "drawn";
std::string drawnRecipe(const DrawnRelief& drawn);

}  // namespace relief
