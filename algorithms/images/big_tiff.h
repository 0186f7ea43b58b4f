// The directories of a TIFF file (TIFF 6.0, and BigTIFF, which has 64-bit offsets), written and read without a library:
// libtiff decides itself where tiles go, and cannot go on with a file that it has begun.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace relief {

// An uncompressed picture, grey or RGB, in tiles of kTileSide texels or in one strip, little-endian.
struct TiffPage {
    std::uint32_t width = 0, height = 0;
    int bits = 8;                        // of a number
    int channels = 1;                    // 1: grey, 3: RGB, interleaved
    bool floats = false;                 // else unsigned integers
    bool reduced = false;                // a smaller version of another page
    bool tiled = true;                   // else one strip
    std::string description;             // ImageDescription
    std::vector<std::uint64_t> offsets;  // of the tiles, row by row; of the strip

    bool operator==(const TiffPage&) const = default;
};

// Classic: offsets below 4 GiB, which every reader of TIFF reads; all pages in tiles.
enum class TiffForm : std::uint8_t { Classic, Big };

// Bytes of the head that tiffHead() makes of these pages; depends only on their number, descriptions, numbers of
// channels and numbers of offsets.
std::size_t tiffHeadBytes(const std::vector<TiffPage>& pages, TiffForm form = TiffForm::Big);
// The file's first bytes: header, directories and arrays of offsets.
std::vector<std::byte> tiffHead(const std::vector<TiffPage>& pages, TiffForm form = TiffForm::Big);

// Reads the directories of a BigTIFF file one by one. For files of others: each number is checked before it is used.
class TiffDirectories {
  public:
    // descriptor: the file, which must stay open.
    explicit TiffDirectories(int descriptor);
    // Reads the next page. std::nullopt at the end, or if the page is not such as tiffHead() writes: compressed, of
    // several channels, in tiles of another size, big-endian, or damaged. Of the offsets only the first and the last
    // are read; `tiles` is their number.
    struct Found {
        TiffPage page;
        std::uint64_t tiles = 0;
    };
    std::optional<Found> next();

  private:
    bool read(std::uint64_t at, void* to, std::size_t count) const;
    struct Entry;
    bool take(const Entry& entry, Found& found) const;

    int descriptor_;
    std::uint64_t next_ = 0;  // offset of the next directory; 0: none
};

}  // namespace relief
