// Inside elliptical_grid.cpp and its log, not for others: what is known of the points of a tile.
#pragma once

#include <algorithm>
#include <cstdint>

#include "filtering/elliptical_grid.h"

namespace relief {

// Cells of the squares in which points are traced and read one after the other.
inline constexpr int kSquare = 4;
// Of a point.
enum PointState : std::uint8_t { kUnknown, kWanted, kHit, kMissed };

// Pixels of one view within one tile, the cells around them, and their points. Kept from tile to tile of a thread.
struct GridKernel::Tile {
    const PixelView* view = nullptr;
    glm::dvec2 scale{1};
    std::vector<std::size_t> pixels;            // of the block
    int x0 = 0, y0 = 0, width = 0, height = 0;  // of the cells
    // A cell's centre.
    std::vector<std::uint8_t> centre;
    std::vector<glm::dvec2> place;
    std::vector<double> lambda;
    std::vector<ViewRay> ray;
    // A cell's points, one after the other.
    std::vector<std::uint8_t> state;
    std::vector<Color> color;
    // Points to be read, square after square: where, and what is met.
    std::vector<std::uint32_t> slots;
    std::vector<glm::dvec2> at;
    std::vector<ViewRay> rays;
    std::vector<Hit> hits;
    // The rays that are traced, and whose they are.
    std::vector<std::uint32_t> traced;
    RayBlock block;
    HitBlock found;
    // Pixels that are plain, and with what; the others.
    FilterBlock plain;
    std::vector<std::size_t> plainOf, edges;
    PointBlock points;
    std::vector<Color> colors;
    std::vector<std::uint32_t> colorOf;

    std::size_t cell(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x - x0);
    }
    // body(cell, x, y): squares of cells one after the other.
    template <class Body>
    void overCells(const Body& body) const {
        for (int top = 0; top < height; top += kSquare) {
            for (int left = 0; left < width; left += kSquare) {
                for (int y = top; y < std::min(top + kSquare, height); ++y) {
                    for (int x = left; x < std::min(left + kSquare, width); ++x) {
                        body(cell(x0 + x, y0 + y), x0 + x, y0 + y);
                    }
                }
            }
        }
    }
};

}  // namespace relief
