// A height field as walks in float go over it: references (cone_walk.h, depth_walk.h) and SIMD versions alike.
//
// Frame of the walk: cells of cell_grid.h, mirrored so that every ray runs towards larger indices, n counted in cells
// from the one in which the walk begins. The ray crosses line n at lambda = n * inverse + base; base holds a margin, so
// that this is at or after the true crossing, and by no more than `tie` on both axes together.
#pragma once

#include <algorithm>
#include <cstdint>

#include "relief/cell_grid.h"
#include "relief/float_margins.h"
#include "relief/maps/packed_cones.h"

namespace relief {

// What walks in float go over; pointers are not owned.
struct FloatScene {
    const float* heights = nullptr;
    std::int32_t stride = 0;
    // The four of a cell in one place (PackedCones); null: they are read from the heights.
    const float* nodes = nullptr;
    std::int32_t nodeStride = 0;
    CellGrid grid;
    Surface surface{};
    Address address{};
    std::int32_t mirror = 1;  // cell i is mirrored to mirror - 1 - i; at least the cells of either axis
    double start = 0;         // lambda at which walks begin: nothing is as high

    FloatScene() = default;
    FloatScene(const HeightField& field, double highest, std::int32_t mirrored)
        : heights(field.heights().data()),
          stride(field.width()),
          grid(field),
          surface(field.surface()),
          address(field.address()),
          mirror(mirrored) {
        start = std::max(0.0, 1 - highest - kStartSlack);
    }
    FloatScene(const HeightField& field, const PackedCones& cones)
        : FloatScene(field, cones.highest, std::max(cones.nx, cones.ny)) {
        if (cones.nodes.empty()) return;
        nodes = cones.nodes.data();
        nodeStride = cones.stride;
    }
};

}  // namespace relief
