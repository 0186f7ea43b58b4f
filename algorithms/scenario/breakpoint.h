// Conditions on which stepping along a ray stops automatically.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "relief/messages.h"
#include "relief/ray.h"
#include "relief/step_log.h"
#include "scenario/step_columns.h"

namespace relief {

// LevelBelow: a step on a level finer than `level`. Texel: a step that examines texel (i, j) of `level`. RayBelow: the
// tracer has descended below `height`, in [0, 1]. Overshoot: it has passed the exact hit. Disagreement: the first step
// that the exact answer contradicts (duel.h). Condition: every step at which an expression over the columns of the
// steps (step_columns.h) is true, such as "level == 3 && delta_lambda < 0.01" or "pixel == 480,300".
enum class StopKind : std::uint8_t { LevelBelow, Texel, RayBelow, Overshoot, Disagreement, Condition };
inline constexpr std::array<std::string_view, 6> kStopNames{"level-below", "texel",        "ray-below",
                                                            "overshoot",   "disagreement", "condition"};
constexpr std::string_view stopName(StopKind kind) {
    return kStopNames[static_cast<std::size_t>(kind)];
}
// Throws InputError that lists the known names.
StopKind parseStop(std::string_view text);

inline constexpr int kMostLevels = 32;
inline constexpr std::size_t kMostBreakpoints = 100;
inline constexpr int kMostIgnored = 1000000;
inline constexpr std::size_t kLongestCondition = 1000;  // bytes

struct Breakpoint {
    StopKind kind = StopKind::LevelBelow;
    int level = 2;
    std::int64_t i = 0;
    std::int64_t j = 0;
    double height = 0.5;
    bool on = true;
    int ignore = 0;           // how many times it is met on a ray before it stops
    std::string condition{};  // of StopKind::Condition
    bool operator==(const Breakpoint&) const = default;
};

// The ray that breakpoints are tested on: its log, its answer, and the exact answer.
struct StoppedRay {
    const std::vector<Step>* steps = nullptr;
    std::optional<std::size_t> overshoot;  // the step at which it happens, see duel.h
    std::optional<std::size_t> disagreement;
    std::optional<StepColumns> columns{};  // for conditions; none: those of the steps alone
};

// Where a ray meets a breakpoint, whether or not it is enabled: the steps in order. A condition is met at every step at
// which it is true; the other kinds where they become true, but not at further steps where they remain so. The first
// `ignored` of them do not stop. fault: why the condition has no value on this ray, for instance because no step file
// with its column is open.
struct BreakpointHits {
    std::vector<std::size_t> steps;
    std::size_t ignored = 0;
    std::optional<Message> fault;
};
BreakpointHits breakpointHits(const Breakpoint& breakpoint, const StoppedRay& ray);
// Returns true if stepping stops at this step.
bool stopsAt(const Breakpoint& breakpoint, const StoppedRay& ray, std::size_t step);
// Returns the next (or previous) step after (before) `from` at which an enabled breakpoint stops; std::nullopt if there
// is none.
std::optional<std::size_t> nextStop(const std::vector<Breakpoint>& breakpoints, const StoppedRay& ray, std::size_t from,
                                    bool forward);

// Steps over finer levels: returns the next (or previous) step whose level is at least that of `from`, or the last
// (first) step if there is none. In a log without levels it moves by single steps.
std::size_t stepOver(const std::vector<Step>& steps, std::size_t from, bool forward);

// Returns a short title such as "level < 2"; of a condition its text.
Message breakpointTitle(const Breakpoint& breakpoint);
// Throws InputError(subject, ...) for a value out of range, and a condition that is no expression.
void checkBreakpoint(const Breakpoint& breakpoint, const std::string& subject);

}  // namespace relief
