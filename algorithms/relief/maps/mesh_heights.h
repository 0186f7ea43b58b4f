// The vertices of the displacement mesh: `density` heights per side of the texture, the first at the centre of the
// first texel. So with every density that is a multiple of the map's size there is a vertex at the centre of every
// texel.
#pragma once

#include "relief/height_field.h"
#include "relief/map_cache.h"

namespace relief {

struct MeshHeights {
    FloatImage heights;
    int density = 1;

    std::size_t bytes() const { return heights.bytes(); }
};

// Vertex (i, j) has the height of the surface at (1/2 + i W / density, 1/2 + j H / density) texels. Under repeat there
// are density x density vertices. Otherwise they end with the first one at or after the last texel's centre, after
// which the surface is level. Takes them from the cache, or samples them in parallel; O(vertices). density >= 1.
std::shared_ptr<const MeshHeights> meshHeights(const HeightField& field, int density, MapCache& cache, Work& work);

}  // namespace relief
