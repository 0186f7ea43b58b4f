// Codes of one channel as a TIFF holds them, unchanged, with a text that says what they are (ImageDescription).
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "relief/image.h"

namespace relief {

using PictureCodes = std::variant<std::vector<float>, std::vector<std::uint16_t>, std::vector<std::uint8_t>>;

// width x height codes, row by row; .tif or .tiff. Throws WorkError (full disk, ...), InputError for another ending.
void writeDescribedTiff(const std::string& path, int width, int height, const PictureCodes& codes,
                        const std::string& description);

// One float picture of a file of several, and the text that says what it is.
struct DescribedPage {
    const FloatImage* picture = nullptr;
    std::string description;
};
// Tiles of this side; the pages one after the other, marked as the MIP levels of the first. .tif or .tiff; appears only
// when complete. Throws WorkError, InputError for another ending.
inline constexpr int kTiffTile = 64;
void writeMipTiff(const std::string& path, const std::vector<DescribedPage>& pages);

}  // namespace relief
