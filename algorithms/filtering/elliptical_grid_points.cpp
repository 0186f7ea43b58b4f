// The points that edge pixels sum: which points, their hits, and their colours.
#include <algorithm>
#include <array>
#include <cmath>

#include "filtering/grid_stages.h"
#include "relief/block_work.h"

namespace relief::grid {

namespace {

// Sets the point's bit in each cell with eight neighbours for which the cell `off` entries before it has that bit in
// mask.
void takeBit(const TileCells& cells, const BitColumn& mask, std::ptrdiff_t off, std::size_t point, BitColumn& out) {
    const std::uint16_t* from = mask.data() - off;
    const auto bit = static_cast<std::uint16_t>(1U << point);
    for (std::size_t c = cells.inner(); c < cells.count() - cells.inner(); ++c)
        out[c] |= static_cast<std::uint16_t>(from[c] & bit);
}

// Sets the bits of the points that any edge pixel sums. Edge pixels are at least kTileHalo cells from the border. mask:
// scratch memory.
void markSummed(const PointLattice& lattice, const FilterBlock& block, std::span<const std::size_t> edges,
                const TileCells& cells, BitColumn& mask, BitColumn& needed) {
    mask.assign(cells.count(), 0);
    for (const std::size_t i : edges) mask[cells.at(block.x[i], block.y[i])] = 0xFFFF;
    for (const PointLattice::Term& term : lattice.terms) {
        const int off = term.dy * cells.width + term.dx;
        takeBit(cells, mask, off, static_cast<std::size_t>(term.point), needed);
    }
}

// Adds the four centres around each such point. mask: scratch memory.
void addCentres(const PointLattice& lattice, const TileCells& cells, BitColumn& mask, BitColumn& needed) {
    mask.assign(cells.count(), 0);
    for (std::size_t k = 1; k < lattice.places.size(); ++k) {
        // The cells whose squares have this centre as a corner: the centre's own, the one to its left, and the two
        // above.
        const std::uint16_t* own = needed.data() + lattice.squareOf(k, cells.width);
        const std::uint16_t* above = own - cells.width;
        for (std::size_t c = cells.inner(); c < cells.count() - cells.inner(); ++c) {
            const auto here = static_cast<std::ptrdiff_t>(c);
            const int any = own[here] | own[here - 1] | above[here] | above[here - 1];
            mask[c] |= static_cast<std::uint16_t>(any >> k & 1);
        }
    }
    for (std::size_t c = 0; c < cells.count(); ++c) needed[c] |= mask[c];
}

// Sets all bits or none of each cell: whether hits within the square between its centre and the centres to the right,
// below and diagonally below can be interpolated from these four. They can if none of the six lines between the four
// crosses an edge, that is if each line is smooth at both ends or straight at one end.
void joinSquares(const TileCells& cells, const BitColumn& around, BitColumn& joined) {
    const std::size_t row = cells.row();
    joined.assign(cells.count(), 0);
    std::uint16_t* out = joined.data();
    const auto join = [](unsigned p, unsigned q, unsigned line) {
        return (p & q & (unsigned{kSmooth} << line)) | (((p | q) & (unsigned{kStraight} << line)) / kStraight);
    };
    for (std::size_t c = 0; c < cells.count() - cells.inner(); ++c) {
        const unsigned p = around[c], q = around[c + 1], r = around[c + row], s = around[c + row + 1];
        const unsigned lines = (join(p, q, kAcross) & join(r, s, kAcross)) | (join(p, r, kDown) & join(q, s, kDown)) |
                               join(p, s, kFalling) | join(r, q, kRising);
        out[c] = lines == kAllLines ? 0xFFFF : 0;
    }
}

// Sets a bit for each point whose hit is interpolated from centres; for a centre, whose footprint is.
void markInterpolated(const PointLattice& lattice, const TileCells& cells, const BitColumn& around,
                      const BitColumn& joined, BitColumn& interpolated) {
    // A centre's footprint follows from its neighbours if the horizontal and the vertical line through it are straight,
    // or smooth with nearby hits.
    constexpr unsigned kCross = (1U << kAcross) | (1U << kDown);
    for (std::size_t c = 0; c < cells.count(); ++c) {
        const unsigned lines = (around[c] / kStraight) | ((around[c] & kNearAround) != 0 ? around[c] : 0U);
        interpolated[c] = (lines & kCross) == kCross ? 1 : 0;
    }
    for (std::size_t k = 1; k < lattice.places.size(); ++k)
        takeBit(cells, joined, lattice.squareOf(k, cells.width), k, interpolated);
}

// Appends the k-th points that are needed and not interpolated, row by row. which: scratch memory.
void addPlaces(const PointLattice& lattice, const TileCells& cells, const BitColumn& needed,
               const BitColumn& interpolated, std::size_t k, std::vector<std::int32_t>& which, Places& out) {
    reserve(which, cells.row() + 1);
    const std::size_t perCell = lattice.places.size();
    for (std::size_t y = 0; y * cells.row() < cells.count(); ++y) {
        const std::size_t first = y * cells.row();
        // Compaction without a branch, because which cells are selected is unpredictable.
        std::size_t count = 0;
        for (std::size_t x = 0; x < cells.row(); ++x) {
            which[count] = static_cast<std::int32_t>(x);
            count += static_cast<std::size_t>((needed[first + x] & ~interpolated[first + x]) >> k & 1);
        }
        out.reserve(count);
        const double placeY = cells.y0 + static_cast<int>(y) + 0.5 + lattice.places[k].y;
        for (std::size_t n = 0; n < count; ++n, ++out.count) {
            const std::size_t cell = first + static_cast<std::size_t>(which[n]);
            out.slots[out.count] = static_cast<std::uint32_t>(cell * perCell + k);
            out.x[out.count] = cells.x0 + which[n] + 0.5 + lattice.places[k].x;
            out.y[out.count] = placeY;
        }
    }
}

// Appends the footprints of the k-th points that are needed and interpolated.
void addInterpolated(const PointLattice& lattice, const Centres& centres, const BitColumn& needed,
                     const BitColumn& interpolated, std::size_t k, Footprints& out) {
    const TileCells& cells = centres.cells;
    const auto square = static_cast<std::size_t>(lattice.squareOf(k, cells.width));
    followPoints(
        {centres.s.data(), centres.t.data(), cells.row(), cells.inner(), cells.count() - cells.inner(), needed.data(),
         interpolated.data(), k, lattice.places.size(), square, lattice.shares[k], lattice.blur, cells.scale},
        out.block, out.slots);
}

// Appends the footprints of the places [begin, begin + count), whose hits are [0, count). Entries without a hit are
// removed by moving the later ones forward.
void addHits(const GridSetup& setup, const TileCells& cells, Places& places, std::size_t begin, std::size_t count,
             HitBlock& hits, Footprints& out) {
    std::size_t met = 0;
    for (std::size_t n = 0; n < count; ++n) {
        if (hits.outcome[n] != Outcome::Hit) {
            out.missed.push_back(places.slots[begin + n]);
            continue;
        }
        if (met < n) {
            places.slots[begin + met] = places.slots[begin + n];
            places.x[begin + met] = places.x[begin + n], places.y[begin + met] = places.y[begin + n];
            hits.lambda[met] = hits.lambda[n], hits.s[met] = hits.s[n], hits.t[met] = hits.t[n];
        }
        ++met;
    }
    const std::size_t before = out.block.size();
    const auto part = [&](const std::vector<double>& of, std::size_t from) { return std::span(of).subspan(from, met); };
    layFootprints(
        *cells.view, setup.slopes ? &*setup.slopes : nullptr, setup.lattice.blur, cells.scale,
        {part(places.x, begin), part(places.y, begin), part(hits.lambda, 0), part(hits.s, 0), part(hits.t, 0)},
        out.block);
    reserve(out.slots, out.block.size());
    std::copy_n(places.slots.data() + begin, met, out.slots.data() + before);
}

// Samples the colours of the footprints and stores them in their slots.
void read(Run& run, const Footprints& footprints, CentreColors& colors) {
    for (const std::uint32_t slot : footprints.missed) colors.slots[slot] = {};
    const PointBlock& block = footprints.block;
    run.setup.reader.read(block, {footprints.slots.data(), block.size()}, colors.slots.data(), run.counts);
    if (run.log == nullptr) return;
    for (std::size_t n = 0; n < block.size(); ++n) {
        colors.read.push_back({footprints.slots[n], {block.s[n], block.t[n]}, block.jacobian(n)});
    }
}

// The weighted mean of four centres' colours; `at` is the cell of the upper left one.
PointColor meanColor(const std::vector<PointColor>& slots, std::size_t at, std::size_t row, std::size_t perCell,
                     const std::array<float, 4>& share) {
    const PointColor* p = slots.data() + at * perCell;
    const PointColor *q = p + perCell, *r = p + row * perCell, *s = r + perCell;
    PointColor mean;
    for (std::size_t n = 0; n < 4; ++n) {
        mean.channel[n] = (share[0] * p->channel[n] + share[1] * q->channel[n]) +
                          (share[2] * r->channel[n] + share[3] * s->channel[n]);
    }
    return mean;
}

}  // namespace

const PointPlan& planPoints(const Run& run, const PlaneSplit& split, const EdgeGround& ground, PointWork& points,
                            Reused<PointPlan>& out) {
    PointPlan& plan = out.refill();
    const TileCells& cells = ground.centres.cells;
    const PointLattice& lattice = run.setup.lattice;
    for (auto* column : {&plan.needed, &plan.interpolated}) column->assign(cells.count() + kCellSlack, 0);
    markSummed(lattice, run.block, split.edges, cells, points.mask, plan.needed);
    addCentres(lattice, cells, points.mask, plan.needed);
    joinSquares(cells, ground.around, points.mask);
    markInterpolated(lattice, cells, ground.around, points.mask, plan.interpolated);
    return plan;
}

CentreColors& readCentres(Run& run, const EdgeGround& ground, const PointPlan& plan, PointWork& points,
                          Reused<CentreColors>& out) {
    const PointLattice& lattice = run.setup.lattice;
    const Centres& centres = ground.centres;
    const TileCells& cells = centres.cells;
    const std::size_t perCell = lattice.places.size();
    Footprints& footprints = points.footprints;
    footprints.block.resize(0), footprints.missed.clear();
    addInterpolated(lattice, centres, plan.needed, plan.interpolated, 0, footprints);
    Places& places = points.places;
    places.count = 0;
    addPlaces(lattice, cells, plan.needed, plan.interpolated, 0, points.which, places);
    HitBlock& hits = points.centreHits;
    if (hits.size() < places.count) hits.resize(places.count);
    for (std::size_t n = 0; n < places.count; ++n) {
        const std::size_t cell = places.slots[n] / perCell;
        const Outcome outcome = std::isnan(centres.s[cell]) ? Outcome::Miss : Outcome::Hit;
        hits.set(n, {outcome, centres.lambda[cell], centres.s[cell], centres.t[cell]});
    }
    addHits(run.setup, cells, places, 0, places.count, hits, footprints);
    CentreColors& colors = out.refill();
    reserve(colors.slots, (cells.count() + kCellSlack) * perCell);
    colors.read.clear();
    read(run, footprints, colors);
    for (auto& column : colors.channel) reserve(column, cells.count() + kCellSlack);
    auto& [red, green, blue] = colors.channel;
    splitCentres(colors.slots.data(), perCell, plan.needed.data(), cells.count() + 1,
                 {red.data(), green.data(), blue.data()});
    return colors;
}

const RestPoints& meanColors(const Run& run, const EdgeGround& ground, const PointPlan& plan, CentreColors& colors,
                             PointWork& points, Reused<RestPoints>& out) {
    RestPoints& rest = out.refill();
    const TileCells& cells = ground.centres.cells;
    const PointLattice& lattice = run.setup.lattice;
    const std::size_t perCell = lattice.places.size(), last = cells.count() - cells.inner();
    BitColumn& uniform = points.mask;
    uniform.resize(cells.count() + kCellSlack);
    const auto& [red, green, blue] = colors.channel;
    findUniform({red.data(), green.data(), blue.data()}, cells.row(), last, run.setup.bounds, uniform.data());
    rest.needed = plan.needed;
    for (std::size_t k = 1; k < perCell; ++k) {
        const auto square = static_cast<std::size_t>(lattice.squareOf(k, cells.width));
        const auto bit = static_cast<std::uint16_t>(1U << k);
        std::array<float, 4> share;
        for (std::size_t n = 0; n < share.size(); ++n) share[n] = static_cast<float>(lattice.shares[k][n]);
        for (std::size_t c = cells.inner(); c < last; ++c) {
            if ((plan.needed[c] & uniform[c - square] & bit) == 0) continue;
            rest.needed[c] &= static_cast<std::uint16_t>(~bit);
            colors.slots[c * perCell + k] = meanColor(colors.slots, c - square, cells.row(), perCell, share);
        }
    }
    return rest;
}

PointColors readPoints(Run& run, const EdgeGround& ground, const PointPlan& plan, const RestPoints& rest,
                       CentreColors& colors, PointWork& points) {
    const PointLattice& lattice = run.setup.lattice;
    const TileCells& cells = ground.centres.cells;
    Footprints& footprints = points.footprints;
    footprints.block.resize(0), footprints.missed.clear();
    Places& places = points.places;
    places.count = 0;
    for (std::size_t k = 1; k < lattice.places.size(); ++k)
        addPlaces(lattice, cells, rest.needed, plan.interpolated, k, points.which, places);
    for (std::size_t begin = 0; begin < places.count; begin += kRayGrain) {
        const std::size_t count = std::min(kRayGrain, places.count - begin);
        traceBatch(run, *cells.view, places, begin, count, points.batch);
        addHits(run.setup, cells, places, begin, count, points.batch.hits, footprints);
    }
    for (std::size_t k = 1; k < lattice.places.size(); ++k)
        addInterpolated(lattice, ground.centres, rest.needed, plan.interpolated, k, footprints);
    read(run, footprints, colors);
    return {colors.slots, colors.read};
}

}  // namespace relief::grid
