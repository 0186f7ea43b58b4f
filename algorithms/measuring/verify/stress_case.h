// One case of relief stress: a map with surface, addressing and depth; over it every ray family is traced with every
// method, and the other parts are run (stress_parts.h).
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "measuring/verify/stress.h"
#include "measuring/verify/stress_cases.h"
#include "scenario/scenario.h"

namespace relief::stress_detail {

// The option variants of one method, which take turns.
struct MethodGroup {
    std::string name;
    std::vector<MeasuredMethod> forms;
};

struct Case {
    std::uint64_t number = 0;
    std::string map;  // map family
    StressMap made;
    HeightField field;
};

// What a thread is tracing or rendering; read by the thread that watches for hanging calls.
struct Running {
    const Case* of = nullptr;
    StressPart part = StressPart::Tracers;
    const MethodChoice* method = nullptr;
    std::string_view rays;
    ViewRay ray;                      // of a block: the first
    const Scenario* frame = nullptr;  // frames only: the scenario without its pictures
    bool block = false;               // one of the blocks of StressOptions::moreRays
    std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
};

class Watched {
  public:
    void begin(const Running& running) {
        const std::lock_guard lock(mutex_);
        running_ = running;
    }
    void end() {
        const std::lock_guard lock(mutex_);
        running_.reset();
    }
    // Calls examine(running) if a ray is being traced; it cannot end during the call.
    template <class Examine>
    void examine(const Examine& examine) {
        const std::lock_guard lock(mutex_);
        if (running_) examine(*running_);
    }

  private:
    std::mutex mutex_;
    std::optional<Running> running_;
};

// A violation that has no command yet.
struct Found {
    StressFault fault;
    StressPart part = StressPart::Tracers;
    MethodChoice method;
    std::string_view rays;
    ViewRay ray;
    std::shared_ptr<const Scenario> frame;  // frames only: the scenario without its pictures
    bool block = false;                     // among other rays, without which it may not be found
};

// `violations` is empty until commands for `found` are made.
struct CaseResult : StressCase {
    std::vector<Found> found;  // the first of each method and check

    // Counts the violation, and keeps it if it is the first of its method and check.
    void report(Found violation);
};

// Returns the case of this number.
Case makeCase(std::uint64_t seed, std::uint64_t number);
// Runs a case. Throws Cancelled.
CaseResult runCase(const Case& tried, const StressOptions& options, const std::vector<MethodGroup>& groups,
                   Watched& watched, Work& work);

}  // namespace relief::stress_detail
