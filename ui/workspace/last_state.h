// The state in which the last window was closed: its scenario, stored next to the settings, with which the next window
// starts.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "scenario/scenario.h"

namespace reliefui {

struct StateReaders;

QString settingsFolder();
QString lastStateFile();

// Returns std::nullopt if no state was stored or it cannot be read: a missing picture must not prevent a start. store:
// receives the state's pictures. readers: check the panes' states.
std::optional<relief::Scenario> lastState(relief::AssetStore& store, const StateReaders& readers);
// Stores the state. Returns an empty string on success, otherwise a one-line explanation.
std::string keepState(const relief::Scenario& scenario);

}  // namespace reliefui
