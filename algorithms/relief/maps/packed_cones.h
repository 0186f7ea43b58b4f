// Cones in one word a cell and quadrant of directions: what a cone tracer in lanes reads.
// A ray that leaves its cell above the apex A, running (a, b) texels while it falls by 1, meets nothing before
//     lambda_exit + (1 - A - lambda_exit) / (1 + kappa max(|a|, |b|)).
//
// Why: a ray of quadrant q sees only cells at the side it runs to, the own row and column included. For each such cell
// c, of gap g to the own in the maximum norm (between nearest points), Cmax(c) <= A + kappa g. The ray has gone g at
// least since it left its cell when it is in c. Cells of gap 0 are the own and its three neighbours of the quadrant: A
// is their highest. Stored rounded so that this holds for the decoded values.
// Repeat: the nearest copy of each cell in the quadrant; others are farther. Clamp, border: no cells outside; looking
// up the outermost cell for places beyond it is safe, for what can be seen from there is nearer to it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/large_memory.h"
#include "relief/cell_grid.h"
#include "relief/describe.h"
#include "relief/map_cache.h"

namespace relief {

// A word's depth of the apex, bits 10 to 19, under the bits of this number is a float: the depth and this.
inline constexpr float kApexMore = 0x1p13F;

// The word: bits 0 to 9 depth of the own cell's highest point, 10 to 19 depth of the apex, and the word as a float is
// kappa, heights a texel (its sign, exponent and first three bits are chosen, never 0 nor below).
inline constexpr std::uint32_t kConeDepths = 1023;
inline std::uint32_t coneOwnDepth(std::uint32_t entry) {
    return entry & kConeDepths;
}
inline std::uint32_t coneApexDepth(std::uint32_t entry) {
    return entry >> 10 & kConeDepths;
}
inline float coneSlope(std::uint32_t entry) {
    return std::bit_cast<float>(entry);
}

// Number of the quadrant that a ray runs to: bit 0 says that its run in x is negative, bit 1 that in y (a run of 0 is
// not).
inline std::size_t quadrantOf(const GridRay& ray) {
    return (ray.x.side < 0 ? 1U : 0U) + (ray.y.side < 0 ? 2U : 0U);
}

// Share of a jump to a cone's edge that is taken, in double: rounding of the quotient stays far below what is left.
inline constexpr double kShorterShare = 1 - 1e-9;

// Maps of so many words a quadrant, or more, have rows of a multiple of 2^kRowShift words: so lanes find words in
// float.
inline constexpr std::size_t kWideEntries = std::size_t{1} << 22U;
inline constexpr int kRowShift = 7;

struct PackedCones {
    static constexpr RayClass kRays = RayClass::AnyRays;
    int nx = 0;  // cells of cell_grid.h
    int ny = 0;
    double highest = 0;  // of the cells' maxima
    double lowest = 0;
    double unit = 0;  // height = highest - depth * unit: at or above the true one; 0 if the relief is flat
    // Quadrant after quadrant, each row by row.
    LargeVector<std::uint32_t> entries;
    int stride = 0;  // words a row; beyond nx on bilinear surfaces, so that a cell's words and nodes are of one number
    // Bilinear surfaces: the heights of a cell's nodes in one place, (i0, j0), (i0, j1), (i1, j0), (i1, j1) from
    // 2 index(cx, cy) on; the nodes that it shares with the next cell of its row are stored once.
    LargeVector<float> nodes;

    std::size_t index(int cx, int cy) const {
        return static_cast<std::size_t>(cy) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(cx);
    }
    std::size_t quadrantEntries() const { return index(0, ny); }
    const std::uint32_t* quadrant(std::size_t number) const { return entries.data() + number * quadrantEntries(); }
    double heightAt(std::uint32_t depth) const { return highest - depth * unit; }
    std::size_t bytes() const { return entries.size() * sizeof(std::uint32_t) + nodes.size() * sizeof(float); }
};

// From the cache, or built in parallel, with progress; throws Cancelled, InputError beyond the cache's memory.
// Windows as high as their highest cell grow from each cell: by one cell up to a gap of 15, then over blocks of 2, 4,
// 8, ... cells by one block, eight rings an octave: time and looseness (at most a quarter) do not grow with the gap.
std::shared_ptr<const PackedCones> packedCones(const HeightField& field, MapCache& cache, Work& work);
PackedCones buildPackedCones(const HeightField& field, Work& work);

}  // namespace relief
