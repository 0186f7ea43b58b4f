// All panes, in the order of their keys: window, menus, layouts, export and help iterate over them.
#pragma once

#include "panes/pane.h"

namespace reliefui {

// In the window's language: after dressApplication().
std::vector<PaneKind> paneList();

// What is kept of them in scenarios, and the ranges of colours, which several show.
StateReaders stateReaders();

// Of all panes, sorted by name.
std::vector<FigureKind> figureList();
// Throws InputError for a name that is not in the list.
FigureKind figureKind(const std::string& name);

}  // namespace reliefui
