// A bilinear height field for the SIMD evaluation of slopes; pointers are not owned.
#pragma once

#include <cstdint>

#include "relief/height_field.h"
#include "relief/maps/packed_cones.h"

namespace relief {

struct SlopeScene {
    const float* heights = nullptr;
    std::int32_t width = 0, height = 0;
    bool repeat = true;  // false: clamped, also under border
    // The four corner heights of each cell stored together (PackedCones::nodes), and the number of cells per row; null:
    // they are fetched from the heights.
    const float* nodes = nullptr;
    std::int32_t nodeStride = 0;

    SlopeScene() = default;
    explicit SlopeScene(const HeightField& field)
        : heights(field.heights().data()),
          width(field.width()),
          height(field.height()),
          repeat(field.address() == Address::Repeat) {}
    SlopeScene(const HeightField& field, const PackedCones& cones) : SlopeScene(field) {
        if (cones.nodes.empty()) return;
        nodes = cones.nodes.data();
        nodeStride = cones.stride;
    }
};

}  // namespace relief
