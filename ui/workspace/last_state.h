// Where the last window left off: its scenario, kept beside the settings, so that the next one goes on there.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "scenario/scenario.h"

namespace reliefui {

struct StateReaders;

QString settingsFolder();
QString lastStateFile();

// Nothing if none was kept, or if it cannot be read any more: a picture that is gone is no reason not to start.
// store: gets its pictures. readers: of the panes' states.
std::optional<relief::Scenario> lastState(relief::AssetStore& store, const StateReaders& readers);
// Returns in one line why it cannot be written; empty: it is.
std::string keepState(const relief::Scenario& scenario);

}  // namespace reliefui
