// Where stepping along a ray stops by itself.
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

// LevelBelow: a step on a level finer than `level`. Texel: a step about texel (i, j) of `level`. RayBelow: the tracer
// has come below `height`, in [0, 1]. Overshoot: it has come past the exact hit. Disagreement: the first step that the
// exact answer contradicts (duel.h).
enum class StopKind : std::uint8_t { LevelBelow, Texel, RayBelow, Overshoot, Disagreement };
inline constexpr std::array<std::string_view, 5> kStopNames{"level-below", "texel", "ray-below", "overshoot",
                                                            "disagreement"};
constexpr std::string_view stopName(StopKind kind) {
    return kStopNames[static_cast<std::size_t>(kind)];
}
// Throws InputError naming the known ones.
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

// What breakpoints are held against: a ray's log, its answer, and the exact one.
struct StoppedRay {
    const std::vector<Step>* steps = nullptr;
    std::optional<std::size_t> overshoot;  // the step at which it happens, see duel.h
    std::optional<std::size_t> disagreement;
};

// Whether stepping stops at this step: where the condition begins to hold, not as long as it does.
bool stopsAt(const Breakpoint& breakpoint, const StoppedRay& ray, std::size_t step);
// The next (or the last before) step, other than `from`, at which one that is on stops.
std::optional<std::size_t> nextStop(const std::vector<Breakpoint>& breakpoints, const StoppedRay& ray, std::size_t from,
                                    bool forward);

// Over what lies deeper: the next (or the last before) step that is on no finer level than `from`; at the ends the last
// (first) one. A log without levels is stepped through one by one.
std::size_t stepOver(const std::vector<Step>& steps, std::size_t from, bool forward);

// In a few words: "level < 2".
Message breakpointTitle(const Breakpoint& breakpoint);
// Throws InputError(subject, ...) for a value out of range.
void checkBreakpoint(const Breakpoint& breakpoint, const std::string& subject);

}  // namespace relief
