// What the frame did not compute: its rows, and the figure.
#pragma once

#include "panes/table_figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// The ledgers of the frame: a heading each, then a row a kind.
TableSource skippedTable(const Snapshot& snapshot, relief::Language language);
std::shared_ptr<const Figure> skippedFigure(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
