// What reading a height map by tiles took, for reports and --verbose.
#pragma once

#include <cstddef>

#include <nlohmann/json_fwd.hpp>

#include "images/tiled_heights.h"
#include "session.h"

namespace relief::app {

// rays: by which the bytes read are divided.
nlohmann::ordered_json tilesJson(const TiledHeights& tiles, std::size_t rays);
// Prints the same as a note, with --verbose.
void noteTiles(Session& session, const TiledHeights& tiles, std::size_t rays);

}  // namespace relief::app
