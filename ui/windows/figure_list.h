// All figures, by name: what `reliefscope --export` knows, and the window where a pane has none of its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panes/figure.h"
#include "workspace/pane_states.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct FigureKind {
    std::string name;
    bool vectors = true;
    // As the panes' states say; may take seconds. Throws InputError. Empty: not of a snapshot ("pareto", of a table of
    // measurements).
    std::function<std::shared_ptr<const Figure>(std::shared_ptr<const Snapshot>, const PaneStates&)> make;
};

// By name.
const std::vector<FigureKind>& figureList();
// Throws InputError for a name that is not in the list.
const FigureKind& figureKind(const std::string& name);

}  // namespace reliefui
