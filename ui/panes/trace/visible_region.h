// The visible parts of a surface as polygons, for vector files.
#pragma once

#include <functional>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

// The region of the unit square in which `value` is positive: closed polygons to be filled by the even-odd rule, found
// on a grid of columns x rows cells (marching squares).
std::vector<std::vector<Point>> positiveRegion(int columns, int rows,
                                               const std::function<double(double u, double v)>& value);

}  // namespace reliefui
