// Each step of a tracer, said in a sentence. Keyed on the closed sets of decisions and primitives, so that a new tracer
// adds none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "messages.h"
#include "relief/describe.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace relief {

// What a sentence says beyond its record.
struct StepContext {
    bool hierarchy = true;           // the method knows the highest point of the map (a pyramid's top)
    std::optional<Decision> before;  // of the step before, if there is one
    std::optional<ViewRay> ray;      // to say where a hit lies
    int layers = 0;                  // equal layers that the slab is cut into; 0: none, or not known
    bool distances = false;          // the method walks a map of distances: its values are no heights
    bool slopes = false;             // the same of cones
};

// Of the step `index` of a ray's log: what stands before it, and what the method's options say.
StepContext stepContext(const MethodChoice& method, const ViewRay& ray, const std::vector<Step>& steps,
                        std::size_t index);

// The number with `decimals` places after the point, whatever the locale.
std::string fixedText(double value, int decimals);
// Decimals, at least 2 and at most 6, with which two numbers that differ read differently.
int tellingDecimals(double a, double b);

// The decision's name for people: "skip", "пропуск".
Message decisionTitle(Decision decision);

// The layer of which the step is about, if it ends on one of `layers` equal layers; -1 otherwise.
std::int64_t layerOf(const Step& step, int layers);

Message stepSentence(const Step& step, const StepContext& context);

}  // namespace relief
