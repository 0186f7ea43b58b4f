// Describes each step of a tracer in a sentence, determined by its decision and by what it examined, so that new
// tracers need no sentences of their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/messages.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace relief {

// Data for a sentence in addition to the step's record.
struct StepContext {
    const Step* before = nullptr;  // the preceding step, if there is one
    std::optional<ViewRay> ray;    // for the position of a hit
    std::optional<Hit> exact;      // for broken claims of a map
};

// Returns the number with `decimals` digits after the point, independent of the locale.
std::string fixedText(double value, int decimals);
// Returns the number of decimals, from 2 to 6, with which two different numbers are printed differently.
int distinguishingDecimals(double a, double b);

// Returns the decision's name in the user's language: "skip", "пропуск".
Message decisionTitle(Decision decision);

// Describes one step in a sentence.
Message stepSentence(const Step& step, const StepContext& context);

// Compares the claim of the map on which a step relies with the exact hit. None: the step relies on no distance or
// cone. Kept: not contradicted, or no exact hit is known. Broken: the surface is met in the interval that the map
// claims to be free. Behind: the ray had already passed the surface. A relaxed cone makes no claim of being free.
enum class MapPromise : std::uint8_t { None, Kept, Broken, Behind };
MapPromise mapPromise(const Step& step, const StepContext& context);

// Returns true for a hit that follows from the one height read where the ray enters, with no other point examined.
// before: the preceding step, or null.
bool answersFromEntry(const Step& step, const Step* before);

// Returns the distance of a method's answer from the exact hit, texels: |lambda - exact lambda| max(1, hypot(a, b));
// infinite if the outcomes differ; 0 if neither hits or the exact answer is unknown (Limit, Unset).
double answerError(const Hit& answer, const Hit& exact, const ViewRay& ray);
// States the exact hit, and the distance of the answer from it.
Message answerSentence(const Hit& answer, const Hit& exact, const ViewRay& ray);
// Describes step `index` of a ray's log. exact: the first hit, if it is known.
Message stepSentence(const std::vector<Step>& steps, std::size_t index, const ViewRay& ray,
                     const std::optional<Hit>& exact = {});

}  // namespace relief
