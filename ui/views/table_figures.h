// What the panes that are tables show, as data for figures: the steps of the chosen ray, and what was skipped.
#pragma once

#include "drawings/table_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Of long logs the steps around the chosen one.
inline constexpr std::size_t kMostTableRows = 48;
TableSource stepTable(const Snapshot& snapshot, relief::Language language);

// The ledgers of the frame: a heading each, then a row a kind.
TableSource skippedTable(const Snapshot& snapshot, relief::Language language);

}  // namespace reliefui
