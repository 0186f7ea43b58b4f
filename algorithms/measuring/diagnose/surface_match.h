// Looks for the surface on which the answers of a tracer lie. An answer gives a point of the tracer's own ray; if the
// tracer reads the heights by another convention, the answers lie on the surface of that convention. No ray is traced,
// so that many combinations can be tried; which of them a tracer has is decided by predicting its answers.
#pragma once

#include <vector>

#include "measuring/diagnose/answered_rays.h"
#include "measuring/diagnose/tracer_model.h"

namespace relief {

// Returns at most `most` models of conventions, the likeliest first: those on whose surface the answers lie best, fewer
// faults preferred. begin: the model that they all extend. late: how far behind the surface the answers lie on average,
// lambda. Throws Cancelled.
std::vector<TracerModel> surfaceMatches(const AnsweredRays& given, const TracerModel& begin, ModelFields& fields,
                                        std::size_t most, double late, Work& work);

}  // namespace relief
