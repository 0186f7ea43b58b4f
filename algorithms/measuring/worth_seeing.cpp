#include "measuring/worth_seeing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace relief {

namespace {

// Rays are traced so many at a time: it can be stopped in between.
constexpr std::size_t kBatch = 1 << 16;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

float distance(const Hit& a, const Hit& b, const ViewRay& ray) {
    if (a.outcome != b.outcome) return std::numeric_limits<float>::infinity();
    if (a.outcome != Outcome::Hit) return 0;
    return static_cast<float>(std::abs(a.lambda - b.lambda) * std::max(1.0, std::hypot(ray.a, ray.b)));
}

// Calls see(pixel, n-th ray of the batch) after each batch of the frame's rays was traced.
template <class Sink, class See>
void traceFrame(const Frame& frame, const Tracer& tracer, HitBlock& hits, Sink& sink, Work& work, const See& see) {
    const std::size_t pixels = frame.rays->polygon.size();
    std::vector<std::size_t> places;
    RayBlock rays;
    work.progress().begin("looking for pixels", static_cast<std::int64_t>(pixels));
    for (std::size_t begin = 0; begin < pixels; begin += kBatch) {
        work.throwIfStopped();
        const std::size_t end = std::min(pixels, begin + kBatch);
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

}  // namespace

std::vector<PixelWorth> largestApart(const std::vector<float>& values, int width, int apart, std::size_t most) {
    std::vector<std::uint32_t> order;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] > 0) order.push_back(static_cast<std::uint32_t>(i));
    }
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] > values[b]; });
    std::vector<PixelWorth> out;
    for (const std::uint32_t i : order) {
        if (out.size() >= most) break;
        const PixelWorth at{static_cast<int>(i) % width, static_cast<int>(i) / width, values[i]};
        const bool near = std::any_of(out.begin(), out.end(), [&](const PixelWorth& other) {
            return std::abs(other.x - at.x) < apart && std::abs(other.y - at.y) < apart;
        });
        if (!near) out.push_back(at);
    }
    return out;
}

std::vector<float> errorWorth(Worth worth, const Frame& frame, const ErrorLayer& errors) {
    std::vector<float> out(errors.texels.size(), kNothing);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const ErrorKind kind = errors.kinds[i];
        const bool hit = frame.hits->hits.outcome[i] == Outcome::Hit;
        if (worth == Worth::Overshoot) {
            const bool past = kind == ErrorKind::Past || (kind == ErrorKind::Wrong && !hit);
            if (past) out[i] = errors.texels[i];
        } else if (std::isfinite(errors.texels[i])) {
            out[i] = errors.texels[i];
        }
    }
    return out;
}

std::vector<float> stepWorth(const Frame& frame, const Tracer& tracer, Work& work) {
    std::vector<float> out(frame.rays->polygon.size(), kNothing);
    HitBlock hits;
    BlockCounts counts;
    traceFrame(frame, tracer, hits, counts, work,
               [&](std::size_t pixel, std::size_t k) { out[pixel] = static_cast<float>(hits.steps[k]); });
    return out;
}

std::vector<float> disagreement(const Frame& frame, const Tracer& other, Work& work) {
    std::vector<float> out(frame.rays->polygon.size(), kNothing);
    HitBlock hits;
    NullSink sink;
    traceFrame(frame, other, hits, sink, work, [&](std::size_t pixel, std::size_t k) {
        out[pixel] = distance(frame.hits->hits[pixel], hits[k], frame.rays->rays[pixel]);
    });
    return out;
}

}  // namespace relief
