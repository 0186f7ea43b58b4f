// The points that edge pixels sum: which points, their hits, and their colours.
#include <algorithm>
#include <cmath>

#include "filtering/grid_stages.h"
#include "relief/block_work.h"

namespace relief::grid {

namespace {

// Appends the k-th points that are needed and not interpolated, row by row.
void addPlaces(const PointLattice& lattice, const TileCells& cells, const BitColumn& needed,
               const BitColumn& interpolated, std::size_t k, Places& out) {
    for (std::size_t first = 0; first < cells.count(); first += cells.row()) {
        out.reserve(cells.row() + kPointSlack);
        const int y = cells.y0 + static_cast<int>(first / cells.row());
        const PlacesJob job{needed.data() + first,
                            interpolated.data() + first,
                            k,
                            lattice.places.size(),
                            cells.row(),
                            first,
                            cells.x0 + 0.5,
                            lattice.places[k].x,
                            y + 0.5 + lattice.places[k].y};
        out.count += listPlaces(job, out.x.data() + out.count, out.y.data() + out.count, out.slots.data() + out.count);
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

}  // namespace

const PointPlan& planPoints(const Run& run, const PlaneSplit& split, const EdgeGround& ground, PointWork& points,
                            Reused<PointPlan>& out) {
    PointPlan& plan = out.refill();
    const TileCells& cells = ground.centres.cells;
    const PointLattice& lattice = run.setup.lattice;
    planCells({lattice, run.block, split.edges(), cells, ground.around}, points.mask, plan);
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
    addPlaces(lattice, cells, plan.needed, plan.interpolated, 0, places);
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
        MeanJob job{square, cells.row(), perCell, k, {}};
        for (std::size_t n = 0; n < job.share.size(); ++n) job.share[n] = static_cast<float>(lattice.shares[k][n]);
        meanUniform(job, cells.inner(), last, uniform.data(), rest.needed.data(), colors.slots.data());
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
        addPlaces(lattice, cells, rest.needed, plan.interpolated, k, places);
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
