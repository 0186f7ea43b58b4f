// TIFF files with a description: integer codes of one channel, or float pages as MIP levels.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "relief/image.h"

namespace relief {

using PictureCodes = std::variant<std::vector<float>, std::vector<std::uint16_t>, std::vector<std::uint8_t>>;

// Writes width x height codes, row by row and unchanged, with `description` in the ImageDescription tag. path ends in
// .tif or .tiff. Throws WorkError (full disk, ...), InputError for another extension.
void writeDescribedTiff(const std::string& path, int width, int height, const PictureCodes& codes,
                        const std::string& description);

// One float picture of a multi-page file, and its ImageDescription.
struct DescribedPage {
    const FloatImage* picture = nullptr;
    std::string description;
};
// Writes the pages in order, marked as the MIP levels of the first, in tiles of kTiffTile texels a side. path ends in
// .tif or .tiff; the file appears only when it is complete. Throws WorkError, InputError for another extension.
inline constexpr int kTiffTile = 64;
void writeMipTiff(const std::string& path, const std::vector<DescribedPage>& pages);

}  // namespace relief
