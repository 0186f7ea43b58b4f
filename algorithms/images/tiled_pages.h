// What the pages of a tiled pyramid's file say about themselves: written by tiled_writer.cpp, read by
// tiled_heights.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "images/big_tiff.h"
#include "images/tiled_layout.h"

namespace relief {

inline constexpr int kTiledFileVersion = 2;

// "height", "max", "min" or "mean".
const char* tileKindName(TileKind kind);

// Description of a page of a pyramid: format, version, kind, level, number of levels, size of the page and of level 0,
// unit, and which heights a texel stands for. kind: of the pyramid, also for level 0 where that has no page of its own
// kind.
nlohmann::ordered_json pyramidPage(int version, TileKind kind, int level, int levels, std::pair<int, int> size,
                                   std::pair<int, int> field);

// The layout of the file for a map of this size and type.
TiledLayout tiledLayout(int width, int height, NumberType type);
// The file's bytes before the first tile. checksum: of the table of checksums.
std::vector<std::byte> tiledHead(const TiledLayout& layout, std::uint64_t checksum);

struct TiledHead {
    TiledLayout layout;
    std::uint64_t checksum = 0;  // of the table of checksums
};
// Reads and checks the head of an open file. std::nullopt if it has not this layout.
std::optional<TiledHead> readTiledHead(int descriptor);
// Returns true if the file begins like one of this layout and version.
bool beginsTiled(int descriptor);

}  // namespace relief
