// `relief map` for engines: the map as a picture with its conventions.
#pragma once

#include <string>
#include <vector>

#include "engine_options.h"
#include "options_common.h"

namespace relief::app {

// Kinds that are written for engines only.
const std::vector<std::string>& engineOnlyKinds();

// Builds the map of this kind and writes it in an engine's layout. kind: checked; text: with its options, as given.
int writeMapForEngine(const std::string& kind, const std::string& text, const ScenarioOptions& scenarioOptions,
                      const EngineOptions& engine, const std::string& output, Session& session);

}  // namespace relief::app
