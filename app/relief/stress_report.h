// What relief stress and relief merge say of a finished report.
#pragma once

#include "measuring/verify/stress.h"
#include "session.h"

namespace relief::app {

// Writes the report to standard output, and the number of violations, if there are any, to standard error. Returns the
// exit status: 1 where there are violations.
int tellStress(const StressReport& report, std::uint64_t seed, Session& session);

}  // namespace relief::app
