// Numerical stability: methods x maps x surfaces x addressings x ray families, any-hit queries over the same rays, and
// frames, homographies and rows by cameras at their ends, for a given time or number of cases; every broken promise
// with the command that shows it. The cases and their order depend on the seed alone; time only decides when to stop.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "measuring/bench/measured_method.h"
#include "measuring/verify/stress_checks.h"

namespace relief {

struct StressSubjects;

// What a case is made of, each part over the case's map. Frames cover filters and shadows, too.
enum class StressPart : std::uint8_t { Tracers, AnyHit, Frames, Homographies, Rows };
inline constexpr int kStressParts = 5;
// "tracers", "any-hit", "frames", "homographies", "rows".
std::string_view stressPartName(StressPart part);
// Throws InputError naming `option`, with the known names.
StressPart parseStressPart(std::string_view text, const std::string& option);

struct StressViolation {
    StressFault fault;
    std::string method;  // with its options; of a frame also the filter; of rows the variant
    std::string rays;    // the family of rays, or of cameras
    std::string map;
    std::string
        command;  // `relief trace ...` or `relief render ...`, quoted for a shell; else `relief stress --case ...`
    std::string kind{};  // the part, the method's name and the check: only the first few of a kind are listed
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

// Of frames, filters, homographies and rows: how many were tried, by camera family, filter or row variant, and how many
// were refused with a message, as degenerate cameras are.
struct StressPartCoverage {
    std::map<std::string, std::uint64_t> tried;
    std::uint64_t refused = 0;

    std::uint64_t total() const;
};

// What one case found.
struct StressCase {
    std::uint64_t number = 0;
    std::string map;   // its family
    std::string size;  // "64x48"
    std::map<std::string, StressMethodCoverage> methods;
    std::map<std::string, StressPartCoverage> parts;
    std::uint64_t violationCount = 0;
    std::vector<StressViolation> violations;  // the first of each kind
};

// Distance and cone maps of larger pictures would take all the time there is: methods that need them are not tried
// there.
inline constexpr std::size_t kStressBuildTexels = 1U << 13U;

struct StressOptions {
    double seconds = 20;                 // not before the first kStressCasesAtLeast are done
    std::optional<std::uint64_t> cases;  // so many, from case 0, whatever time they take
    // Only each of these cases: first, first + step, ...
    std::uint64_t first = 0, step = 1;
    std::uint64_t seed = 1;
    std::vector<MeasuredMethod> methods;  // forms of one name take turns; empty: methodVariants()
    std::string folder = ".";             // for maps that only a file can hold, as the commands name it
    std::set<StressPart> parts;           // empty: all
    std::optional<std::uint64_t> only;    // this case alone, by its number from 0
    std::size_t listed = 50;              // violations kept with a command; the others are counted
    double hangSeconds = 60;              // of one ray, or of one frame with its repetitions
    // What is tried beside the methods (stress_subjects.h); null: the program's own.
    std::shared_ptr<const StressSubjects> subjects;
    // Called once, from another thread, for a ray that takes longer; the tracer cannot be stopped.
    std::function<void(const StressViolation&)> onHang;
    // Called for every case in the order of their numbers, one call at a time, from any thread of the work. Its
    // violations are not limited by `listed`, so that parts of a run add up to the report of the whole.
    std::function<void(const StressCase&)> onCase;
};

struct StressReport {
    std::uint64_t cases = 0;
    double seconds = 0;  // 0: not known, of a report put together from parts
    bool interrupted = false;
    std::map<std::string, StressMethodCoverage> methods;  // tracers and any-hit queries
    std::map<std::string, StressPartCoverage> parts;      // "frames", "filters", "homographies", "rows"
    std::map<std::string, std::uint64_t> maps;            // cases by map family
    std::set<std::string> sizes;
    std::vector<StressViolation> violations;  // in the order of cases
    std::uint64_t violationCount = 0;
};

// So many cover every ray family with every method, and every filter and camera family with a frame.
inline constexpr std::uint64_t kStressCasesAtLeast = 6;

// Throws WorkError where a map cannot be written. Stopped: what was done until then, `interrupted`.
StressReport stress(const StressOptions& options, Work& work);

// For people: what was covered, violations one a line.
std::string stressText(const StressReport& report, std::uint64_t seed);

}  // namespace relief
