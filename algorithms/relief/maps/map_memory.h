// What maps take: those that would take more memory than the cache may hold are refused before anything is allocated.
#pragma once

#include <string>

#include "relief/height_field.h"
#include "relief/map_cache.h"
#include "relief/memory.h"

namespace relief {

// Bytes of a map, or of its building, that has so many for each texel of the heights (and of the cells around them).
inline std::uint64_t bytesForTexels(const HeightField& field, std::uint64_t bytesEach) {
    return byteProduct(
        {static_cast<std::uint64_t>(field.width()) + 1, static_cast<std::uint64_t>(field.height()) + 1, bytesEach});
}

// Throws InputError naming the map, what it would take and the cap.
void checkMapMemory(const std::string& map, std::size_t bytes, const MapCache& cache);

}  // namespace relief
