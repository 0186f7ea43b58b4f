// What the frame did not need to compute: its table, and the figure.
#pragma once

#include "panes/table_figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// The frame's ledgers: a heading for each, followed by one row per kind of skipped work.
TableSource skippedTable(const Snapshot& snapshot, relief::Language language);
std::shared_ptr<const Figure> skippedFigure(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
