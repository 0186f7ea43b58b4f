// Height maps larger than memory: the file that `relief tile` writes, read tile by tile within a bound on resident
// memory. FORMATS.md describes the file.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "images/tiled_layout.h"

namespace relief {

// Totals since the file was opened.
struct TileStatistics {
    std::uint64_t tilesRead = 0;
    std::uint64_t bytesRead = 0;
    std::uint64_t misses = 0;     // accesses that had to wait for a tile; more than tilesRead if threads wait for one
    std::uint64_t evictions = 0;  // groups of tiles (kGroupBytes) that were dropped
};

// The tiles of one level of one kind that cover a rectangle of texels; for prefetch().
struct TileRange {
    TileKind kind = TileKind::Height;
    int level = 0;
    int left = 0, top = 0;      // first texel
    int right = 0, bottom = 0;  // last texel, included
};

// Where SIMD (tile_lanes-inl.h) finds the heights and maxima in the file mapped into memory.
struct TileAccess {
    static constexpr int kLevels = 32;
    static constexpr std::uint8_t kUsed = 2;  // the state of tiles that may be read without touch()
    const std::byte* map = nullptr;           // the file
    // One for every kLeastTileBytes of the file, and three more, since SIMD reads words of 32 bits; null if their
    // indices take more than 31 bits.
    const std::atomic<std::uint8_t>* states = nullptr;
    NumberType type = NumberType::Float;
    int tileBytesShift = 0, acrossShift = 0, downShift = 0;  // as in TilePage
    // By level, of the heights (0) and of the maxima (others): the first group of tiles, and groups in a row.
    std::array<std::int32_t, kLevels> firstGroup{}, groupsAcross{};
};

// Heights in [0, 1] and their pyramid. Level 0 is the height map; texel (x, y) of a level l >= 1 is the maximum,
// minimum or mean of the heights of 2^l x 2^l texels, with the same bits as in Pyramid.
//
// The file is mapped into memory, and a tile is checked against its checksum whenever it is read from the file. It
// takes memory of the process only while it is resident.
// Thread-safe. An access costs about two comparisons more than one to an array if its tile is resident; otherwise the
// tile is read, and the groups of tiles that were not used for longest are dropped. Accesses throw WorkError if the
// file cannot be read, InputError if a tile is damaged. If the file is shortened, or its disk fails, while it is open,
// accesses may return zeros instead: what was computed from heights is right only if requireWhole() returns afterwards.
class TiledHeights {
  public:
    // Opens a file written by `relief tile`, checks its header, pages, size and the table of checksums. residentBytes:
    // bound on the memory taken by tiles and tables. Only the tables and one tile may exceed it.
    // Throws InputError (missing, another layout, truncated, damaged), MemoryError.
    static std::shared_ptr<TiledHeights> open(const std::string& path, std::size_t residentBytes);
    // Returns true if the file's first bytes are those of a file written by `relief tile`. Reads only these. False if
    // the file cannot be read.
    static bool isTiled(const std::string& path);

    ~TiledHeights();
    TiledHeights(const TiledHeights&) = delete;
    TiledHeights& operator=(const TiledHeights&) = delete;

    const std::string& path() const { return path_; }
    int width() const { return layout_.width; }
    int height() const { return layout_.height; }
    // Number of levels, level 0 included: Pyramid::levelCount(width, height).
    int levels() const { return layout_.levels; }
    // Size of a level in texels.
    int width(int level) const { return layout_.page(TileKind::Max, level).width; }
    int height(int level) const { return layout_.page(TileKind::Max, level).height; }
    // Type of the stored heights, maxima and minima: UInt8, UInt16 or Float. Means are floats.
    NumberType type() const { return layout_.type; }
    const TiledLayout& layout() const { return layout_; }
    // Checksum of the table of all tiles' checksums.
    std::uint64_t checksum() const { return checksum_; }

    // 0 <= x < width(level), 0 <= y < height(level). Level 0 of each kind is the height.
    float height(int x, int y) const { return value(layout_.pages.front(), x, y); }
    float maximum(int level, int x, int y) const { return value(TileKind::Max, level, x, y); }
    float minimum(int level, int x, int y) const { return value(TileKind::Min, level, x, y); }
    float mean(int level, int x, int y) const { return value(TileKind::Mean, level, x, y); }
    float value(TileKind kind, int level, int x, int y) const { return value(layout_.page(kind, level), x, y); }
    // Heights at (i0, j0), (i1, j0), (i0, j1), (i1, j1); for neighbours, as those of a cell, little more than one
    // access.
    std::array<float, 4> corners(int i0, int i1, int j0, int j1) const;
    // The largest of four such values of a level of maxima.
    float highest(int level, int i0, int i1, int j0, int j1) const;

    const TileAccess& access() const { return access_; }

    // Asks the system to read the tiles that are not resident in the background. A hint: errors are ignored, nothing
    // counts as read.
    void prefetch(std::span<const TileRange> ranges) const;

    // Throws InputError if the file has been shortened since it was opened, WorkError if it could not be read
    // otherwise, and zeros have been returned for it.
    void requireWhole() const;

    TileStatistics statistics() const;
    // Memory that tiles and tables take, in bytes; at most residentLimit(), except as said at open().
    std::size_t residentBytes() const;
    std::size_t residentLimit() const { return limit_; }

  private:
    // States of a tile. The first access makes it resident, a further one marks it as used; what stays unused is
    // dropped first.
    static constexpr std::uint8_t kAbsent = 0, kResident = 1, kUsed = TileAccess::kUsed;

    TiledHeights(std::string path, std::size_t residentBytes);

    float value(const TilePage& page, int x, int y) const {
        return tileValue(page.type, tileOf(page, x, y), indexOf(x, y));
    }
    // The tile with this texel, resident: should it be dropped meanwhile, the same bytes come from the file again.
    const std::byte* tileOf(const TilePage& page, int x, int y) const {
        const std::uint64_t at = page.tileOffset(x >> kTileShift, y >> kTileShift);
        std::atomic<std::uint8_t>& state = states_[at >> kStateShift];
        if (state.load(std::memory_order_acquire) != kUsed) touch(page, at, state);
        return map_ + at;
    }
    static std::size_t indexOf(int x, int y) {
        return static_cast<std::size_t>((y & kTileMask) << kTileShift | (x & kTileMask));
    }
    // Whether the four texels lie in one tile, each next to the other.
    static bool inOneTile(int i0, int i1, int j0, int j1) {
        return i1 - i0 == 1 && j1 - j0 == 1 && (i0 & kTileMask) != kTileMask && (j0 & kTileMask) != kTileMask;
    }
    void setAccess();
    // Makes the tile at byte `at` resident, or marks it as used if it is.
    void touch(const TilePage& page, std::uint64_t at, std::atomic<std::uint8_t>& state) const;

    struct Cache;

    std::string path_;
    TiledLayout layout_;
    std::uint64_t checksum_ = 0;
    std::size_t limit_ = 0;
    const std::byte* map_ = nullptr;
    std::unique_ptr<std::atomic<std::uint8_t>[]> states_;  // one for every kLeastTileBytes of the file
    std::unique_ptr<Cache> cache_;
    TileAccess access_;
};

inline std::array<float, 4> TiledHeights::corners(int i0, int i1, int j0, int j1) const {
    const TilePage& page = layout_.pages.front();
    if (!inOneTile(i0, i1, j0, j1)) [[unlikely]]
        return {value(page, i0, j0), value(page, i1, j0), value(page, i0, j1), value(page, i1, j1)};
    const std::byte* const tile = tileOf(page, i0, j0);
    const std::size_t i = indexOf(i0, j0), below = i + kTileSide;
    return {tileValue(page.type, tile, i), tileValue(page.type, tile, i + 1), tileValue(page.type, tile, below),
            tileValue(page.type, tile, below + 1)};
}

inline float TiledHeights::highest(int level, int i0, int i1, int j0, int j1) const {
    const TilePage& page = layout_.page(TileKind::Max, level);
    if (!inOneTile(i0, i1, j0, j1)) [[unlikely]]
        return std::max({value(page, i0, j0), value(page, i1, j0), value(page, i0, j1), value(page, i1, j1)});
    const std::byte* const tile = tileOf(page, i0, j0);
    const std::size_t i = indexOf(i0, j0), below = i + kTileSide;
    return highestValue(page.type, tile, i, below);
}

}  // namespace relief
