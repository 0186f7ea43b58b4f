// How variants compute a row, as a diagram: for its first pixels, or its ends, the numerator w and the denominator q,
// where they come from, and u = w / q. [PERSP] figs. 1 to 4.
#pragma once

#include "panes/figure.h"
#include "panes/rows/rows_drawing.h"
#include "panes/rows/rows_state.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Where a pixel's numbers come from.
struct RowFlowPixel {
    std::int64_t pixel = 0;
    bool divides = true;  // w and q are computed and divided; otherwise u comes from the pixel `from`
    // Pixel to whose numbers multiples of A and G (or of the change of u) are added; std::nullopt: computed from the
    // row's coefficients.
    std::optional<std::int64_t> from;
};
// The pixels that the diagram shows of a curve: all of a short row; of a longer one the first, or both ends where
// pixels are computed from both. Empty if the curve has no valid pixel.
std::vector<RowFlowPixel> rowFlow(const relief::RowCurve& curve);

// Draws the diagrams of all curves below each other, `width` points wide.
Drawing rowFlowDrawing(const RowsData& data, double width);

// Throws InputError if no pixel of the relief is chosen.
std::shared_ptr<const Figure> rowFlowFigure(std::shared_ptr<const Snapshot> snapshot, const RowsPane& pane);

}  // namespace reliefui
