#include "rendering/frame_buffers.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "relief/memory.h"
#include "rendering/frame_tools.h"

namespace relief {

namespace {

// Returns the spare buffer if it has as many pixels and no other owner, or else a new one. A reused buffer still holds
// the data of an older frame.
template <class T>
std::shared_ptr<T> taken(std::shared_ptr<T>& spare, bool fits) {
    // The last owner's reads must have finished before this thread writes.
    if (spare && spare.use_count() == 1 && fits) {
#ifdef __SANITIZE_THREAD__
        // thread sanitizer does not model fences, but it does see reference counts
        const std::shared_ptr<T> counted = spare;
#else
        std::atomic_thread_fence(std::memory_order_acquire);
#endif
        return std::exchange(spare, nullptr);
    }
    spare.reset();
    return std::make_shared<T>();
}

// The blank marks of tiles are valid only for pictures of the same size; without skipping, all tiles are cleared.
template <class T>
void fitTiles(Kept<T>& buffer, const Frame& frame, bool skip) {
    const bool same = buffer.width == frame.width && buffer.height == frame.height;
    if (skip && same) return;
    buffer.width = frame.width, buffer.height = frame.height;
    const auto tiles = static_cast<std::size_t>(tilesAcross(frame.width) * tilesDown(frame.height));
    buffer.blank.assign(tiles, 0);
    buffer.madeFor.assign(tiles, 0);
}

void fit(ColorImage& image, int width, int height) {
    if (image.width() != width || image.height() != height) image = ColorImage(width, height);
}

template <class T>
std::shared_ptr<T>& made(std::shared_ptr<T>& stage) {
    if (!stage) stage = std::make_shared<T>();
    return stage;
}

// Visits every column of a band's stages.
template <class Visit>
void overColumns(FrameBuffers& band, const Visit& visit) {
    RayStage& rays = *band.rays;
    HitStage& hits = *band.hits;
    for (auto* column : {&rays.rays.s0, &rays.rays.t0, &rays.rays.a, &rays.rays.b}) visit(*column);
    for (auto* column : {&hits.hits.lambda, &hits.hits.s, &hits.hits.t}) visit(*column);
    visit(rays.polygon);
    visit(rays.inverseDepth);
    visit(hits.hits.outcome);
    visit(hits.by);
}

}  // namespace

void fitBand(FrameBuffers& band, const Frame& frame, int rows, const FrameRequest& request, bool counts) {
    const auto pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(rows);
    made(band.rays), made(band.hits);
    overColumns(band, [&](auto& column) { column.resize(pixels); });
    for (auto* column : {&band.hits->hits.steps, &band.hits->hits.reads}) column->resize(counts ? pixels : 0);
    fit(made(band.color)->color, frame.width, rows);
    made(band.shadows)->shadowed.resize(request.shadows ? pixels : 0);
    const auto tiles = static_cast<std::size_t>(tilesAcross(frame.width) * tilesDown(rows));
    for (auto* blank : {&band.rays->blank, &band.hits->blank, &band.color->blank}) blank->assign(tiles, 0);
}

void shiftBand(FrameBuffers& band, const Frame& frame, int rows) {
    const std::ptrdiff_t pixels = std::ptrdiff_t{frame.width} * rows;
    const auto up = [&](auto&& column) { std::move(column.begin() + pixels, column.end(), column.begin()); };
    if (pixels > 0) {
        overColumns(band, up);
        up(band.color->color.pixels());
        if (!band.shadows->shadowed.empty()) up(band.shadows->shadowed);
    }
    for (auto* blank : {&band.rays->blank, &band.hits->blank, &band.color->blank}) {
        std::fill(blank->begin(), blank->end(), std::uint8_t{0});
    }
}

std::shared_ptr<LightStage> fitLight(std::shared_ptr<LightStage>& light, const Frame& frame) {
    light = taken(light, true);
    fit(light->color, frame.width, frame.lit.count());
    return light;
}

FrameBuffers allocateBuffers(Frame& frame, const Frame* last, FrameBuffers& spare, const FrameRequest& request,
                             bool mesh, std::uint32_t stale) {
    const auto pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    FrameBuffers buffers;
    const bool fits = spare.rays && spare.rays->polygon.size() == pixels;
    if (has(stale, Stage::Rays) && !fits) {
        requireMemory(byteProduct({pixels, kStageBytes + sizeof(Color)}), sizeSubject(request),
                      MemoryHint::SmallerSize);
    }
    if (has(stale, Stage::Rays)) {
        buffers.rays = taken(spare.rays, fits);
        buffers.rays->rays.resize(pixels);
        buffers.rays->polygon.resize(pixels);
        buffers.rays->inverseDepth.resize(pixels);
        fitTiles(*buffers.rays, frame, request.skip);
    }
    if (has(stale, Stage::Hits)) {
        buffers.hits = taken(spare.hits, spare.hits && spare.hits->by.size() == pixels);
        HitBlock& hits = buffers.hits->hits;
        hits.outcome.resize(pixels);
        for (auto* column : {&hits.lambda, &hits.s, &hits.t}) column->resize(pixels);
        buffers.hits->by.resize(pixels);
        // A mesh counts its triangles as it draws; rays are counted only on request.
        hits.steps.assign(mesh ? pixels : 0, 0);
        hits.reads.assign(mesh ? pixels : 0, 0);
        fitTiles(*buffers.hits, frame, request.skip);
    }
    if (has(stale, Stage::Color)) {
        buffers.color = taken(spare.color, true);
        fit(buffers.color->color, frame.width, frame.height);
        fitTiles(*buffers.color, frame, request.skip);
    }
    if (has(stale, Stage::Shadows)) {
        buffers.shadows = taken(spare.shadows, true);
        buffers.shadows->shadowed.resize(request.shadows ? pixels : 0);
    }
    if (has(stale, Stage::Light)) {
        buffers.light = taken(spare.light, true);
        fit(buffers.light->color, frame.width, frame.height);
    }
    frame.rays = buffers.rays ? buffers.rays : last->rays;
    frame.hits = buffers.hits ? buffers.hits : last->hits;
    frame.color = buffers.color ? buffers.color : last->color;
    frame.shadows = buffers.shadows ? buffers.shadows : last->shadows;
    frame.light = buffers.light ? buffers.light : last->light;
    return buffers;
}

}  // namespace relief
