// Compares the answers of somebody's tracer with the exact ones, and names what is wrong with it.
//
// A fault is named if a model of a tracer with that fault predicts the answers, or if the kind of their errors shows
// it. Conventions are found by the surface on which the answers lie (surface_match.h), faults of the search by where
// they lie on the ray (search_faults.h). After the best explanation, the answers that it does not explain are examined
// again, so that several faults are found.
//
// Frame and units: ray.h. Cost: one exact trace of all rays; if many are wrong, some hundred traces of 700 of them, a
// few of 8000 in each round, and one of 20000 for each convention that differs.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "measuring/diagnose/search_faults.h"

namespace relief {

// What is known of a tracer. hits: one per ray, in the order of the rays; lambda of a hit in [0, 1]; s and t may be
// NaN, and the number of steps 0, if they are unknown. steps: the step logs of the rays, empty for some, if there are
// any.
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
    std::size_t worst = 0;  // the wrong ray with the largest error
    std::vector<float> errors;

    // Returns true if the wrong answers are so few that they are rounding.
    bool healthy() const;
    // Returns true if so many wrong answers remain unexplained that there must be a further fault.
    bool unknown() const;
};

// Throws InputError if the field is read by tiles, MemoryError, Cancelled.
Diagnosis diagnose(const TracerRecord& record, const HeightField& field, Work& work);

// Returns the lines that `relief diagnose` prints: one for each finding, which begins with the fault's name, and one
// for what is unknown; or one that says that there is no fault. names: returns the name of a ray.
using RayNames = std::function<Message(std::size_t)>;
std::vector<Message> diagnosisLines(const Diagnosis& diagnosis, const RayNames& names);

}  // namespace relief
