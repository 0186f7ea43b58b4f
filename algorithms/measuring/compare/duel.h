// Compares several methods on one ray, step by step, and determines the first error of each that departs from the exact
// answer. The exact tracer is the reference; the method's own step log determines the kind of error.
//
// Frame and units: ray.h. Errors are measured as everywhere: |lambda - exact lambda| max(1, hypot(a, b)), texels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "relief/describe.h"
#include "relief/messages.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace relief {

// The answer of a method on the ray, and its step log.
struct DuelRun {
    std::string name;  // shown in messages
    Hit hit;
    std::vector<Step> steps;
};

// The first error of a run.
// - None: the exact answer, to within kSameAnswer.
// - MissedSpike: it sampled the surface at single points, and went past a feature between two of them.
// - StoppedEarly: it answered before the first hit, reached a limit, or answered where there is no hit.
// - UnsafeMap: a stored distance, cone or maximum claimed that an interval is empty although it is not; or a relaxed
//   cone, that the ray enters the surface in it at most once.
// - InterpolationLeak: the hit was in its interval, but the point that it interpolated there is not on the surface.
// - NotRefined: the hit was in its interval, but it answered with the interval's end.
// - TakenAsFlat: it read only the height where the ray enters, and answered behind the first hit.
enum class Departure : std::uint8_t {
    None,
    MissedSpike,
    StoppedEarly,
    UnsafeMap,
    InterpolationLeak,
    NotRefined,
    TakenAsFlat
};

// step: the step at which the departure occurs; [from, to]: its lambda interval. texels: error of the final answer,
// infinite if the outcome differs. overshoot: the first step past the exact hit, even if the final answer is right.
// withinRounding: the answer differs from that of the exact tracer, but rational arithmetic (rational_hit.h) shows that
// it is right up to the rounding of positions, as where a ray touches the surface; the kind is then None.
struct Judgement {
    Departure kind = Departure::None;
    std::size_t step = 0;
    double from = 0;
    double to = 0;
    double texels = 0;
    std::optional<std::size_t> overshoot;
    bool withinRounding = false;
};

// Determines the kind of departure. exact: the first hit as the exact tracer found it; if it is Outcome::Limit (the ray
// is too grazing to be judged), the result is None. Where the answers disagree at a point that both may take for the
// surface, rational arithmetic decides, unless the heights are tiled or the ray crosses more than kRationalCells cells.
Judgement judge(const DuelRun& run, const Hit& exact, const ViewRay& ray, const HeightField& field);

// Returns the kind in two words (departureTitle), and a sentence about what happened (judgementSentence).
Message departureTitle(const Judgement& judgement);
Message judgementSentence(const DuelRun& run, const Judgement& judgement, const Hit& exact);

// Synchronises the runs: at each moment, the runs that are furthest behind along the ray take their next step, so that
// all of them stand at about the same lambda. moments[m][r]: the step at which run r stands at moment m.
struct LockStep {
    std::vector<std::vector<std::size_t>> moments;

    // Returns the first moment at which run r stands at this step or beyond.
    std::size_t momentOf(std::size_t run, std::size_t step) const;
};
// Runs without steps remain at step 0.
LockStep lockStep(const std::vector<DuelRun>& runs);

// Returns the run that departs first in the synchronised order; std::nullopt if all of them give the exact answer.
std::optional<std::size_t> firstToDepart(const LockStep& moments, const std::vector<Judgement>& judgements);

}  // namespace relief
