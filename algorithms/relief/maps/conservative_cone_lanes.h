// How steep near cells make a cone, and which of a list of nodes can steepen it: the inner loops of
// conservative_cones.cpp, in lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relief {

// Nodes in columns. Cells count from a corner of the cells that look: a node far off then is rounded by its way's
// share.
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
    // After the last: fills the columns up for whole vectors.
    void finish();
    std::size_t size() const { return places.size(); }
};

// The numbers of the nodes some cell of which may rise above apex + slope * gap, seen from the cell (x, y); in order.
// None that does is left out, rounding included. which: room for nodes.size(); returns how many.
std::size_t nodesAbove(const ConeNodes& nodes, float x, float y, float apex, float slope, std::uint32_t* which);

// Rows of cells are read, and rows of results written, up to the next multiple of this.
inline constexpr int kNearPad = 32;

// out[i]: the highest of the 3 x 3 cells around cells[i], 0 <= i < n. stride: from one row to the next.
void apexesAbove(const float* cells, std::ptrdiff_t stride, int n, float* out);

// Cells by their gap from a cell: where they are from it, those of ring k up to ends[k].
struct NearRings {
    std::vector<std::ptrdiff_t> offsets;
    std::vector<std::size_t> ends;
    std::vector<float> inverseGaps;
};
// slopes[i] = max over rings k of (highest - apexes[i]) * inverseGaps[k], not below 0, 0 <= i < n.
void steepenByRings(const NearRings& rings, const float* cells, const float* apexes, int n, float* slopes);

}  // namespace relief
