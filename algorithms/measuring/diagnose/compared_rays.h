// Finds the rays to which a tracer's answers are wrong.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief {

// exact: the right answers. errors: of the given answers, texels; infinite if the outcome differs. wrong, right: the
// indices of the rays. touching: number of right ones whose error is larger than kRightTexels, because they barely
// touch the surface.
struct ComparedRays {
    HitBlock exact;
    std::vector<float> errors;
    std::vector<std::size_t> wrong, right;
    std::size_t touching = 0;
};

// Throws InputError if the field is read by tiles, MemoryError, Cancelled. Cost: one exact trace of all rays.
ComparedRays compareRays(const RayBlock& rays, const HitBlock& hits, const HeightField& field, Work& work);

}  // namespace relief
