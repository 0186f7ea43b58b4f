// The row of the chosen pixel, computed by several variants: its place, and the figure.
#pragma once

#include <optional>

#include "panes/figure.h"
#include "panes/rows/rows_drawing.h"
#include "panes/rows/rows_state.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Returns std::nullopt if no pixel is chosen, or it shows the sky. Not for coarse snapshots.
std::optional<RowsPlace> rowsPlace(const Snapshot& snapshot);
RowsOptions rowsOptions(const RowsPane& pane);
RowsPane paneOf(const RowsOptions& options);

// Computes the row for a figure of this name. Throws InputError if no pixel of the relief is chosen, or no variant.
RowsData rowsOf(const Snapshot& snapshot, const RowsOptions& options, const char* figure);

std::shared_ptr<const Figure> rowsFigure(std::shared_ptr<const Snapshot> snapshot, const RowsOptions& options,
                                         const RowsRange& range);

}  // namespace reliefui
