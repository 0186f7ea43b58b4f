// Which of a list of nodes can steepen a cone: the inner loop of conservative_cones.cpp, in lanes.
#pragma once

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

}  // namespace relief
