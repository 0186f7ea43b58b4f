// All tracers behind one face: the list that command line, selector, benchmarks and laws iterate over.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/map_cache.h"
#include "relief/tracer.h"

namespace relief {

// Those that can work inside the segments of `hybrid`.
std::vector<std::string> innerTracerNames();

// Every tracer there is, in the order of lists.
const std::vector<MethodDescription>& tracerList();
// Throws InputError(subject, ...) with the known names.
const MethodDescription& findTracer(const std::string& name, const std::string& subject = {});

// The options that a choice can have: the method's own and, as inner.NAME, those of the method inside it.
struct ChoiceOption {
    OptionDescription description;  // its name with the prefix
    std::string defaultValue;
};
std::vector<ChoiceOption> choiceOptions(const MethodChoice& choice);
// Whether the method, and the one inside it, can be made for such a field.
bool supports(const MethodChoice& choice, Surface surface, Address address);
// Throws InputError(subject, ...) for an unknown method or option, or a value out of range.
void checkMethod(const MethodChoice& choice, const std::string& subject);

// Builds the maps it needs (from the cache if they are there). Form::Simd: the SIMD version where the method has one
// for these options; Form::Scalar: the reference alone, and none of the maps that only the SIMD version reads. Throws
// InputError for unknown names and options.
std::unique_ptr<Tracer> makeTracer(const MethodChoice& choice, const HeightField& field, MapCache& cache, Work& work,
                                   Form form = Form::Simd);
// The form of what makeTracer() makes when it is free to choose. Throws InputError for unknown names and options.
Form methodForm(const MethodChoice& choice);

}  // namespace relief
