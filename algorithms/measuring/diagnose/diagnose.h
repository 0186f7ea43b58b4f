// The doctor: compares the answers of anybody's tracer with those of `exact`, and names what is wrong with it.
//
// A fault is named if a model of a tracer with that fault predicts the answers, or if the kind of their errors shows
// it. Conventions are found by the surface on which the answers lie (surface_match.h), faults of the search by where
// they lie on the ray (search_faults.h). After the best explanation, what it does not explain is looked at again, so
// that several faults are found.
//
// Frame and units: ray.h. Cost: two exact traces of all rays, and some hundred of 700 of them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "measuring/diagnose/search_faults.h"

namespace relief {

// What is known of a tracer. hits: one per ray, in the order of the rays; lambda of a hit in [0, 1], s and t may be
// NaN; steps: 0 if they were not counted. steps: the records of the rays, if there are any.
struct TracerRecord {
    RayBlock rays;
    HitBlock hits;
    std::optional<StepLog> steps;
};

// A fault. rays: number of rays that it makes wrong. worst: one of them with the largest error; texels: that error,
// infinite if the outcome differs.
struct Finding {
    ModelFault fault;
    std::size_t rays = 0;
    std::size_t worst = 0;
    double texels = 0;
};

// findings: largest number of rays first. wrong: rays whose answer differs from `exact` by more than kRightTexels;
// touching: among the others, those that differ only because they barely touch the surface. unexplained: wrong rays
// that no finding explains (an estimate from a sample). errors: of each ray, texels.
struct Diagnosis {
    std::vector<Finding> findings;
    std::size_t rays = 0;
    std::size_t wrong = 0;
    std::size_t touching = 0;
    std::size_t unexplained = 0;
    std::size_t worst = 0;  // the ray with the largest error
    std::vector<float> errors;

    // So few wrong answers are no fault: rounding.
    bool healthy() const;
    // Whether so many wrong answers remain unexplained that there must be a further fault.
    bool unknown() const;
};

// Throws InputError if the field is read by tiles, MemoryError, Cancelled.
Diagnosis diagnose(const TracerRecord& record, const HeightField& field, Work& work);

// Returns the lines that `relief diagnose` prints: one for each finding, which begins with the fault's name, and one
// for what is unknown; or one that says that there is no fault. names: returns the name of a ray.
using RayNames = std::function<Message(std::size_t)>;
std::vector<Message> diagnosisLines(const Diagnosis& diagnosis, const RayNames& names);

}  // namespace relief
