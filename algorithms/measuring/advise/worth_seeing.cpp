#include "measuring/advise/worth_seeing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "rendering/frame_batches.h"

namespace relief {

namespace {

constexpr const char* kProgressName = "searching for pixels";
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

float distance(const Hit& a, const Hit& b, const ViewRay& ray) {
    if (a.outcome != b.outcome) return std::numeric_limits<float>::infinity();
    if (a.outcome != Outcome::Hit) return 0;
    return static_cast<float>(std::abs(a.lambda - b.lambda) * std::max(1.0, std::hypot(ray.a, ray.b)));
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
    traceFrame(frame, tracer, kProgressName, hits, counts, work,
               [&](std::size_t pixel, std::size_t k) { out[pixel] = static_cast<float>(hits.steps[k]); });
    return out;
}

std::vector<float> disagreement(const Frame& frame, const Tracer& other, Work& work) {
    std::vector<float> out(frame.rays->polygon.size(), kNothing);
    HitBlock hits;
    NullSink sink;
    traceFrame(frame, other, kProgressName, hits, sink, work, [&](std::size_t pixel, std::size_t k) {
        out[pixel] = distance(frame.hits->hits[pixel], hits[k], frame.rays->rays[pixel]);
    });
    return out;
}

}  // namespace relief
