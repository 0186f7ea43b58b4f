// Linear pictures made ready for a screen.
#pragma once

#include <cstdint>
#include <span>

#include "relief/image.h"

namespace relief {

// 8-bit sRGB codes of linear colours, clamped, NaN as 0, by a table: nowhere more than one code off the exact curve's
// rounding. out: 4 bytes a pixel in the order B, G, R, 255 (a 32-bit 0xffRRGGBB on little-endian machines).
void toSrgb32(std::span<const Color> linear, std::span<std::uint32_t> out);

}  // namespace relief
