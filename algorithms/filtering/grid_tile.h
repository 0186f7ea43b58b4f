// Inside elliptical_grid.cpp and its log, not for others: what is known of the points of a tile.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "filtering/elliptical_grid.h"
#include "filtering/grid_lanes.h"

namespace relief {

// Cells of the squares in which points are traced and read one after the other.
inline constexpr int kSquare = 4;
// Cells round a pixel whose centres decide how its points are seen: the points, the centres round these, and the
// neighbours of those.
inline constexpr int kTileHalo = kLatticeHalo + 2;

// Of a place: nothing is met there.
inline constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

inline std::span<const double> part(const std::vector<double>& column, std::size_t begin, std::size_t count) {
    return std::span(column).subspan(begin, count);
}

// Points of pixels that are no plane, one after the other; all columns of one length, the first `count` in use.
struct GridPoints {
    std::size_t count = 0;
    std::vector<std::uint32_t> slots;
    std::vector<double> x, y;  // places in the picture
    std::vector<double> lambda, s, t;

    void clear() { count = 0; }
    // For so many more.
    void reserve(std::size_t more) {
        if (slots.size() >= count + more) return;
        slots.resize(count + more);
        for (auto* column : {&x, &y, &lambda, &s, &t}) column->resize(count + more);
    }
    void push(std::uint32_t slot, glm::dvec2 at) {
        reserve(1);
        slots[count] = slot;
        x[count] = at.x, y[count] = at.y;
        ++count;
    }
    // Only those for which keep(n).
    template <class Keep>
    void filter(const Keep& keep) {
        std::size_t kept = 0;
        for (std::size_t n = 0; n < count; ++n) {
            if (!keep(n)) continue;
            slots[kept] = slots[n];
            for (auto* column : {&x, &y, &lambda, &s, &t}) (*column)[kept] = (*column)[n];
            ++kept;
        }
        count = kept;
    }
};

// What was read for a point, and where it is kept.
struct ReadPoint {
    std::uint32_t slot;
    glm::dvec2 place;
    Jacobian jacobian;
};

// A cell, and where it is in the tile.
struct OrderedCell {
    std::uint32_t cell;
    std::int32_t x, y;
};

// At least as long as asked for; what was there stays.
template <class T>
void reserve(std::vector<T>& column, std::size_t count) {
    if (column.size() < count) column.resize(count);
}

// Hits of cells in float, in texels of the picture: NaN where there is none.
struct CellColumns {
    std::vector<float> s, t, lambda;
};

// Pixels of one view within one tile, the cells around them, and their points. Kept from tile to tile of a thread.
struct GridKernel::Tile {
    const PixelView* view = nullptr;
    const PictureHits* picture = nullptr;
    glm::dvec2 scale{1};
    std::vector<std::size_t> pixels;            // of the block
    int x0 = 0, y0 = 0, width = 0, height = 0;  // of the cells
    // A cell's centre; s is NaN where nothing is met, or not yet known.
    std::vector<double> s, t, lambda;
    CellColumns rough;
    std::vector<std::uint8_t> known, wanted;
    bool allKnown = false;
    std::vector<std::uint8_t> own, along;  // pixels, and what is near them in their rows
    std::vector<std::uint16_t> around;     // Surroundings
    // Of cells, all bits or none: edges, and squares whose hits follow from their corners'. Then a bit a point: whether
    // some edge sums it, and whether its hit follows from centres'.
    std::vector<std::uint16_t> edge, whole, asked, follows;
    // Squares whose corners' colours are even, and the points that take theirs from these, a bit a point.
    std::vector<std::uint16_t> even, mean;
    std::vector<PointColor> color;  // of a cell's points, one after the other
    GridPoints points;              // that are asked for; before them, centres that are not known
    std::vector<OrderedCell> order;
    int orderWidth = 0, orderHeight = 0;
    std::vector<std::uint32_t> which;
    RayBlock rays;
    HitBlock hits;
    PointBlock footprints;                     // that are read,
    std::vector<std::uint32_t> slots;          // and where they go
    std::array<std::vector<float>, 3> centre;  // of cells, red, green, blue; infinite where nothing is known
    bool logging = false;
    std::vector<ReadPoint> read;  // for the log alone
    // Pixels that are plain, and with what; the others.
    FilterBlock plain;
    std::vector<std::size_t> plainOf, edges;
    std::vector<std::int32_t> base, offset;
    std::vector<PointColor> sums;
    std::vector<Color> colors;

    std::size_t cells() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    // Whether so many pixels are all within the halo.
    bool full(std::size_t count) const {
        return count ==
               static_cast<std::size_t>(width - 2 * kTileHalo) * static_cast<std::size_t>(height - 2 * kTileHalo);
    }
    std::size_t cell(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x - x0);
    }
    // What is met at a cell's centre.
    void set(std::size_t cell, double atS, double atT, double atLambda) {
        s[cell] = atS, t[cell] = atT, lambda[cell] = atLambda;
        rough.s[cell] = static_cast<float>(atS * scale.x), rough.t[cell] = static_cast<float>(atT * scale.y);
        rough.lambda[cell] = static_cast<float>(atLambda);
    }
    // What is met at the centres of cells in a row.
    void setRow(std::size_t cell, std::size_t count, const double* atS, const double* atT, const double* atLambda) {
        std::memset(known.data() + cell, 1, count);
        std::copy_n(atS, count, s.data() + cell);
        std::copy_n(atT, count, t.data() + cell);
        std::copy_n(atLambda, count, lambda.data() + cell);
        for (std::size_t n = 0; n < count; ++n) rough.s[cell + n] = static_cast<float>(atS[n] * scale.x);
        for (std::size_t n = 0; n < count; ++n) rough.t[cell + n] = static_cast<float>(atT[n] * scale.y);
        for (std::size_t n = 0; n < count; ++n) rough.lambda[cell + n] = static_cast<float>(atLambda[n]);
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
