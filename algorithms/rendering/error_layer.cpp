#include "rendering/error_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relief {

namespace {

// The same bits as `exact`, sooner.
constexpr const char* kExactTracer = "max-pyramid";
// Rays are traced so many at a time: progress can be told in between.
constexpr std::size_t kBatch = 1 << 16;

void compare(const Hit& hit, const Hit& exact, const ViewRay& ray, std::size_t pixel, ErrorLayer& out) {
    ErrorKind kind = ErrorKind::Right;
    double texels = 0;
    if (hit.outcome != exact.outcome) {
        kind = ErrorKind::Wrong;
        texels = std::numeric_limits<double>::infinity();
    } else if (hit.outcome == Outcome::Hit && hit.lambda != exact.lambda) {
        kind = hit.lambda > exact.lambda ? ErrorKind::Past : ErrorKind::Short;
        texels = std::abs(hit.lambda - exact.lambda) * std::max(1.0, std::hypot(ray.a, ray.b));
        out.largest = std::max(out.largest, texels);
    }
    out.kinds[pixel] = kind;
    out.texels[pixel] = static_cast<float>(texels);
    ++out.counts[static_cast<std::size_t>(kind)];
}

}  // namespace

ErrorLayer errorAgainstExact(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work) {
    const auto tracer = makeTracer({kExactTracer, {}}, request.field, maps, work);
    const std::size_t pixels = frame.rays->polygon.size();
    ErrorLayer out;
    out.texels.assign(pixels, std::numeric_limits<float>::quiet_NaN());
    out.kinds.assign(pixels, ErrorKind::None);
    work.progress().begin("error against exact", static_cast<std::int64_t>(pixels));
    std::vector<std::size_t> places;
    RayBlock rays;
    HitBlock exact;
    NullSink sink;
    for (std::size_t begin = 0; begin < pixels; begin += kBatch) {
        work.throwIfStopped();
        const std::size_t end = std::min(pixels, begin + kBatch);
        places.clear();
        for (std::size_t i = begin; i < end; ++i) {
            if (frame.rays->polygon[i] != kNoPolygon) places.push_back(i);
        }
        rays.resize(places.size());
        for (std::size_t k = 0; k < places.size(); ++k) rays.set(k, frame.rays->rays[places[k]]);
        tracer->trace(rays, exact, sink, work);
        for (std::size_t k = 0; k < places.size(); ++k) {
            compare(frame.hits->hits[places[k]], exact[k], rays[k], places[k], out);
        }
        work.progress().advance(static_cast<std::int64_t>(end - begin));
    }
    out.counts[0] = std::count(out.kinds.begin(), out.kinds.end(), ErrorKind::None);
    return out;
}

}  // namespace relief
