// Conversion of linear pictures for display.
#pragma once

#include <cstdint>
#include <span>

#include "relief/image.h"

namespace relief {

// Converts linear colours to 8-bit sRGB codes by a table; values are clamped to [0, 1], NaN becomes 0. The result
// differs by at most one code from the rounded exact curve. out: as many pixels as linear, 4 bytes each in the order B,
// G, R, 255 (a 32-bit 0xffRRGGBB on little-endian machines).
void toSrgb32(std::span<const Color> linear, std::span<std::uint32_t> out);

}  // namespace relief
