// The order in which the pixels of a tile are traced: neighbours on the screen are neighbours in the block of rays, so
// that vectors and packets of 4, 8 and 16 rays hold a square or half a square of pixels.
#pragma once

#include <algorithm>

#include "rendering/mesh_raster.h"

namespace relief {

inline constexpr int kBlockSide = 4;    // side of the smallest squares, pixels
inline constexpr int kSquareSide = 16;  // side of the squares that consist of those, pixels

// Calls body(x, y) once for every pixel of the tile. The tile is divided into squares of 16 x 16 pixels from its upper
// left corner, each square into blocks of 4 x 4; squares, blocks and pixels are each visited row by row. Positions
// beyond the tile's edge are skipped.
template <class Body>
void inBlockOrder(const PixelArea& tile, const Body& body) {
    const auto split = [](const PixelArea& area, int side, const auto& part) {
        for (int y = area.y0; y < area.y1; y += side) {
            for (int x = area.x0; x < area.x1; x += side) {
                part(PixelArea{x, y, std::min(x + side, area.x1), std::min(y + side, area.y1)});
            }
        }
    };
    split(tile, kSquareSide, [&](const PixelArea& square) {
        split(square, kBlockSide,
              [&](const PixelArea& block) { split(block, 1, [&](const PixelArea& p) { body(p.x0, p.y0); }); });
    });
}

}  // namespace relief
