// Joins bands of rows, each stored in a file of its own (writeColor()), to one picture.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "relief/files.h"
#include "relief/work.h"

namespace relief {

// Name of the metadata that holds a band's text: a text chunk in PNG, an attribute in EXR. TIFF stores the text in its
// ImageDescription.
inline constexpr std::string_view kBandAttribute = "relief part";

// Largest picture that is joined of bands, pixels.
inline constexpr std::int64_t kMostBandPixels = std::int64_t{1} << 32;

// Header of a band's file. text: the band's description, empty if the file is a picture but not a band.
struct BandFile {
    ImageInfo info;
    std::string text;
};
// Reads the header only. Throws InputError if the file is not a readable picture.
BandFile readBandFile(const std::string& path);

// Joins the bands, given from top to bottom, and writes them as one picture of the bands' format. Samples, their type,
// channel names and colour space stay as they are; the bands' text is not copied. Throws InputError (a band is damaged
// or does not match the first), MemoryError before allocating, WorkError, Cancelled. Memory: the picture and two bands.
void joinBands(const std::vector<std::string>& bands, const std::string& path, Work& work);

// Writes a picture of info's size, channels, type and colour space. numbers: samples row by row, channels interleaved,
// of info's type, but float where that is half. description: if not empty, stored in the file (PNG, TIFF, EXR). Throws
// WorkError, InputError for an unknown extension.
void writeNumbers(const std::string& path, const ImageInfo& info, const std::byte* numbers,
                  const std::string& description = {});

}  // namespace relief
