// The table of steps as a figure.
#pragma once

#include "panes/table_figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Long logs are limited to the steps around the chosen one.
inline constexpr std::size_t kMostTableRows = 48;
TableSource stepTable(const std::shared_ptr<const Snapshot>& shown, int step, relief::Language language);
std::shared_ptr<const Figure> stepsFigure(std::shared_ptr<const Snapshot> snapshot, int step);

}  // namespace reliefui
