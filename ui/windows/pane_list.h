// The list of all panes, in the order of their keys. Window, menus, layouts, export and help iterate over it.
#pragma once

#include "panes/pane.h"

namespace reliefui {

// Titles are in the window's language; call this after setUpApplication().
std::vector<PaneKind> paneList();

// Readers of the panes' states in scenarios, and of the colour ranges, which several panes share.
StateReaders stateReaders();

// The figures of all panes, sorted by name.
std::vector<FigureKind> figureList();
// Throws InputError if no figure has this name.
FigureKind figureKind(const std::string& name);

}  // namespace reliefui
