// Tracers with known faults, for the tests of diagnose(). Faults of conventions are put into the heights, the rays or
// the answers, not into the models by which diagnose() recognises them. Faults of the search are those of methods of
// the list, such as layers, or changes of the answers.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "measuring/diagnose/diagnose.h"

namespace relief::test {

// The tracer with what it reads; a fault changes it before the rays are traced.
struct Patient {
    FloatImage heights;
    RayBlock rays;
    Address address = Address::Repeat;
    MethodChoice method{"exact", {}};
    std::function<void(HitBlock&, const RayBlock&)> answer{};  // changes the answers
};

struct Specimen {
    std::string name;  // of the fault
    std::function<void(Patient&)> infect;
    std::set<std::string> company{};  // faults that come with it and may be named as well
};

const std::vector<Specimen>& specimens();
const Specimen& specimen(const std::string& name);

// The map on which specimens are tried: "bricks" or "fractal".
HeightField specimenField(const std::string& relief);
RayBlock specimenRays(const HeightField& field, std::size_t count);

// Traces the rays with all of the faults.
TracerRecord record(const std::vector<Specimen>& faults, const HeightField& field, const RayBlock& rays);

}  // namespace relief::test
