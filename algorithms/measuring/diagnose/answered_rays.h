// Rays with the answers that a tracer gave.
#pragma once

#include <vector>

#include "relief/ray.h"

namespace relief {

// answers: one per ray; s and t of hits are NaN if they are not known.
struct AnsweredRays {
    RayBlock rays;
    std::vector<Hit> answers;

    std::size_t size() const { return answers.size(); }
};

}  // namespace relief
