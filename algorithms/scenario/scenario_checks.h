// What is checked of a scenario, piece by piece, so that a fault can be told by its line in a file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace relief {

// Runs one check, which may throw InputError. place: the keys that lead to what is checked in a scenario's file, such
// as
// {"relief", "depth"}.
using ScenarioCheck = std::function<void(const std::vector<std::string>& place, const std::function<void()>& check)>;

// All checks of checkScenario(). subject: as there.
void checkScenarioParts(const Scenario& scenario, const std::string& subject, const ScenarioCheck& run);

}  // namespace relief
