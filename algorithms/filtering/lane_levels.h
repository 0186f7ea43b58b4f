// The mean pyramid in the layout that the SIMD filters read: 16 bits per channel, linear light, rows padded so that
// short spans need no wrapping inside.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "filtering/color_levels.h"

namespace relief {

// Padding of a row in texels: at its right end, under clamp and border also at its left end.
inline constexpr int kLanePad = 32;
inline constexpr int kMostLaneLevels = 32;
// Value of a channel that represents 1.
inline constexpr float kLaneWhite = 65535;

struct LaneLevels {
    // One value per level, as a table for gathers.
    template <class T>
    using PerLevel = std::array<T, kMostLaneLevels>;

    // A texel: red in the lowest 16 bits, then green, then blue; the highest 16 bits are unused. Padded at the end.
    std::vector<std::uint64_t> texels;
    PerLevel<std::int32_t> origin{};  // index of texel (0, 0)
    PerLevel<std::int32_t> stride{};
    PerLevel<std::int32_t> width{};
    PerLevel<std::int32_t> height{};
    PerLevel<std::int32_t> whole{};  // 1: texels of the last row and column are as wide as the others
    int count = 0;
    Address address = Address::Repeat;
};

// Converts the levels in parallel over rows; the bits are the same for any number of threads. Null if the picture
// cannot be represented: a value is outside [0, 1], or there are 2^31 texels or more. Throws Cancelled.
std::shared_ptr<const LaneLevels> laneLevels(const ColorLevels& levels, Address address, Work& work);

}  // namespace relief
