#include "relief/maps/cells_around.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace relief {

namespace {

// The largest component, along the axis towards `side`, of a unit direction of the sector; 0 if there is none.
double largestComponent(double begin, double end, bool alongX, int side) {
    const double middle = (alongX ? 0.0 : 0.5 * std::numbers::pi) + (side > 0 ? 0.0 : std::numbers::pi);
    for (const double turn : {0.0, 2 * std::numbers::pi}) {
        if (begin <= middle + turn && middle + turn <= end) return 1;
    }
    return std::max({std::cos(begin - middle), std::cos(end - middle), 0.0});
}

// The shortest distance within the sector to a cell that is `gap` away along the axis on that side; infinite if the
// sector has no direction that way. exactQuadrants: sector borders coincide with the axes, so that no sector has
// directions beyond an axis, not even by rounding.
double distanceAlong(int gap, int side, bool alongX, double begin, double end, bool exactQuadrants) {
    constexpr double kSectorSlack = 1e-12;  // the ends of sectors are rounded
    if (side == 0) return 0;
    const double component = largestComponent(begin, end, alongX, side);
    if (component <= kSectorSlack && exactQuadrants) return std::numeric_limits<double>::infinity();
    return gap / (component + kSectorSlack);
}

void intoTiles(CellsAround& all, int radius) {
    const auto tileOf = [&](int d) { return (d + radius) / kTile; };
    const auto order = [&](const CellAround& p) { return std::tuple(tileOf(p.dy), tileOf(p.dx), p.t); };
    std::stable_sort(all.cells.begin(), all.cells.end(),
                     [&](const CellAround& p, const CellAround& q) { return order(p) < order(q); });
    for (std::size_t n = 0; n < all.cells.size(); ++n) {
        const CellAround& cell = all.cells[n];
        const int dx = tileOf(cell.dx) * kTile - radius;
        const int dy = tileOf(cell.dy) * kTile - radius;
        if (all.tiles.empty() || all.tiles.back().dx != dx || all.tiles.back().dy != dy) {
            all.tiles.push_back({dx, dy, cell.t, 0, n, n});
        }
        all.tiles.back().end = n + 1;
        for (std::size_t i = cell.firstSeen; i < cell.endSeen; ++i) {
            all.tiles.back().stored |= std::uint32_t{1} << all.seen[i].stored;
        }
    }
    std::stable_sort(all.tiles.begin(), all.tiles.end(), [](const Tile& p, const Tile& q) { return p.t < q.t; });
}

}  // namespace

CellsAround cellsAround(int width, int height, int radius, const AzimuthSectors& sectors, int stored) {
    CellsAround all;
    const auto gap = [](int d, int size) { return std::max({0, d - size, -(d + 1)}); };
    const auto side = [](int d, int size) { return d < 0 ? -1 : (d >= size ? 1 : 0); };
    const bool exactQuadrants = sectors.count() % 4 == 0 && (stored == 1 || stored % 4 == 0);
    for (int dy = -radius; dy < height + radius; ++dy) {
        for (int dx = -radius; dx < width + radius; ++dx) {
            const double t = std::hypot(gap(dx, width), gap(dy, height));
            if (t > radius) continue;
            const std::size_t first = all.seen.size();
            const SectorSet set = sectors.meeting(dx - width, dx + 1, dy - height, dy + 1);
            for (int k = 0; k < sectors.count(); ++k) {
                if ((set >> k & 1U) == 0) continue;
                const double distance = std::max({t,
                                                  distanceAlong(gap(dx, width), side(dx, width), true, sectors.begin(k),
                                                                sectors.end(k), exactQuadrants),
                                                  distanceAlong(gap(dy, height), side(dy, height), false,
                                                                sectors.begin(k), sectors.end(k), exactQuadrants)});
                if (distance > radius) continue;
                all.seen.push_back({static_cast<std::uint8_t>(k),
                                    static_cast<std::uint8_t>(k * stored / sectors.count()), distance * distance});
            }
            all.cells.push_back({dx, dy, t, first, all.seen.size()});
        }
    }
    intoTiles(all, radius);
    return all;
}

FloatImage highestOfTiles(const FloatImage& cells, bool wraps) {
    const int before = wraps ? 0 : kTile - 1;
    FloatImage rows(cells.width() + before, cells.height());
    FloatImage tiles(cells.width() + before, cells.height() + before);
    const auto pass = [&](int n, int size, const auto& get, const auto& set) {
        for (int at = 0; at < n; ++at) {
            float highest = 0;
            for (int i = at - before; i < at - before + kTile; ++i) {
                if (wraps || (i >= 0 && i < size)) highest = std::max(highest, get(wraps ? i % size : i));
            }
            set(at, highest);
        }
    };
    for (int y = 0; y < cells.height(); ++y) {
        pass(
            rows.width(), cells.width(), [&](int i) { return cells(i, y); },
            [&](int at, float highest) { rows(at, y) = highest; });
    }
    for (int x = 0; x < tiles.width(); ++x) {
        pass(
            tiles.height(), cells.height(), [&](int i) { return rows(x, i); },
            [&](int at, float highest) { tiles(x, at) = highest; });
    }
    return tiles;
}

}  // namespace relief
