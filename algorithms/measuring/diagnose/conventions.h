// The conventions in which tracers differ, as models: of the ray's direction, and of the place at which heights are
// read.
#pragma once

#include <vector>

#include "measuring/diagnose/answered_rays.h"
#include "measuring/diagnose/tracer_model.h"

namespace relief {

// Returns the number of faults of the model's conventions, without those of its heights' gain and lift.
double conventionFaults(const TracerModel& model);

// Directions that differ from the ray's; each with one fault or two.
std::vector<TracerModel> directions(const TracerModel& begin);
// Ways to read the heights that differ by at most two faults.
std::vector<TracerModel> readings(const HeightField& field);
// Returns the direction with the reading added.
TracerModel joined(TracerModel direction, const TracerModel& reading);

// Returns the directions that the reported places s, t follow: the ray's, turned and scaled; none if they lie on the
// ray or were not reported.
std::vector<TracerModel> reportedDirections(const AnsweredRays& given, const TracerModel& begin,
                                            const HeightField& field);

// Returns the models that extend `begin` by one fault that has no number, also with inverted heights.
std::vector<TracerModel> singleFaults(const TracerModel& begin, const HeightField& field);

}  // namespace relief
