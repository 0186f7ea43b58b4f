// FILE.part of a tiled pyramid that is being written: the tiles at their final places, and behind them two places for a
// journal of what is done, written in turn so that one of them is always whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/part_file.h"
#include "images/tiled_layout.h"

namespace relief {

class TiledPart {
  public:
    struct State {
        std::int64_t bands = 0;         // done, of kTileSide rows
        std::string learned;            // HeightRows::learned()
        std::vector<std::byte> levels;  // TiledLevels::save()
    };

    // Creates or opens `path`.part; if `path` is a symbolic link, it stands next to the link's target. work: what the
    // file will hold; Resume refuses what another work has left. Throws InputError (it is there and `earlier` is
    // Refuse, another process writes it, or it is of other work), WorkError.
    TiledPart(const std::string& path, const TiledLayout& layout, const std::string& work, EarlierRun earlier);
    // Removes the file if nothing has been kept in it.
    ~TiledPart();
    TiledPart(const TiledPart&) = delete;
    TiledPart& operator=(const TiledPart&) = delete;

    const std::string& path() const { return part_; }
    // What the earlier run has kept.
    const std::optional<State>& earlier() const { return earlier_; }
    // Number of bands kept, 0 at the beginning.
    std::int64_t kept() const { return kept_; }

    // Writes tiles that stand one after another in the file, and notes their checksums. Thread-safe. Throws WorkError.
    void writeTiles(const TilePage& page, std::uint64_t offset, std::span<const std::byte> tiles);
    // Makes all that is written survive a power cut, together with the state. Throws WorkError.
    void keep(const State& state);
    // Completes the file and renames it. Throws WorkError.
    void finish();

  private:
    void open(EarlierRun earlier);
    void close();
    void lock();
    void reserve();
    std::optional<State> stateAt(int place, std::uint64_t& sequence) const;
    void findEarlier();
    bool untouched() const;
    void write(std::uint64_t at, const void* bytes, std::size_t count);
    std::span<const std::byte> table() const { return std::as_bytes(std::span(checksums_)); }
    std::uint64_t placeOfState(int place) const {
        return layout_.fileBytes + static_cast<std::uint64_t>(place) * most_;
    }
    [[noreturn]] void fail(int error) const;

    std::string path_, target_, part_, work_;  // target_: the file that is replaced
    TiledLayout layout_;
    std::uint64_t most_;  // bytes reserved for a state
    std::vector<std::uint64_t> checksums_;
    std::optional<State> earlier_;
    std::uint64_t sequence_ = 0;
    std::int64_t kept_ = 0;
    int descriptor_ = -1;
    bool finished_ = false;
};

}  // namespace relief
