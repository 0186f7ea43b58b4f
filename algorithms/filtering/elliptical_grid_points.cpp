// The points that pixels at edges sum: which, and what they meet.
#include <algorithm>
#include <bit>
#include <cmath>

#include "filtering/grid_tile.h"
#include "relief/block_work.h"
#include "relief/look_up_point.h"

namespace relief {

// Of each cell, whether hits within the square of its centre and those to the right of and below it can be taken from
// these four: if none of the six lines between them crosses an edge. Both ends lie on it smoothly, or one end goes
// straight on to the other.
void GridKernel::findWhole(Tile& tile) const {
    const auto row = static_cast<std::size_t>(tile.width);
    const std::size_t last = tile.cells() - row - 1;
    tile.whole.assign(tile.cells(), 0);
    const std::uint16_t* a = tile.around.data();
    std::uint16_t* whole = tile.whole.data();
    const auto joined = [](unsigned p, unsigned q, unsigned line) {
        return (p & q & (unsigned{kSmooth} << line)) | (((p | q) & (unsigned{kStraight} << line)) / kStraight);
    };
    for (std::size_t c = 0; c < last; ++c) {
        const unsigned p = a[c], q = a[c + 1], r = a[c + row], s = a[c + row + 1];
        const unsigned lines = (joined(p, q, kAcross) & joined(r, s, kAcross)) |
                               (joined(p, r, kDown) & joined(q, s, kDown)) | joined(p, s, kFalling) |
                               joined(r, q, kRising);
        whole[c] = lines == kAllLines ? 0xFFFF : 0;
    }
}

// Bits of the points in each cell that the edges sum, and of those whose hits follow from the centres'.
void GridKernel::askPoints(const FilterBlock& block, Tile& tile) const {
    const auto row = static_cast<std::ptrdiff_t>(tile.width);
    const auto points = static_cast<std::int32_t>(lattice_.places.size());
    const std::size_t cells = tile.cells();
    tile.edge.assign(cells, 0);
    tile.base.clear();
    for (const std::size_t i : tile.edges) {
        const std::size_t cell = tile.cell(block.x[i], block.y[i]);
        tile.edge[cell] = 0xFFFF;
        tile.base.push_back(static_cast<std::int32_t>(cell) * points);
    }
    tile.offset.clear();
    tile.asked.assign(cells, 0);
    tile.follows.assign(cells, 1);
    // Edges keep kTileHalo cells from the rim.
    const auto reach = static_cast<std::size_t>(row + 1);
    for (const PointLattice::Term& term : lattice_.terms) {
        const std::ptrdiff_t off = term.dy * row + term.dx;
        tile.offset.push_back(static_cast<std::int32_t>(off) * points + term.point);
        const std::uint16_t* edge = tile.edge.data() - off;
        std::uint16_t* asked = tile.asked.data();
        const auto bit = static_cast<std::uint16_t>(1U << term.point);
        for (std::size_t c = reach; c < cells - reach; ++c) asked[c] |= static_cast<std::uint16_t>(edge[c] & bit);
    }
    findWhole(tile);
    for (std::size_t k = 1; k < lattice_.places.size(); ++k) {
        const std::uint16_t* whole = tile.whole.data() - lattice_.squareOf(k, row);
        std::uint16_t* follows = tile.follows.data();
        const auto bit = static_cast<std::uint16_t>(1U << k);
        for (std::size_t c = reach; c < cells - reach; ++c) follows[c] |= static_cast<std::uint16_t>(whole[c] & bit);
    }
}

// The hit of a point that follows from the centres': its own, or between the four round it. False: there is none.
bool GridKernel::follow(Tile& tile, std::size_t cell, std::size_t k) const {
    GridPoints& out = tile.others;
    if (k == 0) {
        if (std::isnan(tile.s[cell])) return false;
        out.lambda.push_back(tile.lambda[cell]);
        out.s.push_back(tile.s[cell]), out.t.push_back(tile.t[cell]);
        return true;
    }
    const auto row = static_cast<std::size_t>(tile.width);
    const std::size_t c00 = cell - static_cast<std::size_t>(lattice_.squareOf(k, tile.width));
    const glm::dvec2 off = lattice_.places[k];
    const double u = off.x < 0 ? off.x + 1 : off.x, v = off.y < 0 ? off.y + 1 : off.y;
    const auto mean = [&](const std::vector<double>& column) {
        const double top = (1 - u) * column[c00] + u * column[c00 + 1];
        const double bottom = (1 - u) * column[c00 + row] + u * column[c00 + row + 1];
        return (1 - v) * top + v * bottom;
    };
    out.lambda.push_back(mean(tile.lambda));
    out.s.push_back(mean(tile.s)), out.t.push_back(mean(tile.t));
    return true;
}

// The points that the edges sum: tile.points, whose hits are not known, and tile.others.
void GridKernel::wantPoints(const FilterBlock& block, Tile& tile) const {
    askPoints(block, tile);
    const std::size_t points = lattice_.places.size();
    tile.points.clear();
    tile.others.clear();
    tile.overCells([&](std::size_t cell, int x, int y) {
        for (unsigned asked = tile.asked[cell]; asked != 0; asked &= asked - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(asked));
            const std::size_t slot = cell * points + k;
            const glm::dvec2 off = lattice_.places[k], at{x + 0.5 + off.x, y + 0.5 + off.y};
            if ((tile.follows[cell] >> k & 1U) == 0) {
                tile.points.push(static_cast<std::uint32_t>(slot), at);
            } else if (follow(tile, cell, k)) {
                tile.others.push(static_cast<std::uint32_t>(slot), at);
            } else {
                tile.color[slot] = {};
            }
        }
    });
}

// tile.points: traced, and the others behind them; those that meet nothing are left out.
void GridKernel::tracePoints(Tile& tile, FootprintCounts& counts, Work& work) const {
    GridPoints& points = tile.points;
    GridPoints& others = tile.others;
    for (auto* of : {&points, &others}) {
        of->a.resize(of->size());
        of->b.resize(of->size());
    }
    for (auto* column : {&points.lambda, &points.s, &points.t}) column->resize(points.size());
    const auto copy = [](const std::vector<double>& from, std::vector<double>& to, std::size_t begin) {
        std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(begin));
    };
    const auto inParts = [&](GridPoints& of, const auto& body) {
        for (std::size_t begin = 0; begin < of.size(); begin += kRayGrain) {
            const std::size_t count = std::min(kRayGrain, of.size() - begin);
            tile.rays.resize(count);
            raysThrough(*tile.view, part(of.x, begin, count), part(of.y, begin, count), tile.rays, 0);
            copy(tile.rays.a, of.a, begin);
            copy(tile.rays.b, of.b, begin);
            body(begin, count);
        }
    };
    const HeightField& field = tracer_->field();
    bool missed = false;
    inParts(points, [&](std::size_t begin, std::size_t count) {
        trace(tile, work);
        if (field.surface() == Surface::Columns) {
            for (std::size_t n = 0; n < count; ++n) {
                const glm::dvec2 place = lookUpPoint(field, tile.rays[n], tile.hits[n]);
                tile.hits.s[n] = place.x, tile.hits.t[n] = place.y;
            }
        }
        copy(tile.hits.lambda, points.lambda, begin);
        copy(tile.hits.s, points.s, begin);
        copy(tile.hits.t, points.t, begin);
        for (std::size_t n = 0; n < count; ++n) {
            if (tile.hits.outcome[n] == Outcome::Hit) continue;
            missed = true;
            points.s[begin + n] = kNothing;
            tile.color[points.slots[begin + n]] = {};
        }
    });
    counts.tested += static_cast<std::int64_t>(points.size());
    if (missed) points.filter([&](std::size_t n) { return !std::isnan(points.s[n]); });
    inParts(others, [](std::size_t, std::size_t) {});
    points.append(others);
}

}  // namespace relief
