// Numerical stability: methods x maps x surfaces x addressings x ray families, for a given time; every broken promise
// with the command that shows it. The cases and their order hang on the seed alone; time only decides when to stop.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "measuring/measured_method.h"
#include "measuring/stress_checks.h"

namespace relief {

struct StressViolation {
    StressFault fault;
    std::string method;  // with its options
    std::string rays;    // the family
    std::string map;
    std::string command;  // `relief trace ...`, quoted for a shell
};

// Distance and cone maps of larger pictures would take all the time there is: methods that need them are not tried
// there.
inline constexpr std::size_t kStressBuildTexels = 1U << 13U;

struct StressOptions {
    double seconds = 20;  // not before the first kStressCasesAtLeast are done
    std::uint64_t seed = 1;
    std::vector<MeasuredMethod> methods;  // forms of one name take turns; empty: methodVariants()
    std::string folder = ".";             // for maps that only a file can hold, as the commands name it
    std::size_t listed = 50;              // violations kept with a command; the others are counted
    double hangSeconds = 60;              // one ray's
    // Called once, from another thread, for a ray that takes longer; the tracer cannot be stopped.
    std::function<void(const StressViolation&)> onHang;
};

// Of each name in the list.
struct StressMethodCoverage {
    std::map<std::string, std::uint64_t> rays;  // by ray family
    std::set<std::string> forms;                // options tried
    std::uint64_t logs = 0;                     // compared with the counts
    double worstBound = 0;                      // steps / Tracer::stepBound, the largest
    std::string worstWhere;                     // family, map

    std::uint64_t total() const;
};

struct StressReport {
    std::uint64_t cases = 0;
    double seconds = 0;
    bool interrupted = false;
    std::map<std::string, StressMethodCoverage> methods;
    std::map<std::string, std::uint64_t> maps;  // cases by map family
    std::set<std::string> sizes;
    std::vector<StressViolation> violations;  // in the order of cases
    std::uint64_t violationCount = 0;
};

// So many cover every ray family with every method.
inline constexpr std::uint64_t kStressCasesAtLeast = 6;

// Throws WorkError where a map cannot be written. Stopped: what was done until then, `interrupted`.
StressReport stress(const StressOptions& options, Work& work);

// For people: what was covered, violations one a line.
std::string stressText(const StressReport& report, std::uint64_t seed);

}  // namespace relief
