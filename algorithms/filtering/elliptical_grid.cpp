#include "filtering/elliptical_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
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

// Splits the pixels of the indices into runs of consecutive cells, each at most as long as a row of a tile.
void findRuns(const FilterBlock& block, std::span<const std::size_t> indices, std::vector<PixelRun>& runs) {
    constexpr std::size_t kMostRun = std::size_t{1} << kTileAcross;
    runs.clear();
    for (std::size_t n = 0; n < indices.size();) {
        const std::size_t first = indices[n], most = std::min(kMostRun, indices.size() - n);
        const int x = block.x[first], y = block.y[first];
        // Most runs end with a row of the tile, so the whole row is compared without a branch.
        std::size_t count = std::min(most, kMostRun - (static_cast<std::size_t>(x) & (kMostRun - 1)));
        int apart = indices[n + count - 1] == first + count - 1 ? 0 : 1;
        if (apart == 0) {
            for (std::size_t k = 0; k < count; ++k)
                apart |= (block.x[first + k] - x - static_cast<int>(k)) | (block.y[first + k] ^ y);
        }
        if (apart != 0) {
            const auto follows = [&](std::size_t k) {
                return indices[n + k] == first + k && block.x[first + k] == x + static_cast<int>(k) &&
                       block.y[first + k] == y;
            };
            for (count = 1; count < most && follows(count);) ++count;
        }
        runs.push_back({first, count});
        n += count;
    }
}

}  // namespace

const TilePixels& gatherPixels(const Run& run, std::size_t first, std::size_t& last, glm::dvec2 scale,
                               Reused<TilePixels>& out, std::vector<std::size_t>& fallback) {
    const FilterBlock& block = run.block;
    TilePixels& tile = out.refill();
    const PixelView* view = block.view[first];
    const HeightField& field = run.setup.tracer->field();
    // Plain filtering has the same limit. Factors of 1 and 10^6 change neither errors nor rays in the measurements
    // described in grid_lanes.h.
    const double largest = 4.0 * std::max(field.width(), field.height());
    const auto scanned = [&] { return scanTile(block, first, last, kTileAcross, kTileDown, largest); };
    // A frame's blocks are whole tiles.
    last = block.size();
    TileScan scan = scanned();
    if (!scan.same) {
        const auto same = [&](std::size_t i) {
            return block.view[i] == view && block.x[i] >> kTileAcross == block.x[first] >> kTileAcross &&
                   block.y[i] >> kTileDown == block.y[first] >> kTileDown;
        };
        for (last = first; last < block.size() && same(last);) ++last;
        scan = scanned();
    }
    const auto& [of, x0, x1, y0, y1, usable] = scan;
    constexpr int kSides = 2 * kTileHalo + 1;
    tile.cells = {view, scale, x0 - kTileHalo, y0 - kTileHalo, x1 - x0 + kSides, y1 - y0 + kSides};
    const bool all = view != nullptr && beforeHorizon(view->texelFromScreen, x0, y0, x1, y1);
    tile.indices.resize(last - first);
    if (all && usable) {
        std::iota(tile.indices.begin(), tile.indices.end(), first);
    } else {
        std::size_t served = 0;
        for (std::size_t i = first; i < last; ++i) {
            const bool before = all || (view != nullptr && beforeHorizon(view->texelFromScreen, block.x[i], block.y[i],
                                                                         block.x[i], block.y[i]));
            tile.indices[served] = i;
            // Written so that NaN is not supported.
            const bool serves = before && block.exact[i] != 0 && block.sides(i) < largest;
            served += serves ? 1 : 0;
            if (!serves) fallback.push_back(i);
        }
        tile.indices.resize(served);
    }
    findRuns(block, tile.indices, tile.runs);
    return tile;
}

const PlaneSplit& splitPixels(const Run& run, const TilePixels& pixels, const NearGround& ground,
                              Reused<PlaneSplit>& out) {
    PlaneSplit& split = out.refill();
    split.columns.refill(pixels.indices.size());
    const Centres& centres = ground.centres;
    const TileCells& cells = centres.cells;
    const SplitJob job{&run.block, centres.s.data(), centres.t.data(), cells.row(), ground.around.data(), cells.scale};
    for (const PixelRun& one : pixels.runs) {
        splitRun(job, one.first, one.count, cells.at(run.block.x[one.first], run.block.y[one.first]), split.columns);
    }
    return split;
}

void filterPlanes(Run& run, const PlaneSplit& split, SumWork& sum, std::span<Color> colors) {
    const EllipticalKernel& plain = run.setup.plain;
    const std::span<const std::size_t> of = split.planeOf();
    if (of.empty()) return;
    const FootprintCounts before = run.counts;
    const FilterBlock& planes = split.columns.planes;
    // Without a pixel in between, the colours need not be moved.
    const bool together = of.back() - of.front() + 1 == of.size();
    if (!together) reserve(sum.planes, of.size());
    const std::span<Color> to =
        together ? colors.subspan(of.front(), of.size()) : std::span(sum.planes.data(), of.size());
    if (run.log != nullptr) {
        const FilterQuery one = planes[0];
        to[0] = plain.filter(one.jacobian, one.place, run.counts, run.log);
        run.log->skipped = true;
    } else {
        plain.filter(planes, {1, 1}, to, run.counts);
    }
    run.counts.skipped += run.counts.texels - before.texels;
    run.counts.flat += run.counts.footprints - before.footprints;
    for (std::size_t n = 0; n < of.size() && !together; ++n) colors[of[n]] = sum.planes[n];
}

void sumEdges(Run& run, const EdgeGround& ground, const PlaneSplit& split, const PointColors& points, SumWork& sum,
              std::span<Color> colors) {
    const GridSetup& setup = run.setup;
    const FilterBlock& block = run.block;
    const TileCells& cells = ground.centres.cells;
    const auto perCell = static_cast<std::int32_t>(setup.lattice.places.size());
    const std::span<const std::size_t> edges = split.edges();
    sum.base.clear();
    for (const std::size_t i : edges) {
        sum.base.push_back(static_cast<std::int32_t>(cells.at(block.x[i], block.y[i])) * perCell);
    }
    sum.offset.clear();
    for (const PointLattice::Term& term : setup.lattice.terms) {
        sum.offset.push_back((term.dy * cells.width + term.dx) * perCell + term.point);
    }
    reserve(sum.sums, edges.size());
    sumPoints(points.slots.data(), sum.base, sum.offset, setup.lattice.weights, sum.sums);
    for (std::size_t n = 0; n < edges.size(); ++n) {
        const std::size_t i = edges[n];
        const auto& [red, green, blue, total] = sum.sums[n].channel;
        if (total > 0) {
            colors[i] = Color(red, green, blue) / total;
        } else {
            // No point hit the relief, although the pixel's own ray did: the colour at its hit is read.
            ++run.counts.allHidden;
            run.counts.texels += 4;
            const glm::dvec2 place = glm::dvec2(block.s[i], block.t[i]) * cells.scale;
            colors[i] = setup.reader.levels().bilinear(0, place, setup.reader.address());
        }
    }
    run.counts.footprints += static_cast<std::int64_t>(edges.size());
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
    if (split.edges().empty()) return;
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
    for (std::size_t first = 0, last = 0; first < block.size() && !work.stopped(); first = last) {
        const grid::TilePixels& pixels = grid::gatherPixels(run, first, last, scale, scratch.pixels, fallbackPixels);
        if (!pixels.indices.empty()) filterTile(run, pixels, scratch, colors);
    }
    if (fallbackPixels.empty()) return;
    FilterBlock fallback;
    for (const std::size_t i : fallbackPixels) fallback.push(block[i]);
    std::vector<Color> found(fallbackPixels.size());
    fallback_.filter(fallback, scale, found, counts, work, log);
    for (std::size_t n = 0; n < fallbackPixels.size(); ++n) colors[fallbackPixels[n]] = found[n];
}

}  // namespace relief
