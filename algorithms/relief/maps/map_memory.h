// Maps that would take more memory than the cache may hold are refused before anything is allocated.
#pragma once

#include <string>

#include "relief/maps/map_cache.h"

namespace relief {

// Throws InputError naming the map, what it would take and the cap.
void checkMapMemory(const std::string& map, std::size_t bytes, const MapCache& cache);

}  // namespace relief
