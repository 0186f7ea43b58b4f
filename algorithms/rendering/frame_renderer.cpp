#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include <oneapi/tbb/parallel_for.h>

#include "relief/look_up_point.h"
#include "rendering/frame.h"
#include "rendering/mesh_raster.h"
#include "rendering/visible_polygons.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTileWidth = 64;
constexpr int kTileHeight = 16;

// What of a request differs from the last one.
std::uint32_t changedInputs(const FrameRequest& now, const FrameRequest& last) {
    std::uint32_t changed = 0;
    const auto compare = [&](Input input, bool same) { changed |= same ? 0U : bit(input); };
    compare(Input::Size, now.width == last.width && now.height == last.height);
    compare(Input::Camera, now.camera == last.camera);
    compare(Input::Scene, now.scene == last.scene);
    compare(Input::HeightSize, now.field.width() == last.field.width() && now.field.height() == last.field.height());
    compare(Input::Heights, now.field.sharedHeights() == last.field.sharedHeights());
    compare(Input::Surface, now.field.surface() == last.field.surface());
    compare(Input::Address, now.field.address() == last.field.address());
    compare(Input::Depth, now.field.reliefDepth() == last.field.reliefDepth());
    compare(Input::Method, now.method == last.method);
    compare(Input::ColorPicture, now.color == last.color);
    compare(Input::Filter, now.filter == last.filter);
    compare(Input::NormalPicture, now.normals == last.normals);
    compare(Input::Light, now.light == last.light);
    compare(Input::Sky, now.sky == last.sky);
    return changed;
}

bool has(std::uint32_t stages, Stage stage) {
    return (stages & bit(stage)) != 0;
}

std::uint32_t staleStages(std::uint32_t changed) {
    std::uint32_t stale = 0;
    for (std::size_t s = 0; s < kStages; ++s) {
        if ((allInputs(static_cast<Stage>(s)) & changed) != 0) stale |= 1U << s;
    }
    return stale;
}

// The buffers of one frame in the making: those of stale stages are new, the others are the last frame's.
struct Buffers {
    std::shared_ptr<RayStage> rays;
    std::shared_ptr<HitStage> hits;
    std::shared_ptr<ColorStage> color;
    std::shared_ptr<LightStage> light;
};

struct Totals {
    std::array<std::atomic<std::int64_t>, kStages> nanoseconds{};
    std::atomic<std::int64_t> covered{0};
    std::atomic<std::int64_t> traced{0};
    std::atomic<std::int64_t> steps{0};
    std::atomic<std::int64_t> reads{0};
    std::atomic<std::int64_t> startHighest{0};
    std::atomic<std::int64_t> hits{0};
    std::atomic<std::int64_t> misses{0};
    std::atomic<std::int64_t> limits{0};
    std::atomic<std::int64_t> triangles{0};
};

class TileWorker {
  public:
    TileWorker(const FrameRequest& request, const VisiblePolygons& visible, const Frame& frame, const Tracer& tracer,
               const MeshRaster* raster, const Buffers& buffers, std::uint32_t stale, Totals& totals)
        : request_(request),
          visible_(visible),
          frame_(frame),
          tracer_(tracer),
          raster_(raster),
          buffers_(buffers),
          stale_(stale),
          totals_(totals),
          toLight_(lightDirection(request.light)) {}

    void run(const PixelArea& tile, Work& work) const {
        timed(Stage::Rays, [&] { makeRays(tile); });
        timed(Stage::Hits, [&] { raster_ != nullptr ? drawMesh(tile) : traceRays(tile, work); });
        timed(Stage::Color, [&] { colorHits(tile); });
        timed(Stage::Light, [&] { lightHits(tile); });
    }

  private:
    template <class Body>
    void timed(Stage stage, const Body& body) const {
        if (!has(stale_, stage)) return;
        const auto begin = Clock::now();
        body();
        totals_.nanoseconds[static_cast<std::size_t>(stage)] += (Clock::now() - begin).count();
    }

    template <class Body>
    void overPixels(const PixelArea& tile, const Body& body) const {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) body(x, y, frame_.index(x, y));
        }
    }

    void makeRays(const PixelArea& tile) const;
    void traceRays(const PixelArea& tile, Work& work) const;
    void drawMesh(const PixelArea& tile) const;
    void countOutcomes(const PixelArea& tile) const;
    void colorHits(const PixelArea& tile) const;
    void lightHits(const PixelArea& tile) const;
    Color albedo(double s, double t) const;

    const FrameRequest& request_;
    const VisiblePolygons& visible_;
    const Frame& frame_;
    const Tracer& tracer_;
    const MeshRaster* raster_;
    const Buffers& buffers_;
    std::uint32_t stale_;
    Totals& totals_;
    glm::dvec3 toLight_;
};

void TileWorker::makeRays(const PixelArea& tile) const {
    RayStage& out = *buffers_.rays;
    std::int64_t covered = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (const VisiblePolygon& polygon : visible_.polygons) {
            const PixelSpan span = polygon.span(y, frame_.width);
            const int first = static_cast<int>(std::max<std::int64_t>(span.begin, tile.x0));
            const int last = static_cast<int>(std::min<std::int64_t>(span.end, tile.x1));
            for (int x = first; x < last; ++x) {
                const std::size_t i = frame_.index(x, y);
                const VisiblePolygon::Entry entry = polygon.entry(x, y);
                if (entry.inverseDepth <= out.inverseDepth[i]) continue;
                covered += out.polygon[i] == kNoPolygon ? 1 : 0;
                out.inverseDepth[i] = entry.inverseDepth;
                out.polygon[i] = polygon.number;
                out.rays.set(i, entry.ray);
            }
        }
    }
    totals_.covered += covered;
}

void TileWorker::traceRays(const PixelArea& tile, Work& work) const {
    const RayStage& rays = *frame_.rays;
    HitBlock& out = buffers_.hits->hits;
    std::vector<std::size_t> pixels;
    pixels.reserve(static_cast<std::size_t>(kTileWidth) * kTileHeight);
    overPixels(tile, [&](int, int, std::size_t i) {
        if (rays.polygon[i] != kNoPolygon) pixels.push_back(i);
    });
    RayBlock block(pixels.size());
    for (std::size_t n = 0; n < pixels.size(); ++n) block.set(n, rays.rays[pixels[n]]);
    HitBlock hits;
    BlockCounts counts;
    tracer_.trace(block, hits, counts, work);
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        out.set(pixels[n], hits[n]);
        out.steps[pixels[n]] = hits.steps[n];
        out.reads[pixels[n]] = hits.reads[n];
    }
    countOutcomes(tile);
    totals_.traced += static_cast<std::int64_t>(pixels.size());
    totals_.steps += static_cast<std::int64_t>(counts.steps);
    totals_.reads += static_cast<std::int64_t>(counts.reads);
    totals_.startHighest += static_cast<std::int64_t>(counts.startHighest);
}

void TileWorker::drawMesh(const PixelArea& tile) const {
    HitBlock& out = buffers_.hits->hits;
    totals_.triangles += raster_->draw(tile, frame_.rays->polygon, out);
    std::int64_t covered = 0;
    overPixels(tile, [&](int, int, std::size_t i) { covered += out.steps[i]; });
    totals_.steps += covered;
    countOutcomes(tile);
}

void TileWorker::countOutcomes(const PixelArea& tile) const {
    std::array<std::int64_t, 4> outcomes{};
    overPixels(tile,
               [&](int, int, std::size_t i) { ++outcomes[static_cast<std::size_t>(buffers_.hits->hits.outcome[i])]; });
    totals_.hits += outcomes[static_cast<std::size_t>(Outcome::Hit)];
    totals_.misses += outcomes[static_cast<std::size_t>(Outcome::Miss)];
    totals_.limits += outcomes[static_cast<std::size_t>(Outcome::Limit)];
}

Color TileWorker::albedo(double s, double t) const {
    if (!request_.color) return Color(static_cast<float>(0.2 + 0.6 * request_.field.at(s, t)));
    const ColorImage& image = *request_.color;
    const double x = s * image.width() / request_.field.width();
    const double y = t * image.height() / request_.field.height();
    return request_.filter.name == "nearest" ? sampleNearest(image, x, y, request_.field.address())
                                             : sampleBilinear(image, x, y, request_.field.address());
}

void TileWorker::colorHits(const PixelArea& tile) const {
    const HitBlock& hits = frame_.hits->hits;
    overPixels(tile, [&](int, int, std::size_t i) {
        if (hits.outcome[i] != Outcome::Hit) return;
        const glm::dvec2 place = lookUpPoint(request_.field, frame_.rays->rays[i], hits[i]);
        buffers_.color->color.pixels()[i] = albedo(place.x, place.y);
    });
}

void TileWorker::lightHits(const PixelArea& tile) const {
    const HitBlock& hits = frame_.hits->hits;
    const auto colors = frame_.color->color.pixels();
    const auto out = buffers_.light->color.pixels();
    overPixels(tile, [&](int x, int y, std::size_t i) {
        switch (hits.outcome[i]) {
            case Outcome::Hit:
                out[i] = lambert(colors[i], frame_.normal(x, y, request_), toLight_, request_.light);
                break;
            case Outcome::Limit:
                out[i] = Color(0);
                break;
            default:
                out[i] = request_.sky;
        }
    });
}

std::vector<PixelArea> tilesOf(int width, int height) {
    std::vector<PixelArea> tiles;
    for (int y = 0; y < height; y += kTileHeight) {
        for (int x = 0; x < width; x += kTileWidth) {
            tiles.push_back({x, y, std::min(x + kTileWidth, width), std::min(y + kTileHeight, height)});
        }
    }
    return tiles;
}

void checkRequest(const FrameRequest& request) {
    findFilter(request.filter.name);
    for (const int side : {request.width, request.height}) {
        if (side >= 1 && side <= kMaxPictureSide) continue;
        throw InputError("--size",
                         Message(MessageId::OutOfRange, {{"what", "side of the picture"},
                                                         {"value", side},
                                                         {"range", "1 to " + std::to_string(kMaxPictureSide)}}));
    }
}

// New buffers for stale stages; the frame points to what its later stages read.
Buffers allocate(Frame& frame, const Frame* last, std::uint32_t stale) {
    const auto pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    Buffers buffers;
    if (has(stale, Stage::Rays)) {
        buffers.rays = std::make_shared<RayStage>();
        buffers.rays->rays.resize(pixels);
        buffers.rays->polygon.assign(pixels, kNoPolygon);
        buffers.rays->inverseDepth.assign(pixels, 0.0F);
    }
    if (has(stale, Stage::Hits)) {
        buffers.hits = std::make_shared<HitStage>();
        buffers.hits->hits.resize(pixels);
    }
    if (has(stale, Stage::Color)) {
        buffers.color = std::make_shared<ColorStage>();
        buffers.color->color = ColorImage(frame.width, frame.height, Color(0));
    }
    if (has(stale, Stage::Light)) {
        buffers.light = std::make_shared<LightStage>();
        buffers.light->color = ColorImage(frame.width, frame.height, Color(0));
    }
    frame.rays = buffers.rays ? buffers.rays : last->rays;
    frame.hits = buffers.hits ? buffers.hits : last->hits;
    frame.color = buffers.color ? buffers.color : last->color;
    frame.light = buffers.light ? buffers.light : last->light;
    return buffers;
}

void report(Frame& frame, const VisiblePolygons& visible, const Totals& totals, std::uint32_t stale) {
    for (std::size_t s = 0; s < kStages; ++s) {
        frame.stages[s].reused = (stale & (1U << s)) == 0;
        frame.stages[s].seconds = static_cast<double>(totals.nanoseconds[s]) * 1e-9;
    }
    const auto count = [&](const char* name, double value) { frame.counters[name] = value; };
    count("polygons", visible.total);
    count("polygons culled: facing away", visible.backFacing);
    count("polygons culled: off screen", visible.offScreen);
    const double pixels = static_cast<double>(frame.width) * frame.height;
    count("pixels", pixels);
    if (has(stale, Stage::Rays)) count("pixels without a polygon", pixels - static_cast<double>(totals.covered));
    count("rays traced", static_cast<double>(totals.traced));
    if (has(stale, Stage::Hits)) {
        count("rays not needed: the start is the highest point", static_cast<double>(totals.startHighest));
        count("steps", static_cast<double>(totals.steps));
        count("reads", static_cast<double>(totals.reads));
        count("hits", static_cast<double>(totals.hits));
        count("misses", static_cast<double>(totals.misses));
        count("step limits", static_cast<double>(totals.limits));
        if (totals.triangles > 0) count("triangles drawn", static_cast<double>(totals.triangles));
    }
    count("stages not computed again",
          static_cast<double>(std::count_if(frame.stages.begin(), frame.stages.end(),
                                            [](const StageReport& stage) { return stage.reused; })));
}

}  // namespace

std::shared_ptr<const Frame> FrameRenderer::render(const FrameRequest& request, Work& work) {
    const auto begin = Clock::now();
    checkRequest(request);
    const bool first = !frame_ || !last_;
    const std::uint32_t stale = staleStages(first ? (1U << kInputs) - 1 : changedInputs(request, *last_));
    auto frame = std::make_shared<Frame>();
    frame->width = request.width;
    frame->height = request.height;
    frame->slabTexels = request.field.slabTexels();
    frame->polygons = makeScene(request.scene, request.field.width(), request.field.height());
    frame->camera = pinholeCamera(request.camera, request.width, request.height);
    const VisiblePolygons visible =
        visiblePolygons(frame->polygons, frame->camera, request.width, request.height, request.field.reliefDepth());
    std::shared_ptr<const Tracer> tracer = tracer_;
    const bool newTracer = first || has(stale, Stage::Hits) || !tracer;
    if (newTracer) tracer = makeTracer(request.method, request.field, *maps_, work);
    frame->shading = tracer->description().shading;
    if (frame->shading == ShadingNormal::NormalMap && !request.normals) {
        frame->bakedNormals = bakedNormals(request.field, *maps_, work);
    }

    const Buffers buffers = allocate(*frame, frame_.get(), stale);
    Totals totals;
    std::unique_ptr<const MeshRaster> raster;
    if (tracer->mesh() != nullptr && has(stale, Stage::Hits)) {
        raster = std::make_unique<MeshRaster>(*tracer->mesh(), visible, frame->camera, frame->width, work);
    }
    const TileWorker worker(request, visible, *frame, *tracer, raster.get(), buffers, stale, totals);
    const std::vector<PixelArea> tiles = tilesOf(request.width, request.height);
    if (stale != 0) {
        work.progress().begin("frame", static_cast<std::int64_t>(tiles.size()));
        work.arena().execute([&] {
            tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t n) {
                if (work.stopped()) return;
                worker.run(tiles[n], work);
                work.progress().advance();
            });
        });
    }
    work.throwIfStopped();
    report(*frame, visible, totals, stale);
    frame->seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    for (const auto& [name, value] : frame->counters) work.counters().add(name, value);
    last_ = request;
    frame_ = frame;
    tracer_ = tracer;
    return frame;
}

}  // namespace relief
