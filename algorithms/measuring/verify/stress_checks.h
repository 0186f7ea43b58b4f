// The checks of relief stress that every tracer must pass for any ray, for one answer at a time.
#pragma once

#include <optional>
#include <string>

#include "relief/tracers.h"

namespace relief {

// A failed check: its name ("overshoot", "not-finite", ...), and the numbers that show it.
struct StressFault {
    std::string check;
    std::string detail;
};

// An answer with its counts.
struct CountedHit {
    Hit hit;
    std::uint32_t steps = 0;
    std::uint32_t reads = 0;
};

// Returns true if both have the same bits, where NaN is equal to NaN.
bool sameHit(const Hit& a, const Hit& b);

// Checks an answer; reference: the answer of `exact`. The checks:
// - not-finite: a hit has a NaN or infinite number, or lambda is outside [0, 1];
// - inconsistent: s, t are not the ray's position at lambda;
// - miss: a miss where no ray can miss (repeat, clamp);
// - limit: an exact method reached a limit within the domain;
// - steps: more than Tracer::stepBound;
// - bits: an exact method differs from `exact`;
// - overshoot: a conservative method hits later than `exact`, or misses.
// Beyond the domain (kMaxRun) bits and overshoot are not checked, because either tracer may have reached a limit there.
std::optional<StressFault> answerFault(const Tracer& tracer, const ViewRay& ray, const CountedHit& answer,
                                       const Hit& reference);

// Checks a log. sinks: its answer, number of steps or reads differ from those of the counting sink; log: it does not
// end with the outcome, or contains NaN.
std::optional<StressFault> logFault(const CountedHit& counted, const Hit& logged, const StepLog& log);

}  // namespace relief
