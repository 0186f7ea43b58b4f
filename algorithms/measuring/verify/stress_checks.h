// What every tracer must keep to, whatever the ray: the checks of relief stress, one answer at a time.
#pragma once

#include <optional>
#include <string>

#include "relief/tracers.h"

namespace relief {

// A check that failed: its name ("overshoot", "not-finite", ...), and the numbers that show it.
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

// The same bits, where NaN is equal to itself.
bool sameHit(const Hit& a, const Hit& b);

// not-finite: a hit with a number that is none, or a lambda outside [0, 1]; inconsistent: s, t are not the ray's at
// lambda; miss: a miss where nothing can be missed (repeat, clamp); limit: an exact method gave up within the domain;
// steps: more than Tracer::stepBound; bits: an exact method differs from `exact`; overshoot: a conservative one is
// later or misses. Beyond the domain (kMaxRun) bits and overshoot do not apply: there, either may have given up.
// reference: what `exact` found.
std::optional<StressFault> answerFault(const Tracer& tracer, const ViewRay& ray, const CountedHit& answer,
                                       const Hit& reference);

// sinks: the log's answer, number of steps or reads differ from the counting one's; log: it does not end with the
// outcome, or holds a number that is none.
std::optional<StressFault> logFault(const CountedHit& counted, const Hit& logged, const StepLog& log);

}  // namespace relief
