#include "tiles_report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace relief::app {

namespace {

double bytesEach(const TileStatistics& read, std::size_t rays) {
    return static_cast<double>(read.bytesRead) / static_cast<double>(std::max<std::size_t>(rays, 1));
}

}  // namespace

nlohmann::ordered_json tilesJson(const TiledHeights& tiles, std::size_t rays) {
    const TileStatistics read = tiles.statistics();
    return {{"read", read.tilesRead},
            {"bytes", read.bytesRead},
            {"misses", read.misses},
            {"evictions", read.evictions},
            {"bytes_per_ray", bytesEach(read, rays)},
            {"resident_bytes", tiles.residentBytes()},
            {"resident_limit", tiles.residentLimit()}};
}

void noteTiles(Session& session, const TiledHeights& tiles, std::size_t rays) {
    if (!session.verbose()) return;
    constexpr double kMegabyte = 1 << 20;
    const TileStatistics read = tiles.statistics();
    session.note(tiles.path(),
                 Message(MessageId::TilesTaken, {{"read", read.tilesRead},
                                                 {"megabytes", static_cast<double>(read.bytesRead) / kMegabyte},
                                                 {"misses", read.misses},
                                                 {"each", bytesEach(read, rays)},
                                                 {"resident", static_cast<double>(tiles.residentBytes()) / kMegabyte},
                                                 {"limit", static_cast<double>(tiles.residentLimit()) / kMegabyte}}));
}

}  // namespace relief::app
