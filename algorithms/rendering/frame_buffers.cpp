#include "rendering/frame_buffers.h"

#include <atomic>
#include <utility>

namespace relief {

namespace {

// The spare buffer if it has as many pixels and nobody else holds it, or a new one. What it holds is of an older frame.
template <class T>
std::shared_ptr<T> taken(std::shared_ptr<T>& spare, bool fits) {
    // Whoever held it last has let go before this thread writes.
    if (spare && spare.use_count() == 1 && fits) {
#ifdef __SANITIZE_THREAD__
        const std::shared_ptr<T> counted = spare;  // the sanitizer knows no fences, but sees what a count synchronizes
#else
        std::atomic_thread_fence(std::memory_order_acquire);
#endif
        return std::exchange(spare, nullptr);
    }
    spare.reset();
    return std::make_shared<T>();
}

// What a buffer's tiles hold is known of pictures of one size; without skipping, they are cleared all the same.
template <class T>
void fitTiles(Kept<T>& buffer, const Frame& frame, bool skip) {
    const bool same = buffer.width == frame.width && buffer.height == frame.height;
    if (skip && same) return;
    buffer.width = frame.width, buffer.height = frame.height;
    buffer.blank.assign(static_cast<std::size_t>(tilesAcross(frame.width) * tilesDown(frame.height)), 0);
}

void fit(ColorImage& image, const Frame& frame) {
    if (image.width() != frame.width || image.height() != frame.height) image = ColorImage(frame.width, frame.height);
}

}  // namespace

FrameBuffers allocateBuffers(Frame& frame, const Frame* last, FrameBuffers& spare, const FrameRequest& request,
                             bool mesh, std::uint32_t stale) {
    const auto pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    FrameBuffers buffers;
    if (has(stale, Stage::Rays)) {
        buffers.rays = taken(spare.rays, spare.rays && spare.rays->polygon.size() == pixels);
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
        // A mesh counts its triangles as it draws; rays are counted when somebody asks.
        hits.steps.assign(mesh ? pixels : 0, 0);
        hits.reads.assign(mesh ? pixels : 0, 0);
        fitTiles(*buffers.hits, frame, request.skip);
    }
    if (has(stale, Stage::Color)) {
        buffers.color = taken(spare.color, true);
        fit(buffers.color->color, frame);
        fitTiles(*buffers.color, frame, request.skip);
    }
    if (has(stale, Stage::Shadows)) {
        buffers.shadows = taken(spare.shadows, true);
        buffers.shadows->shadowed.resize(request.shadows ? pixels : 0);
    }
    if (has(stale, Stage::Light)) {
        buffers.light = taken(spare.light, true);
        fit(buffers.light->color, frame);
    }
    frame.rays = buffers.rays ? buffers.rays : last->rays;
    frame.hits = buffers.hits ? buffers.hits : last->hits;
    frame.color = buffers.color ? buffers.color : last->color;
    frame.shadows = buffers.shadows ? buffers.shadows : last->shadows;
    frame.light = buffers.light ? buffers.light : last->light;
    return buffers;
}

}  // namespace relief
