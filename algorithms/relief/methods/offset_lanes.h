// SIMD version of offset and offset-limited in double, one ray per lane. Reference: OffsetTracer::shifted. It performs
// the operations of offset.h and HeightField::at in the same order, so the results are the same bits for any target and
// vector width.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

struct OffsetSearch {
    const HeightField& field;
    bool limited;  // the shift is that of offset-limited
};

// Sets hits for the rays first to last - 1. Returns the indices of rays that the reference has to trace: those so
// distant that one product cannot subtract their period exactly.
std::vector<std::size_t> offsetSimd(const OffsetSearch& search, const RayBlock& rays, std::size_t first,
                                    std::size_t last, HitBlock& hits);

}  // namespace relief
