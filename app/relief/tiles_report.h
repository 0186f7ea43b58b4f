// A height map that is read by tiles: what it holds, and what reading it took, for reports and --verbose.
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "images/tiled_heights.h"
#include "session.h"

namespace relief::app {

// A hash that differs if any height does, for Json that says what a result depends on. Throws InputError, WorkError.
std::string tilesHash(const TiledHeights& tiles);
// rays: by which the bytes read are divided.
nlohmann::ordered_json tilesJson(const TiledHeights& tiles, std::size_t rays);
// Prints the same as a note, with --verbose.
void noteTiles(Session& session, const TiledHeights& tiles, std::size_t rays);

}  // namespace relief::app
