// The cells around a box in the order in which the builder of refined maps looks at them: in tiles, nearest first.
#pragma once

#include <cstdint>
#include <vector>

#include "relief/image.h"
#include "relief/maps/azimuth_sectors.h"

namespace relief {

// A horizon sector in which a cell can be seen from a box, the stored sector that it belongs to, and the least way to
// the cell within it.
struct Seen {
    std::uint8_t sector;
    std::uint8_t stored;
    double t2;
};

// A cell near a box: how far, and the sectors in which it can be seen, [firstSeen, endSeen) of the table.
struct CellAround {
    int dx;
    int dy;
    double t;
    std::size_t firstSeen;
    std::size_t endSeen;
};

// Cells [first, end) of the table, in a square of kTile with its corner there; the stored sectors that they are seen
// in.
inline constexpr int kTile = 8;
struct Tile {
    int dx;
    int dy;
    double t;
    std::uint32_t stored;
    std::size_t first;
    std::size_t end;
};

struct CellsAround {
    std::vector<CellAround> cells;  // of a tile together, nearest first
    std::vector<Seen> seen;
    std::vector<Tile> tiles;  // nearest first
};

// Around a box of width x height cells, its corner at (0, 0), up to `radius` texels away, seen in horizon `sectors` of
// which equal numbers together are one of `stored`.
CellsAround cellsAround(int width, int height, int radius, const AzimuthSectors& sectors, int stored);

// The highest of each square of kTile cells: (x, y) is that of the one with its corner at the cell (x, y) if the
// picture wraps, else at (x - kTile + 1, y - kTile + 1), nothing being outside.
FloatImage highestOfTiles(const FloatImage& cells, bool wraps);

}  // namespace relief
