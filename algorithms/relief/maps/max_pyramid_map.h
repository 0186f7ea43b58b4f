// The hierarchy of maxima over the cells of a height field. [MIP18] fig. 3.
// Level 0: the texel heights (columns), or the largest of a cell's four corners (bilinear). Valid for any ray.
#pragma once

#include "images/pyramid.h"
#include "relief/cell_grid.h"
#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/maps/tiled_pyramid.h"

namespace relief {

struct MaxPyramidMap {
    static constexpr RayClass kRays = RayClass::AnyRays;
    Pyramid pyramid;
    // For a field that is read by tiles, in place of the pyramid, which then has no levels.
    std::shared_ptr<const TiledPyramid> tiled{};

    std::size_t bytes() const { return tiled ? tiled->bytes() : pyramid.bytes(); }
    int top() const { return tiled ? tiled->top() : pyramid.levels() - 1; }
    float highest() const { return tiled ? tiled->highest() : pyramid.level(top())(0, 0); }
};

// Level 0: the largest height of the surface in each cell.
FloatImage cellMaxima(const HeightField& field, Work& work);
// Takes the map from the cache, or builds it in parallel; O(cells). before: the map of heights that differ in few
// texels; if it has as many cells, unchanged levels are shared with it.
std::shared_ptr<const MaxPyramidMap> maxPyramidMap(const HeightField& field, MapCache& cache, Work& work,
                                                   const MaxPyramidMap* before = nullptr);

}  // namespace relief
