// Each step of a tracer, said in a sentence: by its decision and by what it looked at, so that a new tracer adds none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/messages.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace relief {

// What a sentence says beyond its record.
struct StepContext {
    const Step* before = nullptr;  // the step before, if there is one
    std::optional<ViewRay> ray;    // to say where a hit lies
    std::optional<Hit> exact;      // to say where a map's promise is broken
};

// The number with `decimals` places after the point, whatever the locale.
std::string fixedText(double value, int decimals);
// Decimals, at least 2 and at most 6, with which two numbers that differ read differently.
int tellingDecimals(double a, double b);

// The decision's name for people: "skip", "пропуск".
Message decisionTitle(Decision decision);

Message stepSentence(const Step& step, const StepContext& context);

// What the exact hit shows of the sphere or cone that a step trusts. None: the step trusts none. Kept: also where no
// exact hit is known. Broken: the surface is met on the part of the ray that the map promised free. Behind: the ray was
// past the surface before.
enum class MapPromise : std::uint8_t { None, Kept, Broken, Behind };
MapPromise mapPromise(const Step& step, const StepContext& context);

// How far a method's answer is from the exact hit, texels: |lambda - exact lambda| max(1, hypot(a, b)); infinite where
// the outcomes differ, 0 where neither hits or the exact one is not known (Limit, Unset).
double answerError(const Hit& answer, const Hit& exact, const ViewRay& ray);
// Where the exact hit is, and how far the answer is from it.
Message answerSentence(const Hit& answer, const Hit& exact, const ViewRay& ray);
// Of step `index` of a ray's log. exact: the first hit, if it is known.
Message stepSentence(const std::vector<Step>& steps, std::size_t index, const ViewRay& ray,
                     const std::optional<Hit>& exact = {});

}  // namespace relief
