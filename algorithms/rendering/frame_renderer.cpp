#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <utility>

#include <glm/geometric.hpp>

#include "images/tiled_heights.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/simd/packed_cone_hits.h"
#include "relief/tracers/tile_methods.h"
#include "rendering/flat_ground.h"
#include "rendering/frame_report.h"
#include "rendering/frame_tools.h"
#include "rendering/supersample.h"

namespace relief {

namespace {

// Returns the inputs (bits of Input) in which the request differs from the last one.
std::uint32_t changedInputs(const FrameRequest& now, const FrameRequest& last) {
    // A field that is added to the request breaks the build here, because it must be assigned to an input. Only
    // `counts` changes no input.
    const auto& [width, height, field, method, color, normals, filter, scene, camera, light, shadows, counts, mapping,
                 skip, bounded, sky, sample, margin] = now;
    std::uint32_t changed = 0;
    const auto compare = [&](Input input, bool same) { changed |= same ? 0U : bit(input); };
    compare(Input::Size, width == last.width && height == last.height);
    compare(Input::Camera, camera == last.camera && sample == last.sample && margin == last.margin);
    compare(Input::Scene, scene == last.scene);
    compare(Input::HeightSize, field.width() == last.field.width() && field.height() == last.field.height());
    compare(Input::Heights, field.identity() == last.field.identity());
    compare(Input::Surface, field.surface() == last.field.surface());
    compare(Input::Address, field.address() == last.field.address());
    compare(Input::Depth, field.reliefDepth() == last.field.reliefDepth());
    compare(Input::Method, method == last.method);
    compare(Input::ColorPicture, color == last.color);
    compare(Input::Filter, filter == last.filter);
    compare(Input::NormalPicture, normals == last.normals);
    compare(Input::LightDirection, lightDirection(light) == lightDirection(last.light));
    compare(Input::Light, light == last.light);
    compare(Input::Shadows, shadows == last.shadows);
    compare(Input::Sky, sky == last.sky);
    compare(Input::Mapping, mapping == last.mapping);
    compare(Input::Skip, skip == last.skip);
    compare(Input::Bounded, bounded == last.bounded);
    return changed;
}

// The inputs that a filter is made from; the camera is not among them.
constexpr std::uint32_t kFilterInputs = bit(Input::HeightSize) | bit(Input::Heights) | bit(Input::Surface) |
                                        bit(Input::Address) | bit(Input::Depth) | bit(Input::ColorPicture) |
                                        bit(Input::Filter) | bit(Input::Skip) | bit(Input::Bounded);

std::uint32_t staleStages(std::uint32_t changed) {
    std::uint32_t stale = 0;
    for (std::size_t s = 0; s < kStages; ++s) {
        if ((allInputs(static_cast<Stage>(s)) & changed) != 0) stale |= 1U << s;
    }
    return stale;
}

// The level of means that stands for the heights of a map read by tiles where a picture of all heights is needed: the
// finest one up to this number of texels, so that the picture takes a few tens of megabytes.
constexpr std::size_t kMostGreyTexels = std::size_t{1} << 21;
int greyLevel(const TiledHeights& tiles) {
    int level = 0;
    while (static_cast<std::size_t>(tiles.width(level)) * static_cast<std::size_t>(tiles.height(level)) >
           kMostGreyTexels)
        ++level;
    return level;
}

// Returns the heights as a grey picture, for filters that need a picture.
std::shared_ptr<const ColorImage> greyPicture(const HeightField& field) {
    if (const TiledHeights* const tiles = field.tiles()) {
        const int level = greyLevel(*tiles);
        auto picture = std::make_shared<ColorImage>(tiles->width(level), tiles->height(level));
        for (int y = 0; y < picture->height(); ++y) {
            for (int x = 0; x < picture->width(); ++x) (*picture)(x, y) = heightGrey(tiles->mean(level, x, y));
        }
        return picture;
    }
    const FloatImage& heights = field.heights();
    auto picture = std::make_shared<ColorImage>(heights.width(), heights.height());
    std::transform(heights.pixels().begin(), heights.pixels().end(), picture->pixels().begin(), heightGrey);
    return picture;
}

// Texels of the colour picture per texel of the heights, along the denser axis.
double colorPerTexel(const FrameRequest& request) {
    const auto per = [&](int width, int height) {
        return std::max(static_cast<double>(width) / request.field.width(),
                        static_cast<double>(height) / request.field.height());
    };
    if (request.color) return per(request.color->width(), request.color->height());
    const TiledHeights* const tiles = request.field.tiles();
    if (tiles == nullptr || !needsLevels(request.filter)) return 1;
    const int level = greyLevel(*tiles);
    return per(tiles->width(level), tiles->height(level));
}

// Returns a frame with everything that is known before any pixel is made.
std::shared_ptr<Frame> describedFrame(const FrameRequest& request) {
    auto frame = std::make_shared<Frame>();
    frame->width = request.width;
    frame->height = request.height;
    frame->rows = frame->stored = frame->lit = {0, request.height};
    frame->slabTexels = request.field.slabTexels();
    frame->polygons = makeScene(request.scene, request.field.width(), request.field.height());
    frame->camera = requestCamera(request);
    frame->colorPerTexel = colorPerTexel(request);
    return frame;
}

}  // namespace

void checkRequest(const FrameRequest& request) {
    checkFilter(request.filter, "--filter");
    const int fewest = request.filter.name == kSupersample ? fewestSamples(request.filter.pixelModel) : 1;
    if (request.filter.samples < fewest || request.filter.samples > kMaxSamples) {
        throw InputError("--supersample", Message(MessageId::OutOfRange, {{"what", MessageId::WordSamples},
                                                                          {"value", request.filter.samples},
                                                                          {"range", rangeOf(fewest, kMaxSamples)}}));
    }
    for (const int side : {request.width - 2 * request.margin, request.height - 2 * request.margin}) {
        if (side >= 1 && side <= kMaxPictureSide) continue;
        throw InputError("--size", Message(MessageId::OutOfRange, {{"what", MessageId::WordPictureSide},
                                                                   {"value", side},
                                                                   {"range", rangeOf(1, kMaxPictureSide)}}));
    }
}

std::string sizeSubject(const FrameRequest& request) {
    return "--size " + std::to_string(request.width - 2 * request.margin) + "x" +
           std::to_string(request.height - 2 * request.margin);
}

std::shared_ptr<const TextureFilter> FrameRenderer::madeFilter(const FrameRequest& request, Work& work) {
    const bool levels = needsLevels(request.filter);
    // The levels of another picture are released even if this filter needs none.
    if (levels_ && (request.color ? levels_->picture() != request.color : greyOf_ != request.field.identity())) {
        levels_.reset();
        greyOf_.reset();
    }
    if (!request.color && !levels) return nullptr;
    std::shared_ptr<const ColorImage> picture = request.color;
    if (!picture) {
        picture = levels_ && greyOf_ == request.field.identity() ? levels_->picture() : greyPicture(request.field);
    }
    if (levels && !(levels_ && levels_->picture() == picture)) {
        levels_ = std::make_shared<const ColorLevels>(picture, work);
        greyOf_ = request.color ? nullptr : request.field.identity();
    }
    return makeFilter(request.filter, {picture, levels ? levels_ : nullptr, request.field, request.skip}, *maps_, work);
}

std::shared_ptr<const TextureFilter> FrameRenderer::madePlainFilter(const FrameRequest& request, Work& work) {
    if (!(request.bounded > 0) || !needsLevels(request.filter)) return nullptr;
    return makeFilter({"bilinear", {}}, {levels_->picture(), nullptr, request.field}, *maps_, work);
}

std::unique_ptr<const FlatGround> FrameRenderer::madeGround(const FrameRequest& request, const Tracer& tracer,
                                                            Work& work) {
    const bool traces = tracer.description().kind == MethodKind::Tracer;
    // Only exact methods agree with the intersection of the single cell, and a base level traces a different relief.
    const bool flat = request.skip && tracer.guarantee() == Guarantee::Exact && tracer.baseLevel() == 0;
    if (groundOf_ != request.field.identity()) {
        ground_.reset();
        groundOf_.reset();
    }
    if (!traces || (!flat && !(request.bounded > 0))) return nullptr;
    if (!ground_) {
        ground_ = groundBounds(request.field, work);
        groundOf_ = request.field.identity();
    }
    auto ground = std::make_unique<const FlatGround>(request.field, ground_, flat, request.bounded);
    return ground->never() ? nullptr : std::move(ground);
}

// Returns a cone tracer that finds the max pyramid's hits, if its map has been built for shadows or the filter anyway
// or enough rays were traced to pay for building it.
std::unique_ptr<const PackedConeHits> FrameRenderer::madeConeHits(const FrameRequest& request, const Tracer& tracer,
                                                                  bool readsNeighbours, Work& work) {
    const HeightField& field = request.field;
    if (tracedOf_ != field.identity()) traced_ = 0;
    tracedOf_ = field.identity();
    traced_ += static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
    const bool apt = request.skip && tracer.pyramid() != nullptr && tracer.baseLevel() == 0 &&
                     tracer.guarantee() == Guarantee::Exact && field.tiles() == nullptr &&
                     field.texels() <= PackedConeHits::kMostTexels;
    const bool there = request.shadows || readsNeighbours;
    const bool pays = there || traced_ > PackedConeHits::kRaysPerTexel * field.texels();
    if (!apt || !pays) return nullptr;
    return std::make_unique<const PackedConeHits>(request.field, packedCones(request.field, *maps_, work));
}

// Returns bounds of the horizon by polygon number, null where there are none: those of the last frame where relief and
// light are the same, others if the pixels pay for them.
std::vector<std::shared_ptr<const HorizonBounds>> FrameRenderer::madeHorizons(const FrameRequest& request,
                                                                              const Frame& frame,
                                                                              const VisiblePolygons& visible,
                                                                              Work& work) {
    // A sweep takes a tenth of the time per texel that rays take per pixel.
    constexpr std::size_t kTexelsPerPixel = 8;
    const HeightField& field = request.field;
    const glm::dvec3 toLight = lightDirection(request.light);
    std::vector<std::shared_ptr<const HorizonBounds>> made(frame.polygons.size());
    const auto last = std::exchange(horizons_, {});
    const bool same = last_ && last_->field.identity() == field.identity() && lightDirection(last_->light) == toLight;
    if (!same) litPixels_ = 0;
    litPixels_ += static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
    for (const VisiblePolygon& polygon : visible.polygons) {
        if (!(glm::dot(polygon.quad.normal, toLight) > 0)) continue;
        const glm::dvec2 run = lightRun(polygon.quad, toLight, frame.slabTexels);
        if (!HorizonBounds::suits(field, run)) continue;
        const auto found = std::find_if(last.begin(), last.end(), [&](const auto& bounds) {
            return bounds && bounds->field().identity() == field.identity() && bounds->run() == run &&
                   bounds->field().surface() == field.surface() && bounds->field().address() == field.address();
        });
        std::shared_ptr<const HorizonBounds>& bounds = made[polygon.number];
        if (found != last.end()) {
            bounds = *found;
            continue;
        }
        if (litPixels_ * kTexelsPerPixel < field.texels()) continue;
        bounds = std::make_shared<const HorizonBounds>(field, run, work);
    }
    horizons_ = made;
    return made;
}

// Counts how many of the maps that methods share are not built because nothing reads them.
void FrameRenderer::reportMaps(Frame& frame, const FrameRequest& request, const Tracer& tracer, Work& work) {
    const bool tracesVisibility = frame.filter && frame.filter->description().visible;
    const bool needed[] = {tracer.pyramid() != nullptr || tracesVisibility || request.shadows, tracesVisibility,
                           needsLevels(request.filter)};
    frame.counters[MessageId::CountMapsConsidered] = static_cast<double>(std::size(needed));
    frame.counters[MessageId::CountMapsNotNeeded] =
        request.skip ? static_cast<double>(std::count(needed, std::end(needed), false)) : 0;
    if (request.skip || partOfMore_) return;
    if (!needed[0]) maxPyramidMap(request.field, *maps_, work);
    if (!needed[1]) heightBoundsMap(request.field, *maps_, work);
    if (!needed[2] && request.color) ColorLevels(request.color, work);
}

std::uint32_t FrameRenderer::changedSince(const FrameRequest& request) const {
    // Without skipping, no stage is reused either.
    const bool all = !frame_ || !last_ || !request.skip;
    return all ? (1U << kInputs) - 1 : changedInputs(request, *last_);
}

std::unique_ptr<FrameSetup> FrameRenderer::madeSetup(const FrameRequest& request, std::uint32_t changed,
                                                     std::uint32_t stale, Work& work) {
    auto frame = describedFrame(request);
    auto setup = std::make_unique<FrameSetup>(
        FrameSetup{frame, visiblePolygons(frame->polygons, frame->camera, request.width, request.height,
                                          request.field.reliefDepth(), request.mapping)});
    if (!has(stale, Stage::Rays)) frame->mappingOff = frame_->mappingOff;
    setup->tracer = tracer_;
    if (has(stale, Stage::Hits) || !tracer_) setup->tracer = makeTracer(request.method, request.field, *maps_, work);
    const Tracer& tracer = *setup->tracer;
    frame->shading = tracer.description().shading;
    frame->exactHits = tracer.guarantee() == Guarantee::Exact && tracer.baseLevel() == 0;
    if (frame->shading == ShadingNormal::NormalMap && !request.normals) {
        frame->bakedNormals = bakedNormals(request.field, *maps_, work);
    }
    if (tracer.mesh() != nullptr && has(stale, Stage::Hits)) {
        setup->mesh = std::make_unique<MeshRaster>(*tracer.mesh(), setup->visible, frame->camera, frame->width, work);
    }
    if (request.shadows && has(stale, Stage::Shadows)) {
        setup->query = makeAnyHit(visibilityChoice(request.field), request.field, *maps_, work);
        // Bounds hold for starts on the surface.
        if (request.skip && frame->exactHits && setup->mesh == nullptr) {
            const auto begin = Clock::now();
            setup->horizons = madeHorizons(request, *frame, setup->visible, work);
            setup->horizonTime = (Clock::now() - begin) * work.threads().size();
        }
    }
    const bool newFilter = (changed & kFilterInputs) != 0;
    frame->filter = newFilter ? madeFilter(request, work) : frame_->filter;
    frame->plainFilter = newFilter ? madePlainFilter(request, work) : frame_->plainFilter;
    const bool traces = !setup->mesh && has(stale, Stage::Hits);
    if (traces) setup->ground = madeGround(request, tracer, work);
    reportMaps(*frame, request, tracer, work);
    if (traces)
        setup->coneHits = madeConeHits(request, tracer, frame->filter && frame->filter->readsNeighbours(), work);
    const bool kept = !has(stale, Stage::Hits) && frame_;
    frame->tracedBy = kept ? frame_->tracedBy : setup->coneHits ? PackedConeHits::kMethod : request.method.name;
    return setup;
}

void FrameRenderer::finish(Frame& frame, Clock::time_point begin, Work& work) const {
    frame.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (partOfMore_) return;
    for (const auto& [what, value] : frame.counters) work.counters().add(what, value);
}

std::shared_ptr<const Frame> FrameRenderer::render(const FrameRequest& request, Work& work, const Snapshot& snapshot) {
    const auto begin = Clock::now();
    checkRequest(request);
    // A frame of picture() has no stages to reuse.
    if (frame_ && !frame_->rays) frame_.reset();
    band_.reset();
    const std::uint32_t changed = changedSince(request), stale = staleStages(changed);
    const std::unique_ptr<FrameSetup> setup = madeSetup(request, changed, stale, work);
    const std::shared_ptr<Frame>& frame = setup->frame;
    if (changed == bit(Input::Heights)) {
        setup->kept = keptTiles(request, last_->field, frame_, current_, *frame, setup->visible, stale);
    }

    if (!spare_) spare_ = std::make_shared<FrameBuffers>();
    FrameBuffers buffers = allocateBuffers(*frame, frame_.get(), *spare_, request, setup->mesh != nullptr, stale);
    if (!current_) current_ = std::make_shared<FrameBuffers>();
    buffers.frames = ++current_->frames;
    FrameTotals totals;
    const FrameTools tools = setup->tools();
    const TileWorker worker(request, *frame, tools, buffers, stale, totals);
    if (stale != 0) {
        const std::vector<PixelArea> tiles = tilesOf(frame->width, frame->rows);
        const bool twice = worker.hitsFirst();
        if (twice) overTiles(tiles, false, work, [&](const PixelArea& tile) { worker.findHits(tile, work); });
        if (!partOfMore_) work.progress().begin("frame", static_cast<std::int64_t>(tiles.size()));
        overTiles(tiles, !partOfMore_, work, [&](const PixelArea& tile) {
            if (!twice) worker.findHits(tile, work);
            worker.shade(tile, work);
        });
    }
    totals.nanoseconds[static_cast<std::size_t>(Stage::Shadows)] += setup->horizonTime.count();
    report(*frame, request, setup->visible, totals, stale, setup->mesh != nullptr);
    if (setup->kept) {
        frame->counters[MessageId::CountTiles] = static_cast<double>(setup->kept->stale.size());
        frame->counters[MessageId::CountTilesKept] = static_cast<double>(setup->kept->kept());
    }
    if (request.filter.name == kSupersample && buffers.light) {
        buffers.light->color = supersampled(request, maps_, work, snapshot, frame->counters);
    }
    requireHeights(request.field);
    finish(*frame, begin, work);
    const auto keep = [](auto& current, auto& spare, const auto& made) {
        if (made) spare = std::exchange(current, made);
    };
    keep(current_->rays, spare_->rays, buffers.rays);
    keep(current_->hits, spare_->hits, buffers.hits);
    keep(current_->color, spare_->color, buffers.color);
    keep(current_->shadows, spare_->shadows, buffers.shadows);
    keep(current_->light, spare_->light, buffers.light);
    last_ = request;
    frame_ = frame;
    tracer_ = setup->tracer;
    return request.counts ? counted(work) : frame_;
}

std::shared_ptr<const Frame> FrameRenderer::counted(Work& work) {
    assert(frame_ && frame_->hits && tracer_);
    if (frame_->hits->counted()) return frame_;
    auto frame = std::make_shared<Frame>(*frame_);
    auto hits = std::make_shared<HitStage>(*frame->hits);
    hits->hits.steps.resize(hits->hits.size());
    hits->hits.reads.resize(hits->hits.size());
    frame->hits = hits;
    FrameTotals totals;
    const std::vector<PixelArea> tiles = tilesOf(frame->width, frame->rows);
    if (!partOfMore_) work.progress().begin("frame", static_cast<std::int64_t>(tiles.size()));
    overTiles(tiles, !partOfMore_, work,
              [&](const PixelArea& tile) { countTile(tile, *tracer_, *frame, *hits, totals, work); });
    reportCounts(*frame, totals);
    frame_ = frame;
    return frame_;
}

}  // namespace relief
