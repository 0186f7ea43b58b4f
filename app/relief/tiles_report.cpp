#include "tiles_report.h"

#include <algorithm>
#include <array>
#include <span>

#include <nlohmann/json.hpp>

#include "part.h"

namespace relief::app {

namespace {

double bytesEach(const TileStatistics& read, std::size_t rays) {
    return static_cast<double>(read.bytesRead) / static_cast<double>(std::max<std::size_t>(rays, 1));
}

}  // namespace

std::string tilesHash(const TiledHeights& tiles) {
    const std::array facts{static_cast<std::uint64_t>(tiles.width()), static_cast<std::uint64_t>(tiles.height()),
                           static_cast<std::uint64_t>(tiles.type()), tiles.checksum()};
    return hashText(std::as_bytes(std::span(facts)));
}

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
    constexpr int kDigits = 3;
    const auto megabytes = [](std::size_t bytes) {
        return numberText(static_cast<double>(bytes) / kMegabyte, kDigits);
    };
    const TileStatistics read = tiles.statistics();
    session.note(tiles.path(), Message(MessageId::TilesTaken, {{"read", read.tilesRead},
                                                               {"megabytes", megabytes(read.bytesRead)},
                                                               {"misses", read.misses},
                                                               {"each", numberText(bytesEach(read, rays), kDigits)},
                                                               {"resident", megabytes(tiles.residentBytes())},
                                                               {"limit", megabytes(tiles.residentLimit())}}));
}

}  // namespace relief::app
