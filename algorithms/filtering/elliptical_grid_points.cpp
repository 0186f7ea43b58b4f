// The points that pixels at edges sum: which, and what they meet.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "filtering/grid_follow.h"
#include "filtering/grid_tile.h"
#include "relief/block_work.h"
#include "relief/methods/look_up_point.h"

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

// And the centres round all points that are asked for.
void GridKernel::askCentres(Tile& tile) const {
    const auto row = static_cast<std::ptrdiff_t>(tile.width);
    const std::size_t cells = tile.cells(), reach = static_cast<std::size_t>(row + 1);
    tile.even.assign(cells, 0);
    std::uint16_t* centres = tile.even.data();
    for (std::size_t k = 1; k < lattice_.places.size(); ++k) {
        // A square's corners lie before it and in the row above.
        const std::uint16_t* own = tile.asked.data() + lattice_.squareOf(k, row);
        const std::uint16_t* above = own - row;
        for (std::size_t c = reach; c < cells - reach; ++c) {
            const auto here = static_cast<std::ptrdiff_t>(c);
            const int any = own[here] | own[here - 1] | above[here] | above[here - 1];
            centres[c] |= static_cast<std::uint16_t>(any >> k & 1);
        }
    }
    for (std::size_t c = 0; c < cells; ++c) tile.asked[c] |= centres[c];
}

// Bits of the points in each cell that the edges sum, and of those whose footprints follow from the centres'.
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
    tile.asked.assign(cells + kCellSlack, 0);
    tile.follows.assign(cells + kCellSlack, 0);
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
    askCentres(tile);
    findWhole(tile);
    // Centres on straight ground, or on smooth ground near them, have footprints by their neighbours.
    constexpr unsigned kCross = (1U << kAcross) | (1U << kDown);
    for (std::size_t c = 0; c < cells; ++c) {
        const unsigned around = tile.around[c];
        const unsigned lines = (around / kStraight) | ((around & kNearAround) != 0 ? around : 0);
        tile.follows[c] = (lines & kCross) == kCross ? 1 : 0;
    }
    for (std::size_t k = 1; k < lattice_.places.size(); ++k) {
        const std::uint16_t* whole = tile.whole.data() - lattice_.squareOf(k, row);
        std::uint16_t* follows = tile.follows.data();
        const auto bit = static_cast<std::uint16_t>(1U << k);
        for (std::size_t c = reach; c < cells - reach; ++c) follows[c] |= static_cast<std::uint16_t>(whole[c] & bit);
    }
}

// The tile's cells in the order in which points are traced.
void GridKernel::orderCells(Tile& tile) {
    if (tile.orderWidth == tile.width && tile.orderHeight == tile.height) return;
    tile.orderWidth = tile.width, tile.orderHeight = tile.height;
    tile.order.clear();
    tile.overCells([&](std::size_t cell, int x, int y) {
        tile.order.push_back({static_cast<std::uint32_t>(cell), static_cast<std::int32_t>(x - tile.x0),
                              static_cast<std::int32_t>(y - tile.y0)});
    });
}

// Behind tile.points, without what they meet, the k-th points of the cells for which wanted(cell).
template <class Wanted>
void GridKernel::pushPoints(Tile& tile, std::size_t k, const Wanted& wanted) const {
    std::vector<std::uint32_t>& which = tile.which;
    reserve(which, tile.order.size() + 1);
    std::size_t count = 0;
    for (std::size_t n = 0; n < tile.order.size(); ++n) {
        which[count] = static_cast<std::uint32_t>(n);
        count += wanted(tile.order[n].cell) ? 1 : 0;
    }
    GridPoints& out = tile.points;
    out.reserve(count);
    const auto points = static_cast<std::uint32_t>(lattice_.places.size());
    const glm::dvec2 off = lattice_.places[k];
    for (std::size_t n = 0; n < count; ++n) {
        const OrderedCell& cell = tile.order[which[n]];
        out.slots[out.count + n] = cell.cell * points + static_cast<std::uint32_t>(k);
        out.x[out.count + n] = tile.x0 + cell.x + 0.5 + off.x;
        out.y[out.count + n] = tile.y0 + cell.y + 0.5 + off.y;
    }
    out.count += count;
}

// Behind `out` those k-th points whose hits follow from the centres', with their slots in tile.slots.
void GridKernel::follow(Tile& tile, std::size_t k, PointBlock& out) const {
    const auto row = static_cast<std::size_t>(tile.width), reach = row + 1;
    const auto square = static_cast<std::size_t>(lattice_.squareOf(k, tile.width));
    followPoints(
        {tile.s.data(), tile.t.data(), row, reach, tile.cells() - reach, tile.asked.data(), tile.follows.data(), k,
         lattice_.places.size(), square, lattice_.shares[k], lattice_.blur, tile.scale},
        out, tile.slots);
}

// The centres that are asked for, with their colours.
void GridKernel::takeCentres(Tile& tile, FootprintCounts& counts) const {
    orderCells(tile);
    tile.footprints.resize(0);
    follow(tile, 0, tile.footprints);
    tile.points.clear();
    const auto points = static_cast<std::uint32_t>(lattice_.places.size());
    pushPoints(tile, 0, [&](std::size_t cell) {
        if ((tile.asked[cell] & ~tile.follows[cell] & 1) == 0) return false;
        const bool met = !std::isnan(tile.s[cell]);
        if (!met) tile.color[cell * points] = {};
        return met;
    });
    GridPoints& met = tile.points;
    for (std::size_t n = 0; n < met.count; ++n) {
        const std::size_t cell = met.slots[n] / points;
        met.lambda[n] = tile.lambda[cell], met.s[n] = tile.s[cell], met.t[n] = tile.t[cell];
    }
    layPoints(tile);
    readPoints(tile, counts);
    std::array<float*, 3> columns{};
    for (std::size_t c = 0; c < columns.size(); ++c) {
        reserve(tile.centre[c], tile.cells() + kCellSlack);
        columns[c] = tile.centre[c].data();
    }
    splitCentres(tile.color.data(), points, tile.asked.data(), tile.cells() + 1, columns);
}

// The points whose colours follow from the centres': no longer asked for.
void GridKernel::takeMeans(Tile& tile) const {
    const std::size_t points = lattice_.places.size(), cells = tile.cells();
    const auto row = static_cast<std::size_t>(tile.width), reach = row + 1;
    tile.even.resize(cells + kCellSlack);
    tile.mean.assign(cells, 0);
    findEven({tile.centre[0].data(), tile.centre[1].data(), tile.centre[2].data()}, row, cells - reach, bounds_,
             tile.even.data());
    for (std::size_t k = 1; k < points; ++k) {
        const std::ptrdiff_t square = lattice_.squareOf(k, tile.width);
        const auto bit = static_cast<std::uint16_t>(1U << k);
        std::array<float, 4> share;
        for (std::size_t n = 0; n < share.size(); ++n) share[n] = static_cast<float>(lattice_.shares[k][n]);
        for (std::size_t c = reach; c < cells - reach; ++c) {
            const auto at = c - static_cast<std::size_t>(square);
            if ((tile.asked[c] & tile.even[at] & bit) == 0) continue;
            tile.mean[c] |= bit;
            const PointColor* p = tile.color.data() + at * points;
            const PointColor *q = p + points, *r = p + row * points, *s = r + points;
            PointColor& out = tile.color[c * points + k];
            for (std::size_t n = 0; n < 4; ++n) {
                out.channel[n] = (share[0] * p->channel[n] + share[1] * q->channel[n]) +
                                 (share[2] * r->channel[n] + share[3] * s->channel[n]);
            }
        }
    }
    for (std::size_t c = 0; c < cells; ++c) tile.asked[c] &= static_cast<std::uint16_t>(~tile.mean[c]);
}

// The other points that the edges sum, with what they meet; tile.points has those that meet something.
void GridKernel::takePoints(Tile& tile, FootprintCounts& counts, Work& work) const {
    tile.points.clear();
    for (std::size_t k = 1; k < lattice_.places.size(); ++k) {
        pushPoints(tile, k, [&](std::size_t cell) { return (tile.asked[cell] & ~tile.follows[cell]) >> k & 1; });
    }
    tracePoints(tile, counts, work);
    tile.footprints.resize(0);
    layPoints(tile);
    for (std::size_t k = 1; k < lattice_.places.size(); ++k) follow(tile, k, tile.footprints);
    readPoints(tile, counts);
}

// What tile.points meet; without those that meet nothing.
void GridKernel::tracePoints(Tile& tile, FootprintCounts& counts, Work& work) const {
    GridPoints& points = tile.points;
    const auto copy = [](const std::vector<double>& from, std::vector<double>& to, std::size_t begin) {
        std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(begin));
    };
    const HeightField& field = tracer_->field();
    bool missed = false;
    for (std::size_t begin = 0; begin < points.count; begin += kRayGrain) {
        const std::size_t count = std::min(kRayGrain, points.count - begin);
        tile.rays.resize(count);
        raysThrough(*tile.view, part(points.x, begin, count), part(points.y, begin, count), tile.rays, 0);
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
    }
    counts.tested += static_cast<std::int64_t>(points.count);
    if (missed) points.filter([&](std::size_t n) { return !std::isnan(points.s[n]); });
}

}  // namespace relief
