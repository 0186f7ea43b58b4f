// Where the last window left off: its scenario, kept beside the settings, so that the next one goes on there.
#pragma once

#include <optional>

#include "scenario/scenario.h"

namespace reliefui {

// Nothing if none was kept, or if it cannot be read any more: a picture that is gone is no reason not to start.
// store: gets its pictures.
std::optional<relief::Scenario> lastState(relief::AssetStore& store);
// Where it cannot be written, nothing is kept.
void keepState(const relief::Scenario& scenario);

}  // namespace reliefui
