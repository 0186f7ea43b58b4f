// Methods as measurements take them: the choice that tables and commands spell, and how the tracer is made.
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
    Form form = Form::Simd;  // Scalar: the reference alone, even where there is a SIMD version
    std::vector<Surface> surfaces{Surface::Bilinear, Surface::Columns};  // those it knows
    std::vector<Address> addresses{Address::Repeat, Address::Clamp, Address::Border};
    bool buildsMaps = false;  // other than pyramids: distances, cones, which take their time
    Make make;                // tests put a faulty tracer here

    bool knows(Surface surface, Address address) const;
};

// A method of the list with these options. Throws InputError for unknown names.
MeasuredMethod measuredMethod(const MethodChoice& choice, Form form = Form::Simd);

// "layers", "layers-bisection:layers=128:bisections=4": name and checked options. Throws InputError naming `option`.
MethodChoice parseMethodChoice(const std::string& text, const std::string& option);
// The options alone, "layers=64:bisections=8"; with the defaults of those that were not given if `all`.
std::string optionsText(const MethodChoice& choice, bool all);
// What parseMethodChoice reads.
std::string methodText(const MethodChoice& choice);

// Every method of the list that is a tracer, as it is by default.
std::vector<MeasuredMethod> defaultMethods(Form form = Form::Simd);
// Each of them with every combination of its options' defaults, ends (numbers) and choices, the default form first;
// those that build maps with each option turned by itself.
std::vector<MeasuredMethod> methodVariants();

}  // namespace relief
