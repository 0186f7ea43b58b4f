// One case of relief stress: a map with surface, addressing and depth; every ray family over it with every method.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "measuring/stress.h"
#include "measuring/stress_cases.h"

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

// What one ray's trace is about; read by the watch over hanging ones.
struct Running {
    const Case* of = nullptr;
    const MeasuredMethod* method = nullptr;
    std::string_view rays;
    ViewRay ray;
    std::chrono::steady_clock::time_point since;
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
    MethodChoice method;
    std::string_view rays;
    ViewRay ray;
};

struct CaseResult {
    std::map<std::string, StressMethodCoverage> methods;
    std::string map;
    std::string size;
    std::vector<Found> found;  // the first of each method and check
    std::uint64_t violations = 0;
};

// The n-th case of a seed.
Case makeCase(std::uint64_t seed, std::uint64_t number);
// Throws Cancelled.
CaseResult runCase(const Case& tried, std::uint64_t seed, const std::vector<MethodGroup>& groups, Watched& watched,
                   Work& work);

}  // namespace relief::stress_detail
