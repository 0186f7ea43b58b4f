// A bilinear height field as lanes read its slopes; pointers are not owned.
#pragma once

#include <cstdint>

#include "relief/height_field.h"
#include "relief/maps/packed_cones.h"

namespace relief {

struct SlopeScene {
    const float* heights = nullptr;
    std::int32_t width = 0, height = 0;
    bool repeat = true;  // else clamped, as border is
    // The four of a cell in one place (PackedCones), cells of a row and one; null: they are read from the heights.
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
