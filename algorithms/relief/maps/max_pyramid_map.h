// The hierarchy of maxima over the cells of a height field. [MIP18] fig. 3.
// Level 0: the texel heights (columns), the largest of a cell's four corners (bilinear). Valid for any ray.
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

// The largest height that the surface in each cell touches: level 0.
FloatImage cellMaxima(const HeightField& field, Work& work);
// From the cache, or built (O(cells), in parallel). before: of heights that differ in few texels; with as many cells,
// levels that do not change are shared with it.
std::shared_ptr<const MaxPyramidMap> maxPyramidMap(const HeightField& field, MapCache& cache, Work& work,
                                                   const MaxPyramidMap* before = nullptr);

}  // namespace relief
