// The vertices of the displacement mesh: heights `density` to a side of the texture, the first at the first texel's
// centre. So every density that is a multiple of the map's size has a vertex at the centre of every texel.
#pragma once

#include "relief/height_field.h"
#include "relief/map_cache.h"

namespace relief {

struct MeshHeights {
    FloatImage heights;
    int density = 1;

    std::size_t bytes() const { return heights.bytes(); }
};

// Vertex (i, j) is the surface's height at (1/2 + i W / density, 1/2 + j H / density) texels. Under repeat there are
// density x density of them; else none beyond the first at or behind the last texel's centre, behind which the surface
// is level. From the cache, or sampled (O(vertices), in parallel). density >= 1.
std::shared_ptr<const MeshHeights> meshHeights(const HeightField& field, int density, MapCache& cache, Work& work);

}  // namespace relief
