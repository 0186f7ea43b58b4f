// The grid of cells that a ray crosses, and the crossings of its lines. This is the only code that computes a lambda
// from a cell border: every traversal and the leaf use it, so that the intervals of a ray in its cells partition [0, 1]
// exactly.
//
// Cell coordinates: x = s + shift. Columns: cell = texel. Bilinear: cell i lies between the centres of texels i and i +
// 1 under repeat; under clamp and border there are W + 1 cells, numbered here from 0 (cell c has the nodes c - 1 and c,
// clamped) and named -1 to W - 1 in logs.
// Edges: under repeat, cell k + n * cells has the edges of cell k, translated by n periods; under clamp the outermost
// cells are unbounded; under border they end at the edge of the picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// One axis of the grid, the same for all rays.
struct GridAxis {
    int cells = 0;
    int texels = 0;
    double shift = 0;   // x = s + shift
    int firstName = 0;  // the name of cell 0 in logs
    bool wraps = false;
    double low = 0;  // the lower edge of cell 0 and the upper one of the last, unless the axis wraps
    double high = 0;

    GridAxis() = default;
    GridAxis(int size, Surface surface, Address address) : texels(size), wraps(address == Address::Repeat) {
        const bool nodes = surface == Surface::Bilinear;
        const bool extended = nodes && !wraps;
        cells = extended ? size + 1 : size;
        shift = !nodes ? 0.0 : (wraps ? -0.5 : 0.5);
        firstName = extended ? -1 : 0;
        if (address == Address::Clamp) {
            low = -std::numeric_limits<double>::infinity();
            high = std::numeric_limits<double>::infinity();
        } else if (address == Address::Border) {
            low = extended ? 0.5 : 0.0;
            high = extended ? size + 0.5 : static_cast<double>(size);
        }
    }

    // x of the line below cell k, for k in [0, cells], counted within the period that begins at cell `base`.
    double edge(int k, std::int64_t base) const {
        if (wraps) return static_cast<double>(base + k);
        if (k <= 0) return low;
        return k >= cells ? high : static_cast<double>(k);
    }
    // The two texels whose heights span cell k of a bilinear surface, within [0, texels).
    int nodeBefore(int k) const { return wraps ? k : std::max(k - 1, 0); }
    int nodeAfter(int k) const { return wraps ? (k + 1 == texels ? 0 : k + 1) : std::min(k, texels - 1); }
};

// A cell on one axis: `index` in [0, cells) within the period whose first cell is `base` (0 unless the axis wraps).
struct AxisCell {
    int index = 0;
    std::int64_t base = 0;
};

// Moves the cell to its neighbour on the given side (-1 or 1). Returns false and leaves the cell unchanged where there
// is no neighbour (clamp and border, at the edge).
inline bool stepCell(const GridAxis& axis, int side, AxisCell& cell) {
    const int next = cell.index + side;
    if (next >= 0 && next < axis.cells) {
        cell.index = next;
        return true;
    }
    if (!axis.wraps) return false;
    cell.base += side * static_cast<std::int64_t>(axis.cells);
    cell.index = side > 0 ? 0 : axis.cells - 1;
    return true;
}

// The coordinate reduced to the first period, [0, size).
inline double reduceToPeriod(double x, double size) {
    if (x >= 0 && x < size) return x;
    const double rest = std::fmod(x, size);
    const double positive = rest < 0 ? rest + size : rest;
    // -1e-30 + size rounds to size, which is the same place one period later.
    return positive >= size ? 0.0 : positive;
}

// One axis of one ray: x(lambda) = start + lambda * run.
struct RayAxis {
    double start = 0;
    double run = 0;
    double inverse = 0;
    int side = 0;  // sign of the run; 0: parallel to the lines, which are never crossed

    RayAxis() = default;
    RayAxis(const GridAxis& axis, double origin, double runValue) {
        const double reduced = axis.wraps ? reduceToPeriod(origin, axis.texels) : origin;
        start = reduced + axis.shift;
        // The inverse of a smaller run would overflow. Over lambda in [0, 1] such a run does not change the position.
        constexpr double kSmallestRun = 1e-300;
        run = std::abs(runValue) < kSmallestRun ? 0.0 : runValue;
        side = run > 0 ? 1 : (run < 0 ? -1 : 0);
        inverse = side == 0 ? 0.0 : 1.0 / run;
    }

    double lambdaAt(double edge) const { return (edge - start) * inverse; }

    // Lambda at which the ray enters and leaves the cells [low, high) of a period; infinite if it runs parallel.
    // Always inlined: every walk calls these in its inner loop, and the compiler does not inline them next to code that
    // logs.
    [[gnu::always_inline]] double enter(const GridAxis& axis, int low, int high, std::int64_t base) const {
        if (side == 0) return -std::numeric_limits<double>::infinity();
        return lambdaAt(axis.edge(side > 0 ? low : high, base));
    }
    [[gnu::always_inline]] double leave(const GridAxis& axis, int low, int high, std::int64_t base) const {
        if (side == 0) return std::numeric_limits<double>::infinity();
        return lambdaAt(axis.edge(side > 0 ? high : low, base));
    }

    // The cell that contains the ray at, and just after, lambda = 0. A start on a line belongs to the cell that the ray
    // moves into; a ray that runs along a line belongs to the cell above it, floor(x).
    AxisCell startCell(const GridAxis& axis) const {
        const double whole = std::floor(start);
        const bool backwards = side < 0 && whole == start;
        if (!axis.wraps) {
            return {static_cast<int>(std::clamp(backwards ? whole - 1 : whole, 0.0, axis.cells - 1.0)), 0};
        }
        auto index = static_cast<std::int64_t>(whole) - (backwards ? 1 : 0);
        AxisCell cell;
        if (index < 0) {
            index += axis.cells;
            cell.base = -axis.cells;
        }
        cell.index = static_cast<int>(index);
        return cell;
    }

    // The cell that contains the ray at, and just after, lambda: estimated from the position, then corrected by the
    // comparisons that every walk makes.
    AxisCell cellAt(const GridAxis& axis, double lambda) const {
        if (side == 0) return startCell(axis);
        const double place = std::floor(start + lambda * run);
        AxisCell cell;
        if (!(lambda > 0)) {
            cell = startCell(axis);
        } else if (axis.wraps) {
            // So far off, doubles cannot distinguish neighbouring cells: any valid cell will do.
            constexpr double kFarthest = 0x1p62;
            const double reached = std::clamp(place, -kFarthest, kFarthest);
            cell.base = static_cast<std::int64_t>(std::floor(reached / axis.cells)) * axis.cells;
            // The quotient may be rounded to a whole period.
            cell.index = static_cast<int>(std::clamp(reached - static_cast<double>(cell.base), 0.0, axis.cells - 1.0));
        } else {
            cell.index = static_cast<int>(std::clamp(place, 0.0, axis.cells - 1.0));
        }
        constexpr int kRepairs = 4;  // the estimate is off by one cell at most
        for (int n = 0; n < kRepairs && leave(axis, cell.index, cell.index + 1, cell.base) <= lambda; ++n) {
            if (!stepCell(axis, side, cell)) return cell;
        }
        for (int n = 0; n < kRepairs && enter(axis, cell.index, cell.index + 1, cell.base) > lambda; ++n) {
            if (!stepCell(axis, -side, cell)) return cell;
        }
        return cell;
    }
};

// The cells of a height field, for its surface type and addressing.
struct CellGrid {
    GridAxis x;
    GridAxis y;
    bool bounded = false;  // border: outside the picture there is no surface

    CellGrid() = default;
    explicit CellGrid(const HeightField& field)
        : x(field.width(), field.surface(), field.address()),
          y(field.height(), field.surface(), field.address()),
          bounded(field.address() == Address::Border) {}
};

// Number of cells after which a ray flatter than the domain of exactness ends with Outcome::Limit.
inline constexpr double kFlatCells = 65536;

// A ray in cell coordinates.
struct GridRay {
    RayAxis x;
    RayAxis y;

    GridRay(const CellGrid& grid, const ViewRay& ray) : x(grid.x, ray.s0, ray.a), y(grid.y, ray.t0, ray.b) {}

    // Returns true for a ray that enters outside the closed picture under border; it is a miss.
    bool entersOutside(const CellGrid& grid) const {
        if (!grid.bounded) return false;
        return !(x.start >= grid.x.low && x.start <= grid.x.high && y.start >= grid.y.low && y.start <= grid.y.high);
    }
    // Lambda at which the ray leaves the slab, or under border the map if that comes first.
    double end(const CellGrid& grid) const {
        if (!grid.bounded) return 1;
        return std::min({1.0, x.leave(grid.x, 0, grid.x.cells, 0), y.leave(grid.y, 0, grid.y.cells, 0)});
    }
    // Returns true if the ray is no flatter than the domain of exactness (kMaxRun).
    bool inDomain() const { return x.run * x.run + y.run * y.run <= kMaxRun * kMaxRun; }
    // Upper bound of the number of cells crossed. Flatter rays stop after kFlatCells cells, since a million of them
    // would take days.
    double cellBound() const { return inDomain() ? std::abs(x.run) + std::abs(y.run) + 4 : kFlatCells; }
};

// The part of [0, 1] in which the ray is inside a box of cells. The ray crosses the box only if in < out: in every
// tracer, an interval of no length (a corner that is touched) does not count.
struct CellInterval {
    double in = 0;
    double out = 0;
};

}  // namespace relief
