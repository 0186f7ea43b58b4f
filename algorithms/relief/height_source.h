// Heights as a function of the texel, for code that is compiled once for images in memory and once for maps that are
// read by tiles: a source is a FloatImage or TileSource.
#pragma once

#include <array>
#include <cstddef>

#include "images/tiled_heights.h"
#include "relief/height_field.h"

namespace relief {

// Not owned.
struct TileSource {
    const TiledHeights& tiles;
    float operator()(int i, int j) const { return tiles.height(i, j); }
    std::array<float, 4> corners(int i0, int i1, int j0, int j1) const { return tiles.corners(i0, i1, j0, j1); }
};

// Returns true if SIMD can gather the heights: they are in memory, and their indices have 31 bits.
inline bool gathersHeights(const HeightField& field) {
    return field.tiles() == nullptr && field.texels() < std::size_t{1} << 31;
}

// Heights at (i0, j0), (i1, j0), (i0, j1), (i1, j1): read from the tiles, or if these are null from an array with
// `stride` texels per row.
inline std::array<float, 4> cornersOf(const TiledHeights* tiles, const float* heights, std::ptrdiff_t stride, int i0,
                                      int i1, int j0, int j1) {
    if (tiles != nullptr) return tiles->corners(i0, i1, j0, j1);
    const float* const above = heights + j0 * stride;
    const float* const below = heights + j1 * stride;
    return {above[i0], above[i1], below[i0], below[i1]};
}

// Returns use(source) for the field's heights.
template <class Use>
[[gnu::always_inline]] inline decltype(auto) withHeights(const HeightField& field, const Use& use) {
    if (field.tiles() != nullptr) [[unlikely]]
        return use(TileSource{*field.tiles()});
    return use(field.heights());
}

}  // namespace relief
