// SIMD loops of packed_cones.cpp. Rows are `stride` values apart. Each loop reads and writes up to kConePad values past
// the end of a row, where there must be room.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace relief {

inline constexpr int kConePad = 16;
inline constexpr std::size_t kConeRings = 8;  // rings per octave

// The cones of one tile of cells; pointers are not owned.
struct ConeTile {
    std::size_t stride = 0;
    int width = 0;
    int height = 0;
    float* apex = nullptr;
    float* slope = nullptr;
    std::uint32_t* depths = nullptr;  // depth of the own cell | depth of the apex << 10
};

// Enlarges windows in place, by `shift` in x and in y. Each value is the maximum of a window that begins at it. width,
// height: size of the result; the input extends `shift` farther.
void growWindows(float* windows, std::size_t stride, int width, int height, int shift);
// Enlarges windows by 1, and raises the slopes of the tile (at the corner of the windows) to what the maximum of each
// window requires at the given gap.
void growAndSteepen(float* windows, std::size_t stride, int width, int height, float inverseGap, const ConeTile& tile);

// Windows over blocks of 2^level cells, one plane per ring. x0, y0: offset of the tile from the corner of the first
// block.
struct ConeRings {
    std::array<const float*, kConeRings> planes{};
    std::array<float, kConeRings> inverseGaps{};
    std::size_t stride = 0;
    int level = 0;
    int x0 = 0;
    int y0 = 0;
};
// Raises the slopes of the tile. Returns the largest height by which the highest cell, at distance `farther`, would
// exceed a cone of the tile; if it is at most 0, cells at that distance and beyond do not matter.
float steepenByBlocks(const ConeRings& rings, float highest, float farther, const ConeTile& tile);

// Sets the tile's apexes (slightly lower than the stored ones) and depths from the depths of cells, which extend one
// row and one column beyond the tile; sets slopes to 0.
void placeApexes(const std::uint32_t* depths, std::size_t stride, float highest, float unit, const ConeTile& tile);
// Packs a row of the tile into entries.
void packCones(const ConeTile& tile, int row, std::uint32_t* entries);

}  // namespace relief
