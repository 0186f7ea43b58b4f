// Bands of rows, each in a file of its own (PictureBand), put together again.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "relief/files.h"
#include "relief/work.h"

namespace relief {

// Where a band's text stands: a text chunk of that name in PNG, an attribute in EXR. TIFF has neither: there it is the
// ImageDescription.
inline constexpr std::string_view kBandAttribute = "relief part";

// Larger pictures than this are not put together.
inline constexpr std::int64_t kMostBandPixels = std::int64_t{1} << 30;

// A band's file as it says of itself. text: empty where it is a picture and no band.
struct BandFile {
    ImageInfo info;
    std::string text;
};
// Throws InputError where it is no picture that can be read. Reads no pixel.
BandFile readBandFile(const std::string& path);

// Writes the bands, given from the top, as one picture: the numbers, their type, the channels' names and the colour
// space as the bands have them, no text. path: of the format of the bands. Throws InputError (a band that does not fit
// the first, is damaged), MemoryError before it is taken, WorkError, Cancelled. Memory: the picture and two bands.
void joinBands(const std::vector<std::string>& bands, const std::string& path, Work& work);

// A picture of info's size, channels, type and colour space; numbers: row by row, channels next to each other; float
// where the type is half. Throws WorkError, InputError for an unknown ending.
void writeNumbers(const std::string& path, const ImageInfo& info, const std::byte* numbers);

}  // namespace relief
