// The vertices of the displacement mesh: heights at the centres of density x density equal parts of the texture.
#pragma once

#include "relief/height_field.h"
#include "relief/maps/map_cache.h"

namespace relief {

struct MeshHeights {
    FloatImage heights;  // density x density

    std::size_t bytes() const { return heights.bytes(); }
};

// Vertex (i, j) is the surface's height at ((i + 1/2) W / density, (j + 1/2) H / density) texels. From the cache, or
// sampled (O(vertices), in parallel). density >= 1.
std::shared_ptr<const MeshHeights> meshHeights(const HeightField& field, int density, MapCache& cache, Work& work);

}  // namespace relief
