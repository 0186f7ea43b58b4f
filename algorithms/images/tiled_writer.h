// Writes the tiled pyramid of a height map that need not fit into memory; TiledHeights reads it.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "images/height_rows.h"
#include "images/tiled_levels.h"
#include "images/tiled_part.h"

namespace relief {

struct TiledWriting {
    EarlierRun earlier = EarlierRun::Refuse;
    // What is done is kept in FILE.part this often, and when the work stops or fails.
    double keepEverySeconds = 30;
};

class TiledWriter {
  public:
    // path: of the output. FILE.part beside it is created, or taken up: see TiledPart. Memory: five bands of 64 rows of
    // the map and 64 rows of each level, about 1.5 kB for each column of a map of 16 bits. Throws InputError,
    // MemoryError, WorkError.
    TiledWriter(HeightRows& source, const std::string& path, const TiledWriting& how);

    // Writes the file, which appears under its name when it is complete. The same bytes for the same heights, whatever
    // the number of threads and interruptions. Throws Cancelled after keeping what is done; InputError (of the heights)
    // and WorkError say what is kept.
    void write(Work& work);

    // Bands of 64 rows: all, those found in FILE.part at the beginning, and those kept there.
    std::int64_t bands() const { return bands_; }
    std::int64_t earlierBands() const { return part_.earlier() ? part_.earlier()->bands : 0; }
    std::int64_t keptBands() const { return part_.kept(); }
    const std::string& partPath() const { return part_.path(); }

  private:
    int rowsOf(std::int64_t band) const;
    void writeBands(Work& work);
    void writeBand(Work& work);
    std::exception_ptr readBand(std::int64_t band, std::vector<std::byte>& rows, Work& work);
    void putTiles(const TilePage& page, int firstRow, int count, const std::byte* rows, ThreadTeam& threads);
    void putGroup(const TilePage& page, int firstRow, int count, const std::byte* rows, int groupColumn);
    void keep();

    HeightRows& source_;
    std::string path_;
    TiledWriting how_;
    TiledLayout layout_;
    TiledPart part_;
    std::unique_ptr<TiledLevels> levels_;
    std::int64_t bands_;
    std::int64_t done_ = 0;
    std::string learned_;                     // of the bands done
    std::vector<std::byte> band_, nextBand_;  // heights of the band in work, and of the next one
};

}  // namespace relief
