// The cells around a box in the order in which the builder of refined maps examines them: in tiles, nearest first.
#pragma once

#include <cstdint>
#include <vector>

#include "relief/image.h"
#include "relief/maps/azimuth_sectors.h"

namespace relief {

// A horizon sector in which a cell is visible from a box, the stored sector that contains it, and the square of the
// shortest distance to the cell within it.
struct Seen {
    std::uint8_t sector;
    std::uint8_t stored;
    double t2;
};

// A cell near a box: its offset, its distance, and the sectors in which it is visible, [firstSeen, endSeen) of the
// table.
struct CellAround {
    int dx;
    int dy;
    double t;
    std::size_t firstSeen;
    std::size_t endSeen;
};

// The cells [first, end) of the table within a square of kTile cells at the offset (dx, dy), and the stored sectors in
// which they are visible.
inline constexpr int kTile = 8;
struct Tile {
    int dx;
    int dy;
    double t;
    std::uint32_t stored;
    std::size_t first;
    std::size_t end;
};

// The table of cells around a box.
struct CellsAround {
    std::vector<CellAround> cells;  // grouped by tile, nearest first
    std::vector<Seen> seen;
    std::vector<Tile> tiles;  // nearest first
};

// The cells around a box of width x height cells with its corner at (0, 0), up to `radius` texels away. sectors:
// horizon sectors; equal numbers of them form one of the `stored` sectors.
CellsAround cellsAround(int width, int height, int radius, const AzimuthSectors& sectors, int stored);

// The highest cell of each square of kTile x kTile cells. If the picture wraps, (x, y) stores the square with its
// corner at the cell (x, y); otherwise the one at (x - kTile + 1, y - kTile + 1), of which the part outside is empty.
FloatImage highestOfTiles(const FloatImage& cells, bool wraps);

}  // namespace relief
