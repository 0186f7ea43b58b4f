// Packed cones: one entry of 32 bits for each cell and quadrant of directions, for SIMD cone tracing. A ray that leaves
// its cell above the apex A, and runs (a, b) texels while it falls by 1, does not meet the surface before
//     lambda_exit + (1 - A - lambda_exit) / (1 + kappa max(|a|, |b|)).
//
// Proof: a ray of quadrant q visits only cells on the side to which it runs, including its own row and column. Every
// such cell c, at a gap g in the maximum norm (between nearest points), satisfies Cmax(c) <= A + kappa g. When the ray
// is in c, it has moved by at least g since it left its own cell. Cells of gap 0 are the own cell and its three
// neighbours in the quadrant; A is their maximum. Values are rounded so that this holds after decoding.
// Repeat: the nearest copy of each cell in the quadrant counts; the others are farther. Clamp, border: there are no
// cells outside; using the entry of the outermost cell for positions beyond it is safe, because all cells are nearer to
// it.
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

// An entry's bits 10 to 19 (depth of the apex), combined with the bits of this number, are the float kApexMore plus the
// depth.
inline constexpr float kApexMore = 0x1p13F;

// An entry: bits 0 to 9 are the depth of the own cell's highest point, bits 10 to 19 the depth of the apex, and the
// whole entry read as a float is kappa in heights per texel. Its sign, exponent and first three mantissa bits are
// chosen so that it is at least kappa and above 0.
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

// The index of the quadrant to which a ray runs: bit 0 is set if its run in x is negative, bit 1 for y (0 is not
// negative).
inline std::size_t quadrantOf(const GridRay& ray) {
    return (ray.x.side < 0 ? 1U : 0U) + (ray.y.side < 0 ? 2U : 0U);
}

// Factor on a jump to the edge of a cone, in double: the rounding of the quotient is far below the rest.
inline constexpr double kShorterShare = 1 - 1e-9;

// From this number of entries per quadrant on, the length of a row is a multiple of 2^kRowShift entries, so that SIMD
// can compute the index of an entry in float.
inline constexpr std::size_t kWideEntries = std::size_t{1} << 22U;
inline constexpr int kRowShift = 7;

// The map: immutable once built, may be shared by threads. Valid for any ray.
struct PackedCones {
    static constexpr RayClass kRays = RayClass::AnyRays;
    int nx = 0;  // number of cells of cell_grid.h
    int ny = 0;
    double highest = 0;  // of the maxima of the cells
    double lowest = 0;
    double unit = 0;  // height = highest - depth * unit, at or above the true one; 0 if the relief is flat
    // Quadrant by quadrant, row by row.
    UnfilledVector<std::uint32_t> entries;
    // entries per row; nx + 1 or more on bilinear surfaces, so that entries and nodes of a cell have the same index
    int stride = 0;
    // Bilinear surfaces: the heights of a cell's nodes stored together, (i0, j0), (i0, j1), (i1, j0), (i1, j1) from
    // index 2 index(cx, cy) on. The nodes that neighbouring cells of a row share are stored once.
    UnfilledVector<float> nodes;

    std::size_t index(int cx, int cy) const {
        return static_cast<std::size_t>(cy) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(cx);
    }
    std::size_t quadrantEntries() const { return index(0, ny); }
    const std::uint32_t* quadrant(std::size_t number) const { return entries.data() + number * quadrantEntries(); }
    double heightAt(std::uint32_t depth) const { return highest - depth * unit; }
    std::size_t bytes() const { return entries.size() * sizeof(std::uint32_t) + nodes.size() * sizeof(float); }
};

// Takes the map from the cache, or builds it in parallel, with progress. Throws Cancelled, and InputError if it exceeds
// the cache's memory. Windows with the height of their highest cell grow from each cell: by one cell up to a gap of 15,
// then by one block of 2, 4, 8, ... cells, eight rings per octave. So neither the time nor the looseness of the bound
// (at most a quarter) grows with the gap.
std::shared_ptr<const PackedCones> packedCones(const HeightField& field, MapCache& cache, Work& work);
// Builds the map without a cache.
PackedCones buildPackedCones(const HeightField& field, Work& work);

}  // namespace relief
