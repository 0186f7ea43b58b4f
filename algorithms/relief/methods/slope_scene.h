// A bilinear height field for the SIMD evaluation of slopes; pointers are not owned.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "relief/height_source.h"
#include "relief/maps/packed_cones.h"

namespace relief {

struct SlopeScene {
    const float* heights = nullptr;  // null: the map is read by tiles
    const TiledHeights* tiles = nullptr;
    bool gathered = true;  // whether heights are fetched by 32-bit indices; otherwise lane by lane, through cornersAt()
    std::int32_t width = 0, height = 0;
    bool repeat = true;  // false: clamped, also under border
    // The four corner heights of each cell stored together (PackedCones::nodes), and the number of cells per row; null:
    // they are fetched from the heights.
    const float* nodes = nullptr;
    std::int32_t nodeStride = 0;

    SlopeScene() = default;
    explicit SlopeScene(const HeightField& field)
        : heights(field.tiles() != nullptr ? nullptr : field.heights().data()),
          tiles(field.tiles()),
          gathered(gathersHeights(field)),
          width(field.width()),
          height(field.height()),
          repeat(field.address() == Address::Repeat) {}
    SlopeScene(const HeightField& field, const PackedCones& cones) : SlopeScene(field) {
        if (cones.nodes.empty()) return;
        nodes = cones.nodes.data();
        nodeStride = cones.stride;
    }

    // Heights at (i0, j0), (i1, j0), (i0, j1), (i1, j1).
    std::array<float, 4> cornersAt(int i0, int i1, int j0, int j1) const {
        return cornersOf(tiles, heights, width, i0, i1, j0, j1);
    }
};

}  // namespace relief
