// The mean pyramid as the lanes of elliptical_lanes.h read it: 16 bits a channel, linear light, rows padded so that
// short spans do not wrap inside.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "filtering/color_levels.h"

namespace relief {

// Texels a row goes on for at its right end; under clamp and border at its left end as well.
inline constexpr int kLanePad = 32;
inline constexpr int kMostLaneLevels = 32;
// A channel's 1.
inline constexpr float kLaneWhite = 65535;

struct LaneLevels {
    // Columns over the levels, for gathers.
    template <class T>
    using PerLevel = std::array<T, kMostLaneLevels>;

    // A texel: red in the lowest 16 bits, then green, blue, nothing. One more at the end than rows have.
    std::vector<std::uint64_t> texels;
    PerLevel<std::int32_t> origin{};  // of texel (0, 0)
    PerLevel<std::int32_t> stride{};
    PerLevel<std::int32_t> width{};
    PerLevel<std::int32_t> height{};
    PerLevel<std::int32_t> whole{};  // 1: the last row's and column's texels are as wide as the others
    int count = 0;
    Address address = Address::Repeat;
};

// Null where 16 bits do not hold the picture: a value outside [0, 1], or 2^31 texels. In parallel over rows; equal
// bits for any number of threads. Throws Cancelled.
std::shared_ptr<const LaneLevels> laneLevels(const ColorLevels& levels, Address address, Work& work);

}  // namespace relief
