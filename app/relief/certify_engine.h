// `relief certify` of a map as an engine reads it.
#pragma once

#include "engine_options.h"
#include "measuring/verify/certificate.h"
#include "options_common.h"

namespace relief::app {

// Certifies the map of --map. Returns the exit status.
int certifyEngineMap(const ScenarioOptions& scenarioOptions, const EngineOptions& engine,
                     const CertificateOptions& rays, Session& session);

}  // namespace relief::app
