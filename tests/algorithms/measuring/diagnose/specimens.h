// Tracers with faults put in on purpose, for the tests of the doctor. They share no code with the models by which the
// doctor recognises them: faults of conventions are put into the picture, the rays or the answers of a method of the
// list, and the faulty searches are loops of their own.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "measuring/diagnose/diagnose.h"

namespace relief::test {

// What somebody's tracer works on; a fault changes it before the rays are traced.
struct Patient {
    FloatImage heights;
    RayBlock rays;
    Address address = Address::Repeat;
    MethodChoice method{"exact", {}};
    double slab = 0;                                         // thickness of the slab, texels
    std::function<void(HitBlock&, const RayBlock&)> answer;  // changes the answers
};

struct Specimen {
    std::string name;  // the fault's
    std::function<void(Patient&)> infect;
    // Faults that come with it and may be named as well.
    std::set<std::string> company{};
};

const std::vector<Specimen>& specimens();
const Specimen& specimen(const std::string& name);

// The map on which specimens are tried: "bricks" or "fractal".
HeightField specimenField(const std::string& relief);
RayBlock specimenRays(const HeightField& field, std::size_t count);

// Traces the rays with all of the faults.
TracerRecord record(const std::vector<Specimen>& faults, const HeightField& field, const RayBlock& rays);

}  // namespace relief::test
