#include "tiles_report.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <span>

#include <nlohmann/json.hpp>

#include "images/file_descriptor.h"
#include "images/tiled_pages.h"
#include "part.h"

namespace relief::app {

namespace {

double bytesEach(const TileStatistics& read, std::size_t rays) {
    return static_cast<double>(read.bytesRead) / static_cast<double>(std::max<std::size_t>(rays, 1));
}

}  // namespace

std::string tilesHash(const TiledHeights& tiles) {
    const Descriptor file(::open(tiles.path().c_str(), O_RDONLY | O_CLOEXEC));
    const auto head = file.open() ? readTiledHead(file.number()) : std::nullopt;
    if (!head) throw InputError(tiles.path(), Message(MessageId::TiledNot));
    // The checksum is of the table of all tiles' checksums.
    const std::array facts{static_cast<std::uint64_t>(tiles.width()), static_cast<std::uint64_t>(tiles.height()),
                           static_cast<std::uint64_t>(tiles.type()), head->checksum};
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
