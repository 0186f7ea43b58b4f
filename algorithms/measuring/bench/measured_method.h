// A method to be measured: its name and options as in tables and commands, and a function that makes its tracer.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "relief/tracers.h"

namespace relief {

struct MeasuredMethod {
    using Make = std::function<std::unique_ptr<Tracer>(const HeightField&, MapCache&, Work&)>;

    MethodChoice choice;
    Form form = Form::Simd;  // Scalar: the reference implementation, even if there is a SIMD version
    std::vector<Surface> surfaces{Surface::Bilinear, Surface::Columns};  // supported surfaces
    std::vector<Address> addresses{Address::Repeat, Address::Clamp, Address::Border};
    bool buildsMaps = false;  // of other maps than pyramids, such as distances and cones, which take long to build
    Make make;                // tests substitute a faulty tracer here

    // Returns true if the method supports such a field.
    bool supports(Surface surface, Address address) const;
};

// Returns a method of the list with these options. Throws InputError for unknown names.
MeasuredMethod measuredMethod(const MethodChoice& choice, Form form = Form::Simd);

// Parses "layers" or "layers-bisection:layers=128:bisections=4" and checks the options. Throws InputError naming
// `option`.
MethodChoice parseMethodChoice(const std::string& text, const std::string& option);
// Returns only the options, "layers=64:bisections=8"; if `all`, including the defaults of options that were not given.
std::string optionsText(const MethodChoice& choice, bool all);
// The inverse of parseMethodChoice().
std::string methodText(const MethodChoice& choice);

// Returns every tracer of the list with default options.
std::vector<MeasuredMethod> defaultMethods(Form form = Form::Simd);
// Returns false if checkMethod() refuses the choice, for example an option that needs another one.
bool isAccepted(const MethodChoice& choice);
// Returns each of them with every accepted combination of the defaults, range ends (numbers) and choices of its
// options, starting with the default combination; for methods that build maps, options are varied one at a time.
std::vector<MeasuredMethod> methodVariants();

}  // namespace relief
