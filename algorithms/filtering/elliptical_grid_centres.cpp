// The hits at cells' centres, and how each lies among its neighbours.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "filtering/grid_stages.h"
#include "relief/block_work.h"
#include "relief/methods/look_up_point.h"

namespace relief::grid {

namespace {

// Copies all centres that the picture contains, row by row.
void takePicture(const HeightField& field, const PictureHits& picture, Centres& centres) {
    const TileCells& cells = centres.cells;
    const HitBlock& hits = *picture.hits;
    const int from = std::max(cells.x0, 0), to = std::min(cells.x0 + cells.width, picture.width);
    const auto count = static_cast<std::size_t>(std::max(to - from, 0));
    const std::uint8_t own = cells.view->number;
    centres.allKnown = count == cells.row();
    for (int y = cells.y0; y < cells.y0 + cells.height; ++y) {
        const std::size_t start = cells.at(cells.x0, y), end = start + cells.row();
        if (!picture.hasRow(y) || count == 0) {
            centres.clear(start, end);
            centres.allKnown = false;
            continue;
        }
        const std::size_t i = picture.at(from, y), cell = cells.at(from, y);
        centres.clear(start, cell);
        const bool known = copyHits(picture, i, count, own, cells.scale, centres.columns(cell));
        centres.allKnown = centres.allKnown && known;
        centres.clear(cell + count, end);
        // On columns, the place where colours are sampled differs from the hit and must be computed for each.
        for (std::size_t n = 0; n < count && field.surface() == Surface::Columns; ++n) {
            if (std::isnan(centres.s[cell + n])) continue;
            const glm::dvec2 place = lookUpPoint(field, (*picture.rays)[i + n], hits[i + n]);
            centres.set(cell + n, place.x, place.y, hits.lambda[i + n]);
        }
    }
}

// Marks in survey.near the cells within `reach` of these pixels of the block whose centres are not known.
void markNear(const FilterBlock& block, std::span<const std::size_t> pixels, int reach, const Centres& centres,
              SurveyWork& survey) {
    const TileCells& cells = centres.cells;
    const std::size_t row = cells.row(), rows = cells.count() / row, far = static_cast<std::size_t>(reach);
    for (auto* column : {&survey.own, &survey.along, &survey.near}) column->assign(cells.count(), 0);
    for (const std::size_t i : pixels) survey.own[cells.at(block.x[i], block.y[i])] = 1;
    // Dilates along rows, then along columns; the pixels are at least kTileHalo cells from the tile's border.
    const auto join = [](std::uint8_t* to, const std::uint8_t* from, std::size_t count) {
        for (std::size_t c = 0; c < count; ++c) to[c] |= from[c];
    };
    const std::size_t inner = cells.count() - 2 * far;
    for (std::size_t n = 0; n <= 2 * far; ++n) join(survey.along.data() + far, survey.own.data() + n, inner);
    for (std::size_t y = 0; y < rows; ++y) {
        const std::size_t last = std::min(y + far, rows - 1);
        for (std::size_t from = y < far ? 0 : y - far; from <= last; ++from) {
            join(survey.near.data() + y * row, survey.along.data() + from * row, row);
        }
    }
    for (std::size_t c = 0; c < cells.count(); ++c) survey.near[c] &= static_cast<std::uint8_t>(1 - centres.known[c]);
}

// Lists the centres of the marked cells.
void findMissing(const TileCells& cells, const std::vector<std::uint8_t>& near, Places& missing) {
    missing.count = 0;
    const std::uint8_t* const end = near.data() + cells.count();
    const auto next = [&](const std::uint8_t* from) {
        return static_cast<const std::uint8_t*>(std::memchr(from, 1, static_cast<std::size_t>(end - from)));
    };
    for (const std::uint8_t* at = next(near.data()); at != nullptr; at = next(at + 1)) {
        const auto cell = static_cast<std::size_t>(at - near.data());
        missing.reserve(1);
        missing.slots[missing.count] = static_cast<std::uint32_t>(cell);
        missing.x[missing.count] = cells.x0 + static_cast<int>(cell % cells.row()) + 0.5;
        missing.y[missing.count] = cells.y0 + static_cast<int>(cell / cells.row()) + 0.5;
        ++missing.count;
    }
}

// Traces the unknown centres within `reach` cells of these pixels of the block. Returns true if there were any.
bool complete(Run& run, std::span<const std::size_t> pixels, int reach, Centres& centres, SurveyWork& survey) {
    if (centres.allKnown) return false;
    markNear(run.block, pixels, reach, centres, survey);
    findMissing(centres.cells, survey.near, survey.missing);
    const Places& missing = survey.missing;
    for (std::size_t begin = 0; begin < missing.count; begin += kRayGrain) {
        const std::size_t count = std::min(kRayGrain, missing.count - begin);
        traceBatch(run, *centres.cells.view, missing, begin, count, survey.batch);
        const HitBlock& hits = survey.batch.hits;
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t cell = missing.slots[begin + n];
            centres.known[cell] = 1;
            if (hits.outcome[n] == Outcome::Hit) centres.set(cell, hits.s[n], hits.t[n], hits.lambda[n]);
        }
    }
    return missing.count > 0;
}

void findAround(const Run& run, const Centres& centres, BitColumn& around) {
    const TileCells& cells = centres.cells;
    reserve(around, cells.count() + kCellSlack);
    const CellHits hits{cells.width, cells.height, centres.pictureS.data(), centres.pictureT.data(),
                        centres.floatLambda.data()};
    findSurroundings(hits, run.setup.bounds, around.data());
}

}  // namespace

void traceBatch(Run& run, const PixelView& view, const Places& places, std::size_t begin, std::size_t count,
                RayBatch& batch) {
    assert(count <= kRayGrain);
    const GridSetup& setup = run.setup;
    batch.rays.resize(count);
    raysThrough(view, {places.x.data() + begin, count}, {places.y.data() + begin, count}, batch.rays, 0);
    if (setup.coneHits) {
        setup.coneHits->trace(batch.rays, batch.hits, *setup.tracer, run.work);
    } else {
        NullSink sink;
        setup.tracer->trace(batch.rays, batch.hits, sink, run.work);
    }
    run.counts.tested += static_cast<std::int64_t>(count);
    const HeightField& field = setup.tracer->field();
    if (field.surface() != Surface::Columns) return;
    for (std::size_t n = 0; n < count; ++n) {
        if (batch.hits.outcome[n] != Outcome::Hit) continue;
        const glm::dvec2 place = lookUpPoint(field, batch.rays[n], batch.hits[n]);
        batch.hits.s[n] = place.x, batch.hits.t[n] = place.y;
    }
}

Centres& takeCentres(const Run& run, const TilePixels& pixels, Reused<Centres>& out) {
    Centres& centres = out.refill();
    centres.cells = pixels.cells;
    const std::size_t count = pixels.cells.count(), columns = count + kCellSlack;
    for (auto* column : {&centres.s, &centres.t, &centres.lambda}) reserve(*column, columns);
    for (auto* column : {&centres.pictureS, &centres.pictureT, &centres.floatLambda}) reserve(*column, columns);
    reserve(centres.known, count);
    const FilterBlock& block = run.block;
    centres.allKnown = block.picture != nullptr;
    if (block.picture != nullptr) {
        takePicture(run.setup.tracer->field(), *block.picture, centres);
        return centres;
    }
    centres.clear(0, count);
    for (const std::size_t i : pixels.indices) {
        const std::size_t cell = pixels.cells.at(block.x[i], block.y[i]);
        centres.known[cell] = 1;
        centres.set(cell, block.s[i], block.t[i], block.lambda[i]);
    }
    return centres;
}

NearGround surveyPixels(Run& run, const TilePixels& pixels, Centres& centres, SurveyWork& survey,
                        Reused<BitColumn>& out) {
    complete(run, pixels.indices, 1, centres, survey);
    BitColumn& around = out.refill();
    findAround(run, centres, around);
    return {centres, around};
}

EdgeGround surveyEdges(Run& run, const PlaneSplit& split, const NearGround& ground, SurveyWork& survey) {
    if (complete(run, split.edges(), kTileHalo, ground.centres, survey)) findAround(run, ground.centres, ground.around);
    return {ground.centres, ground.around};
}

}  // namespace relief::grid
