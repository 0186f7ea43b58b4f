// A small graph of one value over the steps of a ray.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

// The part of the x axis that belongs to a step, in drawing units; x1 >= x0.
struct GraphPart {
    double x0 = 0;
    double x1 = 0;
};

// The range of the finite values; low > high if there is none.
struct GraphRange {
    double low = 1;
    double high = 0;
    bool empty() const { return low > high; }
};
GraphRange graphRange(std::span<const double> values);

// Adds the graph of values[k] over parts[k] to the box: a horizontal line for each step, joined with its neighbours;
// values that are not finite leave a gap. Where steps are closer than can be seen, their least and largest values are
// drawn. The current step, if there is one, has a line across the box and a mark. unit: drawing units per point.
void addValueGraph(Drawing& drawing, const Box& box, std::span<const GraphPart> parts, std::span<const double> values,
                   std::size_t current, double unit);

}  // namespace reliefui
