// One case of relief stress: a map with surface, addressing and depth; over it every ray family with every method, and
// the other parts (stress_parts.h).
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "measuring/verify/stress.h"
#include "measuring/verify/stress_cases.h"
#include "scenario/scenario.h"

namespace relief::stress_detail {

// The forms of one method that take turns.
struct MethodGroup {
    std::string name;
    std::vector<MeasuredMethod> forms;
};

struct Case {
    std::uint64_t number = 0;
    std::string map;  // the family
    StressMap made;
    HeightField field;
};

// What one ray's trace, or one frame, is about; read by the watch over hanging ones.
struct Running {
    const Case* of = nullptr;
    StressPart part = StressPart::Tracers;
    const MethodChoice* method = nullptr;
    std::string_view rays;
    ViewRay ray;
    const Scenario* frame = nullptr;  // of frames: without its pictures
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
    // Calls look(running) if a ray is being traced; it stays so meanwhile.
    template <class Look>
    void look(const Look& look) {
        const std::lock_guard lock(mutex_);
        if (running_) look(*running_);
    }

  private:
    std::mutex mutex_;
    std::optional<Running> running_;
};

// A violation before it has a command.
struct Found {
    StressFault fault;
    StressPart part = StressPart::Tracers;
    MethodChoice method;
    std::string_view rays;
    ViewRay ray;
    std::shared_ptr<const Scenario> frame;  // of frames: without its pictures
};

// violations are empty until the found ones have commands.
struct CaseResult : StressCase {
    std::vector<Found> found;  // the first of each method and check

    // Counts it, and keeps the first of each method and check.
    void report(Found violation);
};

// The n-th case of a seed.
Case makeCase(std::uint64_t seed, std::uint64_t number);
// Throws Cancelled.
CaseResult runCase(const Case& tried, const StressOptions& options, const std::vector<MethodGroup>& groups,
                   Watched& watched, Work& work);

}  // namespace relief::stress_detail
