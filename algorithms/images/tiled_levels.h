// Builds the levels of a tiled pyramid from bands of the map, holding 64 rows of each level in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "images/tiled_layout.h"
#include "relief/function_ref.h"
#include "relief/thread_team.h"

namespace relief {

// Maxima, minima and means have the same bits as those of Pyramid. Not thread-safe.
class TiledLevels {
  public:
    // Takes a row of tiles: the rows of a level from `firstRow`, a multiple of kTileSide, kTileSide of them or those
    // that are left; numbers of the page's type, row by row.
    using Sink = FunctionRef<void(const TilePage& page, int firstRow, int count, const std::byte* rows)>;

    static std::unique_ptr<TiledLevels> of(const TiledLayout& layout);

    TiledLevels() = default;
    virtual ~TiledLevels() = default;
    TiledLevels(const TiledLevels&) = delete;
    TiledLevels& operator=(const TiledLevels&) = delete;

    // Adds the next kTileSide rows of level 0, or those that are left. Needs flush() before the next call.
    virtual void add(const std::byte* rows, int count, ThreadTeam& threads) = 0;
    // Hands the rows of tiles that are complete to `sink`. If that throws, the same rows are handed over again by the
    // next call.
    virtual void flush(ThreadTeam& threads, Sink sink) = 0;

    // The rows that are not yet handed over, as bytes, and the reverse. restore() returns false if the bytes are not
    // those of a pyramid of this layout.
    virtual std::vector<std::byte> save() const = 0;
    virtual bool restore(std::span<const std::byte> saved) = 0;

    // Largest number of bytes of save(), and memory that the levels take.
    static std::uint64_t savedBytes(const TiledLayout& layout);
    static std::uint64_t memoryBytes(const TiledLayout& layout);
};

}  // namespace relief
