// The list of all tracers, over which command line, selectors, benchmarks and tests iterate, and a function that makes
// them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/map_cache.h"
#include "relief/tracer.h"

namespace relief {

// Returns the tracers that can be used within the segments of `hybrid`.
std::vector<std::string> innerTracerNames();

// Returns all tracers, in the order in which they are listed.
const std::vector<MethodDescription>& tracerList();
// Returns the description of a tracer. Throws InputError(subject, ...) with the known names.
const MethodDescription& findTracer(const std::string& name, const std::string& subject = {});

// An option of a choice: one of the method itself or, as inner.NAME, one of the inner method.
struct ChoiceOption {
    OptionDescription description;  // the name includes the prefix
    std::string defaultValue;
};
// Returns all options that the choice can have; the inner method is that of the choice or the default.
std::vector<ChoiceOption> choiceOptions(const MethodChoice& choice);
// Returns true if the method, and its inner method, support such a field.
bool supports(const MethodChoice& choice, Surface surface, Address address);
// Throws InputError(subject, ...) for an unknown method or option, or a value out of range.
void checkMethod(const MethodChoice& choice, const std::string& subject);

// Makes a tracer, and builds the maps it needs unless they are in the cache. Form::Simd: the SIMD version if the method
// has one for these options; Form::Scalar: only the reference implementation, without maps that only the SIMD version
// reads. The tracer shares the heights and maps; field, cache and work need not outlive it. Throws InputError for
// unknown names and options, MemoryError, Cancelled.
std::unique_ptr<Tracer> makeTracer(const MethodChoice& choice, const HeightField& field, MapCache& cache, Work& work,
                                   Form form = Form::Simd);
// Returns the form of the tracer that makeTracer() makes with Form::Simd. Throws InputError for unknown names and
// options.
Form methodForm(const MethodChoice& choice);

}  // namespace relief
