// The height field as walks in float use it; shared by references (cone_walk.h, depth_walk.h) and SIMD versions.
//
// Frame of the walk: cells of cell_grid.h, mirrored so that every ray runs towards larger indices; n counts cells from
// the one in which the walk begins. The ray crosses line n at lambda = n * inverse + base. base includes a margin, so
// that this is at or after the true crossing, later by no more than `tie` for both axes together.
#pragma once

#include <algorithm>
#include <cstdint>

#include "relief/cell_grid.h"
#include "relief/float_margins.h"
#include "relief/height_source.h"
#include "relief/maps/packed_cones.h"

namespace relief {

// Pointers are not owned.
struct FloatScene {
    const float* heights = nullptr;  // null: the map is read by tiles
    std::int32_t stride = 0;
    const TiledHeights* tiles = nullptr;
    // Whether SIMD gathers heights, by 32-bit indices; otherwise it reads them lane by lane, through cornersAt().
    bool gathered = true;
    // The four corner heights of each cell stored together (PackedCones::nodes); null: they are fetched from the
    // heights.
    const float* nodes = nullptr;
    std::int32_t nodeStride = 0;
    CellGrid grid;
    Surface surface{};
    Address address{};
    std::int32_t mirror = 1;  // cell i is mirrored to mirror - 1 - i; at least the number of cells of either axis
    double start = 0;         // lambda at which walks begin: the surface does not reach as high before

    FloatScene() = default;
    FloatScene(const HeightField& field, double highest, std::int32_t mirrored)
        : heights(field.tiles() != nullptr ? nullptr : field.heights().data()),
          stride(field.width()),
          tiles(field.tiles()),
          gathered(gathersHeights(field)),
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

    // Heights at (i0, j0), (i1, j0), (i0, j1), (i1, j1).
    std::array<float, 4> cornersAt(int i0, int i1, int j0, int j1) const {
        return cornersOf(tiles, heights, stride, i0, i1, j0, j1);
    }
};

}  // namespace relief
