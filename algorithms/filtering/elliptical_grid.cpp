#include "filtering/elliptical_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "filtering/grid_stages.h"

namespace relief {

namespace {

// Binary logarithms of a tile's sides in pixels. The tiles are those of frames (rendering/frame_buffers.h: 64 x 32), so
// that none is divided. With 64 x 64 and 128 x 64, frames took 1 to 6% longer (tests/benchmarks/EXPERIMENTS.md).
constexpr int kTileAcross = 6, kTileDown = 5;

// Returns true if all points that the pixels of a rectangle and their neighbours need lie in front of the horizon. Both
// sides of the comparison are monotone in x and in y, also in floating point, so the result for a rectangle agrees with
// that for each of its pixels.
bool beforeHorizon(const Homography& map, int x0, int y0, int x1, int y1) {
    // The points' reach may reduce q by at most this share, which leaves a quarter. The values 0.5 and 0.95 change
    // neither errors nor rays in the measurements described in grid_lanes.h.
    constexpr double kPartOfQ = 0.75;
    const double least = (grid::kTileHalo + 1) * (std::abs(map.qx) + std::abs(map.qy));
    const auto holds = [&](int x, int y) { return kPartOfQ * map.denominator(x + 0.5, y + 0.5) > least; };
    return holds(x0, y0) && holds(x1, y0) && holds(x0, y1) && holds(x1, y1);
}

}  // namespace

namespace grid {

namespace {

// The slots that the pixel sums, with their weights. A mean of centres' colours is listed as these centres.
std::vector<std::pair<std::size_t, float>> summedSlots(const PointLattice& lattice, const FilterQuery& query,
                                                       const TileCells& cells, const RestPoints& rest) {
    const std::size_t perCell = lattice.places.size(), row = cells.row();
    std::vector<std::pair<std::size_t, float>> slots;
    for (const PointLattice::Term& term : lattice.terms) {
        const std::size_t cell = cells.at(query.x + term.dx, query.y + term.dy);
        const auto k = static_cast<std::size_t>(term.point);
        if ((rest.needed[cell] >> k & 1) != 0) {
            slots.emplace_back(cell * perCell + k, term.weight);
            continue;
        }
        const std::size_t at = cell - static_cast<std::size_t>(lattice.squareOf(k, cells.width));
        const std::array<std::size_t, 4> corners{at, at + 1, at + row, at + row + 1};
        for (std::size_t n = 0; n < corners.size(); ++n) {
            slots.emplace_back(corners[n] * perCell, term.weight * static_cast<float>(lattice.shares[k][n]));
        }
    }
    return slots;
}

}  // namespace

const TilePixels& gatherPixels(const Run& run, std::size_t first, std::size_t last, glm::dvec2 scale,
                               Reused<TilePixels>& out, std::vector<std::size_t>& fallback) {
    const FilterBlock& block = run.block;
    TilePixels& tile = out.refill();
    const PixelView* view = block.view[first];
    int x0 = block.x[first], x1 = x0, y0 = block.y[first], y1 = y0;
    for (std::size_t i = first; i < last; ++i) {
        x0 = std::min(x0, block.x[i]), x1 = std::max(x1, block.x[i]);
        y0 = std::min(y0, block.y[i]), y1 = std::max(y1, block.y[i]);
    }
    constexpr int kSides = 2 * kTileHalo + 1;
    tile.cells = {view, scale, x0 - kTileHalo, y0 - kTileHalo, x1 - x0 + kSides, y1 - y0 + kSides};
    const HeightField& field = run.setup.tracer->field();
    // Plain filtering has the same limit. Factors of 1 and 10^6 change neither errors nor rays in the measurements
    // described in grid_lanes.h.
    const double largest = 4.0 * std::max(field.width(), field.height());
    const bool all = view != nullptr && beforeHorizon(view->texelFromScreen, x0, y0, x1, y1);
    const auto sidesOf = [&](std::size_t i) {
        return std::abs(block.ux[i]) + std::abs(block.uy[i]) + std::abs(block.vx[i]) + std::abs(block.vy[i]);
    };
    tile.indices.resize(last - first);
    std::size_t served = 0;
    for (std::size_t i = first; i < last; ++i) {
        const bool before = all || (view != nullptr && beforeHorizon(view->texelFromScreen, block.x[i], block.y[i],
                                                                     block.x[i], block.y[i]));
        tile.indices[served] = i;
        // Written so that NaN is not supported.
        const bool serves = before && block.exact[i] != 0 && sidesOf(i) < largest;
        served += serves ? 1 : 0;
        if (!serves) fallback.push_back(i);
    }
    tile.indices.resize(served);
    return tile;
}

const PlaneSplit& splitPixels(const Run& run, const TilePixels& pixels, const NearGround& ground,
                              Reused<PlaneSplit>& out) {
    const FilterBlock& block = run.block;
    PlaneSplit& split = out.refill();
    const std::size_t row = pixels.cells.row();
    const glm::dvec2 scale = pixels.cells.scale;
    split.edges.clear();
    split.planeOf.clear();
    if (split.planes.size() < pixels.indices.size()) split.planes.resize(pixels.indices.size());
    for (const std::size_t i : pixels.indices) {
        const std::size_t own = pixels.cells.at(block.x[i], block.y[i]);
        if ((ground.around[own] & kOnPlane) == 0) {
            split.edges.push_back(i);
            continue;
        }
        Jacobian j{block.ux[i], block.vx[i], block.uy[i], block.vy[i]};
        if ((ground.around[own] & kOnLevel) == 0) {
            const auto half = [&](const std::vector<double>& column, std::size_t way) {
                return 0.5 * (column[own + way] - column[own - way]);
            };
            const Centres& centres = ground.centres;
            j = {half(centres.s, 1), half(centres.t, 1), half(centres.s, row), half(centres.t, row)};
        }
        split.planes.place(split.planeOf.size(), glm::dvec2(block.s[i], block.t[i]) * scale, scaled(j, scale));
        split.planeOf.push_back(i);
    }
    return split;
}

void filterPlanes(Run& run, const PlaneSplit& split, SumWork& sum, std::span<Color> colors) {
    const EllipticalKernel& plain = run.setup.plain;
    reserve(sum.planes, split.planeOf.size());
    const FootprintCounts before = run.counts;
    if (run.log != nullptr && !split.planeOf.empty()) {
        const FilterQuery one = split.planes[0];
        sum.planes[0] = plain.filter(one.jacobian, one.place, run.counts, run.log);
        run.log->skipped = true;
    } else {
        plain.filter(split.planes, {1, 1}, {sum.planes.data(), split.planeOf.size()}, run.counts);
    }
    run.counts.skipped += run.counts.texels - before.texels;
    run.counts.flat += run.counts.footprints - before.footprints;
    for (std::size_t n = 0; n < split.planeOf.size(); ++n) colors[split.planeOf[n]] = sum.planes[n];
}

void sumEdges(Run& run, const EdgeGround& ground, const PlaneSplit& split, const PointColors& points, SumWork& sum,
              std::span<Color> colors) {
    const GridSetup& setup = run.setup;
    const FilterBlock& block = run.block;
    const TileCells& cells = ground.centres.cells;
    const auto perCell = static_cast<std::int32_t>(setup.lattice.places.size());
    sum.base.clear();
    for (const std::size_t i : split.edges) {
        sum.base.push_back(static_cast<std::int32_t>(cells.at(block.x[i], block.y[i])) * perCell);
    }
    sum.offset.clear();
    for (const PointLattice::Term& term : setup.lattice.terms) {
        sum.offset.push_back((term.dy * cells.width + term.dx) * perCell + term.point);
    }
    reserve(sum.sums, split.edges.size());
    sumPoints(points.slots.data(), sum.base, sum.offset, setup.lattice.weights, sum.sums);
    for (std::size_t n = 0; n < split.edges.size(); ++n) {
        const std::size_t i = split.edges[n];
        const auto& [red, green, blue, total] = sum.sums[n].channel;
        if (total > 0) {
            colors[i] = Color(red, green, blue) / total;
        } else {
            // No point hit the relief, although the pixel's own ray did.
            ++run.counts.allHidden;
            const glm::dvec2 place = glm::dvec2(block.s[i], block.t[i]) * cells.scale;
            colors[i] = setup.reader.levels().bilinear(0, place, setup.reader.address());
        }
    }
    run.counts.footprints += static_cast<std::int64_t>(split.edges.size());
}

void logEdge(Run& run, const EdgeGround& ground, const RestPoints& rest, const PointColors& points) {
    const GridSetup& setup = run.setup;
    const FilterQuery query = run.block[0];
    FootprintLog& log = *run.log;
    const TileCells& cells = ground.centres.cells;
    const glm::dvec2 own = query.place * cells.scale;
    log.footprint = setup.plain.footprint(scaled(query.jacobian, cells.scale), own);
    const double toLevel = std::ldexp(1.0, -log.footprint.level);
    float total = 0;
    for (const auto& [slot, weight] : summedSlots(setup.lattice, query, cells, rest)) {
        if (!(points.slots[slot].channel[3] > 0)) continue;
        total += weight;
        const auto point = std::find_if(points.read.begin(), points.read.end(),
                                        [slot = slot](const ReadPoint& one) { return one.slot == slot; });
        const PointTaps taps = setup.reader.taps(point->jacobian);
        const double size = std::ldexp(1.0, taps.level);
        for (int k = 0; k < taps.count; ++k) {
            const glm::dvec2 place = point->place + taps.offset(k);
            const BilinearSupport x = setup.plain.across(taps.level).support(place.x / size);
            const BilinearSupport y = setup.plain.down(taps.level).support(place.y / size);
            for (int c = 0; c < 4; ++c) {
                const bool right = c % 2 == 1, below = c / 2 == 1;
                FootprintTexel texel;
                texel.i = right ? x.second : x.first;
                texel.j = below ? y.second : y.first;
                texel.level = taps.level;
                const glm::dvec2 off{(right ? 1 : 0) - x.share, (below ? 1 : 0) - y.share};
                const glm::dvec2 at = log.footprint.centre + (place - own + size * off) * toLevel;
                texel.u = at.x, texel.v = at.y;
                texel.weight = Color(weight / static_cast<float>(taps.count) * (right ? x.share : 1 - x.share) *
                                     (below ? y.share : 1 - y.share));
                texel.tested = true;
                log.texels.push_back(texel);
            }
        }
    }
    log.allHidden = !(total > 0);
}

}  // namespace grid

// Buffers of one thread, reused from tile to tile.
struct GridKernel::Scratch {
    grid::Reused<grid::TilePixels> pixels;
    grid::Reused<grid::Centres> centres;
    grid::Reused<grid::BitColumn> around;
    grid::Reused<grid::PlaneSplit> split;
    grid::Reused<grid::PointPlan> plan;
    grid::Reused<grid::CentreColors> colors;
    grid::Reused<grid::RestPoints> rest;
    grid::SurveyWork survey;
    grid::PointWork points;
    grid::SumWork sum;
};

GridKernel::GridKernel(EllipticalKernel plain, PointReader reader, RaysKernel fallback,
                       std::shared_ptr<const Tracer> tracer, std::shared_ptr<const PackedConeHits> coneHits, int points)
    : setup_{std::move(plain),         std::move(reader), std::move(tracer), std::move(coneHits),
             PointLattice::of(points), boundsFor(points), std::nullopt},
      fallback_(std::move(fallback)) {
    const HeightField& field = setup_.tracer->field();
    if (field.surface() != Surface::Bilinear) return;
    setup_.slopes = setup_.coneHits ? SlopeScene(field, setup_.coneHits->cones()) : SlopeScene(field);
}

void GridKernel::filterTile(grid::Run& run, const grid::TilePixels& pixels, Scratch& scratch, std::span<Color> colors) {
    using namespace grid;
    Centres& centres = takeCentres(run, pixels, scratch.centres);
    const NearGround near = surveyPixels(run, pixels, centres, scratch.survey, scratch.around);
    const PlaneSplit& split = splitPixels(run, pixels, near, scratch.split);
    filterPlanes(run, split, scratch.sum, colors);
    if (split.edges.empty()) return;
    const EdgeGround ground = surveyEdges(run, split, near, scratch.survey);
    const PointPlan& plan = planPoints(run, split, ground, scratch.points, scratch.plan);
    CentreColors& centreColors = readCentres(run, ground, plan, scratch.points, scratch.colors);
    const RestPoints& rest = meanColors(run, ground, plan, centreColors, scratch.points, scratch.rest);
    const PointColors pointColors = readPoints(run, ground, plan, rest, centreColors, scratch.points);
    sumEdges(run, ground, split, pointColors, scratch.sum, colors);
    if (run.log == nullptr) return;
    run.log->color = colors[0];
    logEdge(run, ground, rest, pointColors);
}

void GridKernel::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                        Work& work, FootprintLog* log) const {
    static thread_local Scratch scratch;
    grid::Run run{setup_, block, counts, work, log};
    std::vector<std::size_t> fallbackPixels;
    for (std::size_t first = 0; first < block.size() && !work.stopped();) {
        std::size_t last = first;
        const auto same = [&](std::size_t i) {
            return block.view[i] == block.view[first] && block.x[i] >> kTileAcross == block.x[first] >> kTileAcross &&
                   block.y[i] >> kTileDown == block.y[first] >> kTileDown;
        };
        while (last < block.size() && same(last)) ++last;
        const grid::TilePixels& pixels = grid::gatherPixels(run, first, last, scale, scratch.pixels, fallbackPixels);
        if (!pixels.indices.empty()) filterTile(run, pixels, scratch, colors);
        first = last;
    }
    if (fallbackPixels.empty()) return;
    FilterBlock fallback;
    for (const std::size_t i : fallbackPixels) fallback.push(block[i]);
    std::vector<Color> found(fallbackPixels.size());
    fallback_.filter(fallback, scale, found, counts, work, log);
    for (std::size_t n = 0; n < fallbackPixels.size(); ++n) colors[fallbackPixels[n]] = found[n];
}

}  // namespace relief
