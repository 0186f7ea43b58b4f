#include "relief/maps/map_memory.h"

namespace relief {

void checkMapMemory(const std::string& map, std::size_t bytes, const MapCache& cache) {
    if (bytes <= cache.budget()) return;
    constexpr double kMega = 1024.0 * 1024.0;
    throw InputError("map " + map,
                     Message(MessageId::MapTooLarge, {{"megabytes", static_cast<double>(bytes) / kMega},
                                                      {"cap", static_cast<double>(cache.budget()) / kMega}}));
}

}  // namespace relief
