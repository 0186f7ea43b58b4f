// Makes the queries of texture filters for runs of pixels with SIMD; each has the same bits as pixelQuery().
#pragma once

#include "filtering/filter_block.h"
#include "relief/height_field.h"
#include "rendering/visible_polygons.h"

namespace relief {

// Pixels of one row from (x, y) on, all on one polygon and with hits; `from`: index of the first in the rays and hits.
struct QueryRun {
    const VisiblePolygon& polygon;
    const RayBlock& rays;
    const HitBlock& hits;
    std::size_t from = 0;
    int x = 0, y = 0;
    std::size_t count = 0;
};

// Writes the queries to block[first ...], which must be large enough; `exact` is not set.
void setQueries(const QueryRun& run, const HeightField& field, FilterBlock& block, std::size_t first);

}  // namespace relief
