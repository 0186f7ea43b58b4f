// Writes a height map as the tiled TIFF that is read with --memory.
#pragma once

#include <string>
#include <vector>

#include "images/height_rows.h"
#include "options_common.h"
#include "session.h"

namespace relief::app {

// Endings of such files.
inline const std::vector<std::string> kTiledEndings{"tif", "tiff"};

// Writes the rows to `output`, with notes on an interrupted run that is taken up or kept. Throws as TiledWriter.
void writeTiles(HeightRows& rows, const std::string& output, const RestartOptions& restart, Session& session);

}  // namespace relief::app
