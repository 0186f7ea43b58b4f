// Lines of equal value through a grid of samples, which lie in the middles of its cells.
#pragma once

#include <vector>

#include "painting/drawing.h"

namespace reliefui {

// Tints of a line (LevelTint::level), by the ground that it lies on: a map's colour, dark or light in every theme.
inline constexpr int kLightLine = 1, kDarkLine = 2;

struct IsoLine {
    double value = 0;
    std::vector<Point> points;  // in cells: sample (i, j) lies at (i + 1/2, j + 1/2)
    bool closed = false;
};

// At each of the values. No line where a sample around is NaN. Lines end at the outermost samples; of two ways through
// a saddle the one that the mean of the four decides.
std::vector<IsoLine> isoLines(const relief::FloatImage& samples, const std::vector<double>& values);

}  // namespace reliefui
