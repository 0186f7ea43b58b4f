// The hierarchy of maxima over the cells of a height field. [MIP18] fig. 3.
// Level 0: the texel heights (columns), or the largest of a cell's four corners (bilinear). Valid for any ray.
#pragma once

#include "images/pyramid.h"
#include "relief/cell_grid.h"
#include "relief/describe.h"
#include "relief/map_cache.h"

namespace relief {

struct MaxPyramidMap {
    static constexpr RayClass kRays = RayClass::AnyRays;
    Pyramid pyramid;

    std::size_t bytes() const { return pyramid.bytes(); }
    int top() const { return pyramid.levels() - 1; }
    float highest() const { return pyramid.level(top())(0, 0); }
};

// Level 0: the largest height of the surface in each cell.
FloatImage cellMaxima(const HeightField& field, Work& work);
// Takes the map from the cache, or builds it in parallel; O(cells). before: the map of heights that differ in few
// texels; if it has as many cells, unchanged levels are shared with it.
std::shared_ptr<const MaxPyramidMap> maxPyramidMap(const HeightField& field, MapCache& cache, Work& work,
                                                   const MaxPyramidMap* before = nullptr);

}  // namespace relief
