// Tests of numerical stability: methods x maps x surfaces x addressings x ray families, any-hit queries over the same
// rays, and frames, homographies and rows with extreme cameras, for a given time or number of cases. Every violated
// guarantee is reported with the command that reproduces it. The cases and their order depend only on the seed; time
// only determines when to stop.
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

// The parts of a case, each over the case's map. Frames include filters and shadows.
enum class StressPart : std::uint8_t { Tracers, AnyHit, Frames, Homographies, Rows };
inline constexpr int kStressParts = 5;
// Returns "tracers", "any-hit", "frames", "homographies" or "rows".
std::string_view stressPartName(StressPart part);
// Throws InputError naming `option`, with the known names.
StressPart parseStressPart(std::string_view text, const std::string& option);

struct StressViolation {
    StressFault fault;
    std::string method;  // with its options; for frames also the filter; for rows the variant
    std::string rays;    // the family of rays or cameras
    std::string map;
    std::string
        command;  // `relief trace ...` or `relief render ...`, quoted for a shell; otherwise `relief stress --case ...`
    std::string kind{};  // part, method name and check: only the first few violations of a kind are listed
};

// What was tested of one method of the list.
struct StressMethodCoverage {
    std::map<std::string, std::uint64_t> rays;  // number of rays, by ray family
    std::set<std::string> forms;                // combinations of options
    std::uint64_t logs = 0;                     // number of logs compared with counts
    double worstBound = 0;                      // largest ratio steps / Tracer::stepBound
    std::string worstWhere;                     // family and map of that ratio

    std::uint64_t total() const;
};

// Number of frames, filters, homographies and rows tested, by camera family, filter or row variant, and number of those
// that were refused with a message, as degenerate cameras are.
struct StressPartCoverage {
    std::map<std::string, std::uint64_t> tried;
    std::uint64_t refused = 0;

    std::uint64_t total() const;
};

// The result of one case.
struct StressCase {
    std::uint64_t number = 0;
    std::string map;   // map family
    std::string size;  // "64x48"
    std::map<std::string, StressMethodCoverage> methods;
    std::map<std::string, StressPartCoverage> parts;
    std::uint64_t violationCount = 0;
    std::vector<StressViolation> violations;  // the first of each kind
};

// Building distance and cone maps of larger pictures would take most of the time, so methods that need them are skipped
// for larger pictures.
inline constexpr std::size_t kStressBuildTexels = 1U << 13U;

inline constexpr int kMoreRaysAtMost = 1000;  // about 20 MB for each thread

struct StressOptions {
    double seconds = 20;                 // at least kStressCasesAtLeast cases are done, whatever the time
    std::optional<std::uint64_t> cases;  // number of cases from case 0, whatever the time
    // Only the cases first, first + step, ... are run.
    std::uint64_t first = 0, step = 1;
    std::uint64_t seed = 1;
    std::vector<MeasuredMethod> methods;  // variants of one method take turns; empty: methodVariants()
    std::string folder = ".";             // for maps that only a file can hold, as the commands name it
    std::set<StressPart> parts;           // empty: all
    bool oracle = false;                  // also decides the rays in rational arithmetic
    // Each method also traces this many times the rays of a family, in blocks, as pictures are traced, without logs; at
    // most kMoreRaysAtMost. Families of few rays, which take long, are left out; --oracle and any-hit queries do not
    // use these rays.
    int moreRays = 0;
    std::optional<std::uint64_t> only;  // number of the only case to run, from 0
    std::size_t listed = 50;            // number of violations kept with a command; the others are only counted
    double hangSeconds = 60;            // limit for one ray, one block of rays, or one frame with its repetitions
    // The functions to test besides the tracers (stress_subjects.h); null: the program's own.
    std::shared_ptr<const StressSubjects> subjects;
    // Called once, from another thread, for a ray that exceeds the limit; the tracer cannot be stopped.
    std::function<void(const StressViolation&)> onHang;
    // Called for every case in the order of their numbers, one call at a time, from any of the work's threads. Its
    // violations are not limited by `listed`, so that reports of parts of a run can be added up to the report of the
    // whole run.
    std::function<void(const StressCase&)> onCase;
};

struct StressReport {
    std::uint64_t cases = 0;
    double seconds = 0;  // 0: unknown, for a report joined from parts
    bool interrupted = false;
    std::map<std::string, StressMethodCoverage> methods;  // tracers and any-hit queries
    std::map<std::string, StressPartCoverage> parts;      // "frames", "filters", "homographies", "rows"
    std::map<std::string, std::uint64_t> maps;            // number of cases by map family
    std::set<std::string> sizes;
    std::vector<StressViolation> violations;  // in the order of cases
    std::uint64_t violationCount = 0;
};

// This many cases cover every ray family with every method, and every filter and camera family with a frame.
inline constexpr std::uint64_t kStressCasesAtLeast = 6;

// Runs the cases. If stopped, returns the results so far, with `interrupted` set. Throws WorkError if a map cannot be
// written.
StressReport stress(const StressOptions& options, Work& work);

// Returns a report as text: what was covered, and the violations, one per line.
std::string stressText(const StressReport& report, std::uint64_t seed);

}  // namespace relief
