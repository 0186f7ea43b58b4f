// Converts a grid of values, or part of one, to an RGB image for the painter. Large grids are subsampled first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "painting/style.h"
#include "painting/view_map.h"

namespace reliefui {

// Rows are stored top-down, three bytes per pixel. Each pixel covers `step` x `step` cells and shows the first of them;
// the first pixel starts at cell (i0, j0).
struct CellImage {
    int i0 = 0;
    int j0 = 0;
    int width = 0;
    int height = 0;
    int step = 1;
    std::vector<std::uint8_t> rgb;
};

// Converts the whole grid; the step is chosen so that no side of the image exceeds `longest` pixels.
CellImage cellImage(const Cells& cells, const Style& style, int longest = 2048);
// Converts the cells of `range` only, subsampled by `step`.
CellImage cellImage(const Cells& cells, const Style& style, const CellRange& range, int step);

// Font size (pixels) and number format for printing values into cells of this size. pixels = 0: the cells are too
// small.
struct CellText {
    double pixels = 0;
    int decimals = 2;
    int digits = 1;  // before the decimal point
    bool sign = false;
    int characters() const { return digits + 1 + decimals + (sign ? 1 : 0); }
};
CellText cellText(double cellWidth, double cellHeight, const Style& style);
// As above, but one decimal is used where no value of the range has more.
CellText cellText(const Cells& cells, const CellRange& range, double scale, const Style& style);
// Returns true if the text fits into the visible part of a cell (width x height, pixels).
bool textFits(const CellText& text, double width, double height);
// Text of a value; empty if the value is a mark.
std::string cellValueText(const Cells& cells, float value, const CellText& text);

}  // namespace reliefui
