// Prefetches the tiles that coherent rays, such as those of a part of a frame, will read.
#pragma once

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

class TiledPyramid;

// The field must be read by tiles. pyramid: the one that the rays walk over; null: they read heights only. Does nothing
// where the rays spread over more than a few megabytes of heights.
void prefetchAlong(const HeightField& field, const TiledPyramid* pyramid, const RayBlock& rays);

}  // namespace relief
