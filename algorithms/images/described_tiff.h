// Codes of one channel as a TIFF holds them, unchanged, with a text that says what they are (ImageDescription).
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace relief {

using PictureCodes = std::variant<std::vector<float>, std::vector<std::uint16_t>, std::vector<std::uint8_t>>;

// width x height codes, row by row; .tif or .tiff. Throws WorkError (full disk, ...), InputError for another ending.
void writeDescribedTiff(const std::string& path, int width, int height, const PictureCodes& codes,
                        const std::string& description);

}  // namespace relief
