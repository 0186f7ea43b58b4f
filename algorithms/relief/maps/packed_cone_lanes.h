// The inner loops of packed_cones.cpp, in lanes. Rows are `stride` numbers apart; each loop reads and writes up to
// kConePad numbers past the end of a row, where there must be room.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace relief {

inline constexpr int kConePad = 16;
inline constexpr std::size_t kConeRings = 8;  // an octave

// One tile of cells.
struct ConeTile {
    std::size_t stride = 0;
    int width = 0;
    int height = 0;
    float* apex = nullptr;
    float* slope = nullptr;
    std::uint32_t* depths = nullptr;  // own cell, apex << 10
};

// Windows of numbers, each the highest from its corner on, in place: larger by shift in x and in y. width, height: of
// the result; the windows before reach shift farther.
void growWindows(float* windows, std::size_t stride, int width, int height, int shift);
// By 1, and no cone of the tile (at the windows' corner) less steep than the windows' highest at that gap asks.
void growAndSteepen(float* windows, std::size_t stride, int width, int height, float inverseGap, const ConeTile& tile);

// Windows over blocks of 2^level cells, one plane a ring. x0, y0: of the tile, from the first block's corner.
struct ConeRings {
    std::array<const float*, kConeRings> planes{};
    std::array<float, kConeRings> inverseGaps{};
    std::size_t stride = 0;
    int level = 0;
    int x0 = 0;
    int y0 = 0;
};
// Returns what the highest cell would still rise above a cone of the tile, were it `farther` away; at most 0: nothing
// farther matters.
float steepenByBlocks(const ConeRings& rings, float highest, float farther, const ConeTile& tile);

// The tile's apexes (at most a little lower than what is stored) and depths from those of cells, a row and column more
// than the tile's; slopes 0.
void placeApexes(const std::uint32_t* depths, std::size_t stride, float highest, float unit, const ConeTile& tile);
// A row of words.
void packCones(const ConeTile& tile, int row, std::uint32_t* entries);

}  // namespace relief
