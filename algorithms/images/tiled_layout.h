// Where everything stands in the file of a tiled pyramid, described in FORMATS.md. All of it follows from the size of
// the map and the type of its heights, so that tiles can be written in any order and found by arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "images/picture_input.h"

namespace relief {

enum class TileKind : std::uint8_t { Height, Max, Min, Mean };

// Side of a tile in texels.
inline constexpr int kTileShift = 6;
inline constexpr int kTileSide = 1 << kTileShift;
inline constexpr int kTileMask = kTileSide - 1;
inline constexpr std::size_t kTileTexels = std::size_t{kTileSide} * kTileSide;
// Largest side of a map, texels: offsets and sums of a square of floats stay below 2^51.
inline constexpr int kMostTiledSide = 1 << 24;
// Tiles of 8 bits a texel; larger ones are two or four times as large.
inline constexpr int kStateShift = 12;
inline constexpr std::size_t kLeastTileBytes = std::size_t{1} << kStateShift;
// Neighbouring tiles that fill this number of bytes are stored together and dropped from memory together: Linux maps
// aligned blocks of this size around a page fault.
inline constexpr int kGroupShift = 16;
inline constexpr std::size_t kGroupBytes = std::size_t{1} << kGroupShift;

// One level of one kind: a page of the TIFF. Its tiles are stored in groups of 2 x 2 (floats), 4 x 2 (16 bits) or 4 x 4
// (8 bits), the groups row by row. Groups at the last row and column keep their full size.
struct TilePage {
    TileKind kind = TileKind::Height;
    NumberType type = NumberType::Float;
    int level = 0;
    int width = 0, height = 0;     // texels
    std::uint64_t first = 0;       // byte in the file of tile (0, 0); a multiple of kGroupBytes
    std::uint64_t firstPlace = 0;  // of the table of checksums, which has an entry for every place of a tile
    int groupsAcross = 0, groupsDown = 0;
    int tileBytesShift = 0;              // log2 of the bytes of a tile
    int acrossShift = 0, downShift = 0;  // log2 of the tiles of a group

    int tilesAcross() const { return (width + kTileMask) >> kTileShift; }
    int tilesDown() const { return (height + kTileMask) >> kTileShift; }
    std::size_t tileBytes() const { return std::size_t{1} << tileBytesShift; }
    std::uint64_t bytes() const {
        return static_cast<std::uint64_t>(groupsAcross) * static_cast<std::uint64_t>(groupsDown) << kGroupShift;
    }
    std::uint64_t places() const { return bytes() >> tileBytesShift; }

    // Byte in the file of the tile in column x and row y of tiles.
    std::uint64_t tileOffset(int x, int y) const {
        const auto group = static_cast<std::uint64_t>(y >> downShift) * static_cast<std::uint64_t>(groupsAcross) +
                           static_cast<std::uint64_t>(x >> acrossShift);
        const int within = (y & ((1 << downShift) - 1)) << acrossShift | (x & ((1 << acrossShift) - 1));
        return first + (group << kGroupShift) + (static_cast<std::uint64_t>(within) << tileBytesShift);
    }
    // Column and row of the tile at this byte.
    std::pair<int, int> tileAt(std::uint64_t offset) const;
    // Entry of the table of checksums for the tile at this byte.
    std::uint64_t placeIndex(std::uint64_t offset) const { return firstPlace + ((offset - first) >> tileBytesShift); }
};

struct TiledLayout {
    int width = 0, height = 0;
    int levels = 0;
    NumberType type = NumberType::Float;  // of heights, maxima and minima: UInt8, UInt16 or Float
    std::vector<TilePage> pages;          // the heights, then levels 1 to levels - 1 of maxima, of minima, of means
    std::uint64_t firstTile = 0;          // byte; all before it is the TIFF's directories
    std::uint64_t checksums = 0;          // byte of the table of checksums, 64 bits for each place of a tile
    std::uint64_t places = 0;
    std::uint64_t fileBytes = 0;

    // The table of checksums is also a page: a picture of 32-bit numbers, the low half of each checksum first, in rows
    // of this width. The last row is filled up with zeros.
    static constexpr int kChecksumWidth = 1024;
    int checksumHeight() const { return static_cast<int>((2 * places + kChecksumWidth - 1) / kChecksumWidth); }
    std::uint64_t checksumBytes() const {
        return static_cast<std::uint64_t>(checksumHeight()) * kChecksumWidth * sizeof(std::uint32_t);
    }

    // firstTile: a multiple of kGroupBytes. width, height >= 1.
    static TiledLayout of(int width, int height, NumberType type, std::uint64_t firstTile);

    // Level 0 is the page of the heights, whatever the kind.
    const TilePage& page(TileKind kind, int level) const {
        assert(level >= 0 && level < levels && (level == 0 || kind != TileKind::Height));
        const int index = level == 0 ? 0 : (static_cast<int>(kind) - 1) * (levels - 1) + level;
        return pages[static_cast<std::size_t>(index)];
    }
};

// Height number i of a tile. Codes are shares of the full range; one division in float gives the same bits as
// readHeight(), which divides in double and rounds.
inline float tileValue(NumberType type, const std::byte* tile, std::size_t i) {
    if (type == NumberType::UInt16) {
        std::uint16_t code = 0;
        std::memcpy(&code, tile + 2 * i, sizeof code);
        return static_cast<float>(code) / 65535.0F;
    }
    if (type == NumberType::UInt8) return static_cast<float>(static_cast<std::uint8_t>(tile[i])) / 255.0F;
    float value = 0;
    std::memcpy(&value, tile + 4 * i, sizeof value);
    return value;
}

// The largest of the heights i, i + 1, j and j + 1 of a tile. Codes are compared before the division, which is the
// most expensive part.
inline float highestValue(NumberType type, const std::byte* tile, std::size_t i, std::size_t j) {
    if (type == NumberType::UInt16) {
        std::array<std::uint16_t, 4> codes{};
        std::memcpy(codes.data(), tile + 2 * i, 2 * sizeof(std::uint16_t));
        std::memcpy(codes.data() + 2, tile + 2 * j, 2 * sizeof(std::uint16_t));
        return static_cast<float>(std::max(std::max(codes[0], codes[1]), std::max(codes[2], codes[3]))) / 65535.0F;
    }
    return std::max(std::max(tileValue(type, tile, i), tileValue(type, tile, i + 1)),
                    std::max(tileValue(type, tile, j), tileValue(type, tile, j + 1)));
}

// Checksum of a tile or of the table of checksums; words: 64-bit words, low byte first, bytes a multiple of
// kChecksumChunk. A change of a single word is always noticed.
inline constexpr std::size_t kChecksumChunk = 32;
std::uint64_t tileChecksum(const std::byte* data, std::size_t bytes);

}  // namespace relief
