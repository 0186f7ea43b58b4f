// Pictures for one use: all stages but light are kept only for a band of rows, the light stage for all rows made.
#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "relief/memory.h"
#include "relief/tracers/tile_methods.h"
#include "rendering/frame_report.h"
#include "rendering/frame_tools.h"
#include "rendering/supersample.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

// Tiles of a band, and the least number per thread: enough that threads seldom wait for the last tile. About 40 MB of
// stages.
constexpr int kBandTiles = 256, kThreadTiles = 16;
// Rows above and below a band whose hits are kept for filters that read their neighbours' hits; more than the filters'
// reach.
constexpr int kHaloRows = kTileHeight;

int bandRows(int width, int threads) {
    const int tiles = std::max(kBandTiles, kThreadTiles * threads), across = tilesAcross(width);
    return (tiles + across - 1) / across * kTileHeight;
}

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Makes one picture band by band, from the top.
class BandMaker {
  public:
    // first: the row from which rays are traced, the first row of a tile. counts: whether steps and reads of traced
    // rays are counted; a mesh counts its own with its hits.
    BandMaker(const FrameRequest& request, const FrameSetup& setup, FrameBuffers& band, int first, bool counts,
              Work& work)
        : request_(request),
          setup_(setup),
          tools_(setup.tools()),
          band_(band),
          counts_(counts),
          work_(work),
          firstUntraced_(first) {
        setup.frame->stored = {first, first};
    }

    // Makes rows [begin, end) and keeps the stages of `halo` more rows on either side.
    void make(RowRange rows, int halo, std::optional<WholeProgress>& progress) {
        Frame& frame = *setup_.frame;
        const RowRange stored{std::max(0, rows.begin - halo), std::min(frame.height, rows.end + halo)};
        shiftBand(band_, frame, stored.begin - frame.stored.begin);
        frame.rows = rows, frame.stored = stored;
        const TileWorker worker(request_, frame, tools_, band_, kAllStages, totals);
        if (halo > 0) {
            const std::vector<PixelArea> ahead = tilesOf(frame.width, {firstUntraced_, stored.end});
            overTiles(ahead, false, work_, [&](const PixelArea& tile) { worker.findHits(tile, work_); });
            firstUntraced_ = stored.end;
        }
        const std::vector<PixelArea> tiles = tilesOf(frame.width, rows);
        overTiles(tiles, false, work_, [&](const PixelArea& tile) {
            if (halo == 0) worker.findHits(tile, work_);
            worker.shade(tile, work_);
            if (progress) progress->advance();
        });
        if (!counts_) return;
        const auto begin = Clock::now();
        // Pixels without a polygon keep counts of 0.
        for (auto* column : {&band_.hits->hits.steps, &band_.hits->hits.reads}) {
            std::fill(column->begin(), column->end(), 0U);
        }
        overTiles(tiles, false, work_, [&](const PixelArea& tile) {
            countTile(tile, *setup_.tracer, frame, *band_.hits, countTotals, work_);
        });
        frame.countSeconds += secondsSince(begin);
    }

    FrameTotals totals, countTotals;

  private:
    const FrameRequest& request_;
    const FrameSetup& setup_;
    FrameTools tools_;
    FrameBuffers& band_;
    bool counts_;
    Work& work_;
    int firstUntraced_;  // the first row whose rays are not traced yet
};

// Returns the rows of the tiles that contain the wanted rows; tiles begin where they do in the whole picture.
RowRange madeRows(const RowRange& wanted, int height) {
    if (wanted.empty()) return {0, height};
    assert(wanted.begin >= 0 && wanted.begin < wanted.end && wanted.end <= height);
    return {wanted.begin / kTileHeight * kTileHeight, std::min(height, tilesDown(wanted.end) * kTileHeight)};
}

}  // namespace

std::uint64_t pictureBytes(const FrameRequest& request, int threads, RowRange rows) {
    const bool samples = request.filter.name == kSupersample;
    const int ring = samples ? kGaussianRing : 0;
    const int lit = rows.orAll(request.height).count() + 2 * ring;
    const int made = std::min(request.height + 2 * ring, rows.empty() ? lit : lit + 2 * (kTileHeight - 1));
    // Sample passes use the bilinear filter, which needs no halo.
    const int halo = samples ? 0 : 2 * kHaloRows;
    const int stored =
        std::min(std::min(bandRows(request.width + 2 * ring, threads), made) + halo, request.height + 2 * ring);
    const auto bytes = [&](int height, std::size_t each) {
        return byteProduct(
            {static_cast<std::uint64_t>(request.width + 2 * ring), static_cast<std::uint64_t>(height), each});
    };
    return byteSum({bytes(lit, sizeof(Color)), bytes(stored, kStageBytes + kCountBytes),
                    samples ? bytes(lit, sizeof(glm::dvec3)) : 0});
}

std::shared_ptr<const Frame> FrameRenderer::picture(const FrameRequest& request, Work& work,
                                                    const PictureParts& parts) {
    const auto begin = Clock::now();
    checkRequest(request);
    const int threads = work.threads().size();
    const bool counts = parts.counts || request.counts;
    if (!partOfMore_) {
        requireMemory(pictureBytes(request, threads, parts.onlyRows), sizeSubject(request), MemoryHint::SmallerSize);
    }
    const std::unique_ptr<FrameSetup> setup = madeSetup(request, changedSince(request), kAllStages, work);
    Frame& frame = *setup->frame;
    current_.reset(), spare_.reset();
    if (!band_) band_ = std::make_shared<FrameBuffers>();
    const int halo = TileWorker::hitsFirst(frame, request, kAllStages) ? kHaloRows : 0;
    const bool mesh = setup->mesh != nullptr;
    assert(parts.rows % kTileHeight == 0);
    const RowRange made = madeRows(parts.onlyRows, frame.height);
    const int rows = std::min(parts.rows > 0 ? parts.rows : bandRows(frame.width, threads), made.count());
    fitBand(*band_, frame, std::min(frame.height, rows + 2 * halo), request, counts || mesh);
    frame.rays = band_->rays, frame.hits = band_->hits, frame.color = band_->color, frame.shadows = band_->shadows;
    frame.lit = parts.onlyRows.orAll(frame.height);
    frame.light = fitLight(band_->light, frame);
    // What is done with the bands may trace as well, which would replace the stage.
    std::optional<WholeProgress> progress;
    if (!partOfMore_) progress.emplace(work.progress(), "frame", tilesAcross(frame.width) * tilesDown(made.count()));
    BandMaker maker(request, *setup, *band_, std::max(0, made.begin - halo), counts && !mesh, work);
    for (int y = made.begin; y < made.end; y += rows) {
        maker.make({y, std::min(made.end, y + rows)}, halo, progress);
        requireHeights(request.field);
        if (parts.done) parts.done(frame);
    }
    progress.reset();
    frame.rows = frame.stored = {0, frame.height};
    frame.rays = nullptr, frame.hits = nullptr, frame.color = nullptr, frame.shadows = nullptr;
    maker.totals.nanoseconds[static_cast<std::size_t>(Stage::Shadows)] += setup->horizonTime.count();
    report(frame, request, setup->visible, maker.totals, kAllStages, mesh);
    if (counts && !mesh) reportCounts(frame, maker.countTotals);
    if (request.filter.name == kSupersample) {
        // The mean of the samples replaces the frame's own light stage.
        frame.light = nullptr;
        band_.reset();
        frame.light = std::make_shared<LightStage>(
            LightStage{supersampled(request, maps_, work, {}, frame.counters, parts.onlyRows)});
    }
    requireHeights(request.field);
    finish(frame, begin, work);
    // The picture belongs to the caller alone.
    auto last = std::make_shared<Frame>(frame);
    last->light = nullptr;
    last_ = request, frame_ = std::move(last), tracer_ = setup->tracer;
    return setup->frame;
}

}  // namespace relief
