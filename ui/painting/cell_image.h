// A grid of values, or a part of one, as a picture of colours, for the painter; big ones are thinned out first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "painting/style.h"
#include "painting/view_map.h"

namespace reliefui {

// Rows top-down, three bytes a pixel. A pixel stands for `step` x `step` cells and shows the first of them; the first
// pixel for those from (i0, j0) on.
struct CellImage {
    int i0 = 0;
    int j0 = 0;
    int width = 0;
    int height = 0;
    int step = 1;
    std::vector<std::uint8_t> rgb;
};

// No side of the picture is longer than `longest` pixels.
CellImage cellImage(const Cells& cells, const Style& style, int longest = 2048);
// Of these cells only, thinned out `step` times.
CellImage cellImage(const Cells& cells, const Style& style, const CellRange& range, int step);

// Size (pixels) and decimals with which values are written into cells of this size; pixels = 0: no room.
struct CellText {
    double pixels = 0;
    int decimals = 2;
    int digits = 1;  // before the point
    bool sign = false;
    int characters() const { return digits + 1 + decimals + (sign ? 1 : 0); }
};
CellText cellText(double cellWidth, double cellHeight, const Style& style);
// One decimal is enough where all values of the range have no more.
CellText cellText(const Cells& cells, const CellRange& range, double scale, const Style& style);
// In what is seen of a cell.
bool textFits(const CellText& text, double width, double height);
// Empty where the value is a mark.
std::string cellValueText(const Cells& cells, float value, const CellText& text);

}  // namespace reliefui
