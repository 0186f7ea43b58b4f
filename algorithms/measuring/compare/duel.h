// Several methods on one ray, step by step, and what goes wrong first where one of them departs from the exact answer.
// The exact tracer is the judge; what each method says of itself in its log tells the kind.
//
// Frame and units: ray.h. Errors as everywhere: |lambda - exact lambda| max(1, hypot(a, b)), texels.
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

// A method's answer on the ray, and its log.
struct DuelRun {
    std::string name;  // for sentences
    Hit hit;
    std::vector<Step> steps;
};

// None: the exact answer, to kSameAnswer.
// MissedSpike: it looked at the surface at single places, and went on past what stands between two of them.
// StoppedEarly: it answered before the first hit, or gave up, or answered where there is nothing.
// UnsafeMap: a stored distance, cone or maximum promised an empty stretch that is not empty.
// InterpolationLeak: it had the hit within a stretch, and what it interpolated there is not the surface.
// NotRefined: it had the hit within a stretch, and answers with the stretch's end.
enum class Departure : std::uint8_t { None, MissedSpike, StoppedEarly, UnsafeMap, InterpolationLeak, NotRefined };

// step: at which it happens; [from, to]: lambda of the stretch that it is about. texels: of the final answer, infinite
// where its outcome is another one. overshoot: the first step, right in the end or not, that lies past the exact hit.
struct Judgement {
    Departure kind = Departure::None;
    std::size_t step = 0;
    double from = 0;
    double to = 0;
    double texels = 0;
    std::optional<std::size_t> overshoot;
};

// exact: the first hit; where it is Outcome::Limit (a ray too flat to be judged), None.
Judgement judge(const DuelRun& run, const Hit& exact, const ViewRay& ray, const HeightField& field);

// The kind in two words, and what happened in a sentence.
Message departureTitle(Departure kind);
Message judgementSentence(const DuelRun& run, const Judgement& judgement, const Hit& exact);

// The runs in lock step: at each moment those that are furthest behind along the ray take their next step, so that all
// stand at about the same lambda. moments[m][r]: the step at which run r stands.
struct LockStep {
    std::vector<std::vector<std::size_t>> moments;

    // The first moment at which run r stands at this step or beyond.
    std::size_t momentOf(std::size_t run, std::size_t step) const;
};
// Runs without steps stand at step 0 for ever.
LockStep lockStep(const std::vector<DuelRun>& runs);

// The run that departs first, in lock step; nothing if all answer as exact does.
std::optional<std::size_t> firstToDepart(const LockStep& moments, const std::vector<Judgement>& judgements);

}  // namespace relief
