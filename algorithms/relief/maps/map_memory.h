// Memory of maps: those that would exceed the cache's memory are rejected before anything is allocated.
#pragma once

#include <string>

#include "relief/height_field.h"
#include "relief/map_cache.h"
#include "relief/memory.h"

namespace relief {

// Begins the kinds of maps whose MapKey::heights is a TiledHeights, not an image.
inline const std::string kTiledKind = "tiles/";

// Memory of a map, or of building it, with the given bytes per texel of the heights (and of the cells around them).
inline std::uint64_t bytesForTexels(const HeightField& field, std::uint64_t bytesEach) {
    return byteProduct(
        {static_cast<std::uint64_t>(field.width()) + 1, static_cast<std::uint64_t>(field.height()) + 1, bytesEach});
}

// Throws InputError, which names the map, its memory and the limit, if `bytes` exceed the limit of the cache.
void checkMapMemory(const std::string& map, std::size_t bytes, const MapCache& cache);

}  // namespace relief
