// A height map that is read by tiles: what it holds, and what reading it took, for reports and --verbose.
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "images/tiled_heights.h"
#include "session.h"

namespace relief::app {

// Returns a hash of the map's sizes, type and checksums, for identifying a run.
std::string tilesHash(const TiledHeights& tiles);
// Returns what was read of the map. rays: number of rays by which the bytes are divided.
nlohmann::ordered_json tilesJson(const TiledHeights& tiles, std::size_t rays);
// Prints the same as a note, with --verbose.
void noteTiles(Session& session, const TiledHeights& tiles, std::size_t rays);

}  // namespace relief::app
