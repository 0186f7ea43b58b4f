// Watched values: for each one its name, its value at the current step, and a small graph over all steps of the ray.
// The x axis is the number of the step, the same for all.
#pragma once

#include <optional>

#include "painting/drawing.h"
#include "panes/value_graph.h"
#include "panes/watch/watch_state.h"
#include "workspace/pixel_trace.h"

namespace reliefui {

struct WatchRow {
    std::string name;
    relief::WatchedValues values;
    std::vector<double> heights;           // of the graph
    std::optional<relief::Message> fault;  // why there are no values

    // Returns the value at a step as text; empty if there is none.
    std::string text(std::size_t step) const;
};
std::vector<WatchRow> watchRows(const PixelTrace& trace, const WatchPane& pane);

// Layout in points: the rows fill the height, down to the axis.
struct WatchFrame {
    Box whole;
    Box graphs;  // of all rows, one above the other
    std::size_t rows = 0;
    std::size_t steps = 0;

    double rowHeight() const { return rows > 0 ? graphs.height() / static_cast<double>(rows) : 0; }
    Box graph(std::size_t row) const;
    GraphPart part(std::size_t step) const;
    // The row and the step at a point; std::nullopt outside.
    std::optional<std::size_t> rowAt(Point at) const;
    std::optional<std::size_t> stepAt(Point at) const;
};
WatchFrame watchFrame(const std::vector<WatchRow>& rows, std::size_t steps, double width, double height);
// step: the current one. chosen: index of the row that is marked; at least the number of rows: none.
Drawing watchDrawing(const std::vector<WatchRow>& rows, const WatchFrame& frame, std::size_t step, std::size_t chosen,
                     relief::Language language);

}  // namespace reliefui
