// The report that relief stress and relief merge print.
#pragma once

#include "measuring/verify/stress.h"
#include "session.h"

namespace relief::app {

// Writes the report to standard output, and the number of violations, if any, to standard error. Returns the exit
// status: 1 if there are violations.
int reportStress(const StressReport& report, std::uint64_t seed, Session& session);

}  // namespace relief::app
