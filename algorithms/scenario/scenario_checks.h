// Checks the values of a scenario one by one, so that an error can be reported with its line in a file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace relief {

// Runs one check, which may throw InputError. place: the keys of the checked value in a scenario's file, such as
// {"relief", "depth"}.
using ScenarioCheck = std::function<void(const std::vector<std::string>& place, const std::function<void()>& check)>;

// Runs all checks of checkScenario(). subject: as there.
void checkScenarioParts(const Scenario& scenario, const std::string& subject, const ScenarioCheck& run);

}  // namespace relief
