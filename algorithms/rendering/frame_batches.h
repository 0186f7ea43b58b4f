// Traces a frame's rays again with any method, in batches, so that it can be cancelled and report progress between
// them.
#pragma once

#include <algorithm>
#include <vector>

#include "rendering/frame.h"

namespace relief {

inline constexpr std::size_t kFrameBatch = 1 << 16;

// Calls see(pixel, n-th ray of the batch) after each batch was traced into `hits`. Throws Cancelled.
template <class Sink, class See>
void traceFrame(const Frame& frame, const Tracer& tracer, const char* what, HitBlock& hits, Sink& sink, Work& work,
                const See& see) {
    const std::size_t first = frame.index(0, frame.rows.begin), pixels = frame.index(0, frame.rows.end);
    std::vector<std::size_t> places;
    RayBlock rays;
    work.progress().begin(what, static_cast<std::int64_t>(pixels - first));
    for (std::size_t begin = first; begin < pixels; begin += kFrameBatch) {
        work.throwIfStopped();
        const std::size_t end = std::min(pixels, begin + kFrameBatch);
        places.clear();
        for (std::size_t i = begin; i < end; ++i) {
            if (frame.rays->polygon[i] != kNoPolygon) places.push_back(i);
        }
        rays.resize(places.size());
        for (std::size_t k = 0; k < places.size(); ++k) rays.set(k, frame.rays->rays[places[k]]);
        tracer.trace(rays, hits, sink, work);
        for (std::size_t k = 0; k < places.size(); ++k) see(places[k], k);
        work.progress().advance(static_cast<std::int64_t>(end - begin));
    }
}

}  // namespace relief
