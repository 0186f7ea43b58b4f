// The scalar text of the walk by packed cones: for the rays that lanes leave over, from where they left them. All exact
// methods give the same bits: the one leaf decides, and cells partition the ray.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing. Rays of the domain of exactness (packedWalks()).
#pragma once

#include <vector>

#include "relief/maps/packed_cones.h"

namespace relief {

// Rays that it takes; flatter ones each method gives up after steps of its own.
inline bool packedWalks(const CellGrid& grid, const ViewRay& ray) {
    return !ray.finite() || GridRay(grid, ray).inDomain();
}

// A part of a ray's way. Ended: with that hit or none, which a step that began before `until` has found. Else it is in
// that cell, no earlier than at `until`.
struct PackedPart {
    std::size_t ray;  // number in the block
    double from;      // lambda before which it meets nothing
    double until;
    bool ended = false;
    Hit hit{};
    AxisCell x{}, y{};
};

struct PackedStart {
    std::size_t ray;  // number in the block
    double from;      // lambda before which it meets nothing
};

// The hits of some rays of the block, into their places. All take a step in turn: each waits for memory at every step,
// and so they wait together.
void packedHits(const HeightField& field, const CellGrid& grid, const PackedCones& cones, const RayBlock& rays,
                const std::vector<PackedStart>& starts, HitBlock& hits);

// The same for parts, of rays that enter the map.
void packedParts(const HeightField& field, const CellGrid& grid, const PackedCones& cones, const RayBlock& rays,
                 std::vector<PackedPart>& parts);

}  // namespace relief
