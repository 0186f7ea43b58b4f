// What texture filters are asked for runs of pixels, in lanes: pixelQuery() of each, the same bits.
#pragma once

#include "filtering/filter_block.h"
#include "relief/height_field.h"
#include "rendering/visible_polygons.h"

namespace relief {

// Pixels of one row from (x, y) on, all of one polygon and with hits; columns from `from` on.
struct QueryRun {
    const VisiblePolygon& polygon;
    const RayBlock& rays;
    const HitBlock& hits;
    std::size_t from = 0;
    int x = 0, y = 0;
    std::size_t count = 0;
};

// Into block[first ...], which is there; without `exact`.
void setQueries(const QueryRun& run, const HeightField& field, FilterBlock& block, std::size_t first);

}  // namespace relief
