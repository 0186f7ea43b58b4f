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

namespace relief {

// LevelBelow: a step on a level finer than `level`. Texel: a step that examines texel (i, j) of `level`. RayBelow: the
// tracer has descended below `height`, in [0, 1]. Overshoot: it has passed the exact hit. Disagreement: the first step
// that the exact answer contradicts (duel.h).
enum class StopKind : std::uint8_t { LevelBelow, Texel, RayBelow, Overshoot, Disagreement };
inline constexpr std::array<std::string_view, 5> kStopNames{"level-below", "texel", "ray-below", "overshoot",
                                                            "disagreement"};
constexpr std::string_view stopName(StopKind kind) {
    return kStopNames[static_cast<std::size_t>(kind)];
}
// Throws InputError that lists the known names.
StopKind parseStop(std::string_view text);

inline constexpr int kMostLevels = 32;
inline constexpr std::size_t kMostBreakpoints = 100;

struct Breakpoint {
    StopKind kind = StopKind::LevelBelow;
    int level = 2;
    std::int64_t i = 0;
    std::int64_t j = 0;
    double height = 0.5;
    bool on = true;
    bool operator==(const Breakpoint&) const = default;
};

// The ray that breakpoints are tested on: its log, its answer, and the exact answer.
struct StoppedRay {
    const std::vector<Step>* steps = nullptr;
    std::optional<std::size_t> overshoot;  // the step at which it happens, see duel.h
    std::optional<std::size_t> disagreement;
};

// Returns true if stepping stops at this step: where the condition becomes true, but not at further steps where it
// remains true.
bool stopsAt(const Breakpoint& breakpoint, const StoppedRay& ray, std::size_t step);
// Returns the next (or previous) step after (before) `from` at which an enabled breakpoint stops; std::nullopt if there
// is none.
std::optional<std::size_t> nextStop(const std::vector<Breakpoint>& breakpoints, const StoppedRay& ray, std::size_t from,
                                    bool forward);

// Steps over finer levels: returns the next (or previous) step whose level is at least that of `from`, or the last
// (first) step if there is none. In a log without levels it moves by single steps.
std::size_t stepOver(const std::vector<Step>& steps, std::size_t from, bool forward);

// Returns a short title such as "level < 2".
Message breakpointTitle(const Breakpoint& breakpoint);
// Throws InputError(subject, ...) for a value out of range.
void checkBreakpoint(const Breakpoint& breakpoint, const std::string& subject);

}  // namespace relief
