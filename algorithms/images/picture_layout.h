// Where the rows of a picture stand in a file without compression: TIFF in tiles (8-bit sRGB; BigTIFF from 4 GiB on) or
// OpenEXR in rows (32-bit floats). All of it follows from the picture's size, so that rows can be written in any order
// and a run that was stopped goes on. Described in FORMATS.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "images/tiled_layout.h"
#include "relief/files.h"

namespace relief {

struct PlacedPicture {
    bool exr = false;
    int width = 0, height = 0;          // of the whole picture
    int begin = 0, end = 0;             // the rows of it that the file holds
    std::vector<std::string> channels;  // in the order of the numbers; TIFF: R, G, B
    std::string text;                   // by which parts are joined (picture_bands.h); empty: none
};

class PictureLayout {
  public:
    // Rows are written in groups that begin a multiple of this number after the file's first row.
    static constexpr int kGroup = kTileSide;

    explicit PictureLayout(PlacedPicture picture);

    const PlacedPicture& picture() const { return picture_; }
    std::uint64_t fileBytes() const { return place(picture_.end); }
    // Bytes of a row's numbers, as encoded() takes them.
    std::size_t rowNumbers() const;
    // Byte at which a row stands; the first row of a group, or the end of the last one.
    std::uint64_t place(int row) const;
    // All bytes before the first row.
    std::vector<std::byte> head() const;
    // The file's bytes from place(first) to place(first + count). numbers: row by row, the channels of a pixel
    // interleaved.
    std::vector<std::byte> encoded(int first, int count, const std::byte* numbers) const;

  private:
    std::vector<std::byte> tiffHead() const;
    std::vector<std::byte> exrHead() const;

    PlacedPicture picture_;
    std::vector<std::size_t> order_;  // EXR: the channels by their names, as they stand in the file
    bool big_ = false;
    std::uint64_t first_ = 0;  // byte of the first row
};

// Return the pixels as writeColor() and writePlanes() store them, row by row, channels interleaved.
std::vector<std::byte> colorNumbers(const ColorImage& image, bool floats);
std::vector<std::byte> planeNumbers(const std::vector<NamedPlane>& planes);

}  // namespace relief
