// SIMD loops of conservative_cones.cpp: slopes required by near cells, and the nodes of a list that can steepen a cone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relief {

// Nodes as a structure of arrays. Coordinates are relative to the corner of the block of cells, so that distant nodes
// are rounded relative to their distance.
struct ConeNodes {
    struct Place {
        int level, i, j;
        int shiftX, shiftY;
    };
    std::vector<float> middleX, middleY, halfX, halfY;
    std::vector<float> highest, value, gradientX, gradientY;
    std::vector<Place> places;

    void clear();
    void add(float x, float y, float halfAcross, float halfDown, float top, float plane, float slopeX, float slopeY,
             const Place& place);
    // Pads the columns to whole vectors; call after the last add().
    void finish();
    std::size_t size() const { return places.size(); }
};

// Writes to `which` the indices, in order, of the nodes of which a cell may be higher than apex + slope * gap, seen
// from the cell (x, y). No such node is omitted, whatever the rounding. which: room for nodes.size(). Returns their
// number.
std::size_t nodesAbove(const ConeNodes& nodes, float x, float y, float apex, float slope, std::uint32_t* which);

// Rows of cells are read, and rows of results written, up to the next multiple of this number.
inline constexpr int kNearPad = 32;

// out[i]: the highest of the 3 x 3 cells around cells[i], 0 <= i < n. stride: distance between rows.
void apexesAbove(const float* cells, std::ptrdiff_t stride, int n, float* out);

// Near cells grouped by their gap: their offsets from a cell; those of ring k end at ends[k].
struct NearRings {
    std::vector<std::ptrdiff_t> offsets;
    std::vector<std::size_t> ends;
    std::vector<float> inverseGaps;
};
// slopes[i] = max over rings k of (highest of the ring - apexes[i]) * inverseGaps[k], at least 0, 0 <= i < n.
void steepenByRings(const NearRings& rings, const float* cells, const float* apexes, int n, float* slopes);

}  // namespace relief
