// The panes' part of a scenario file. What is as at first is left out.
#pragma once

#include "scenario/json_reader.h"
#include "scenario/pane_states.h"

namespace relief {

// Unknown keys and names, wrong types: InputError with the line.
void readPanes(JsonReader reader, PaneStates& panes);
Json panesJson(const PaneStates& panes);

}  // namespace relief
