// Each step of a tracer, said in a sentence. Keyed on the closed set of decisions, so that a new tracer adds none.
#pragma once

#include <optional>
#include <string>

#include "messages.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace relief {

// What a sentence says beyond its record.
struct StepContext {
    bool hierarchy = true;           // the method knows the highest point of the map (a pyramid's top)
    std::optional<Decision> before;  // of the step before, if there is one
    std::optional<ViewRay> ray;      // to say where a hit lies
};

// The number with `decimals` places after the point, whatever the locale.
std::string fixedText(double value, int decimals);
// Decimals, at least 2 and at most 6, with which two numbers that differ read differently.
int tellingDecimals(double a, double b);

Message stepSentence(const Step& step, const StepContext& context);

}  // namespace relief
