#include "measuring/bench/view_bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "measuring/bench/machine.h"
#include "measuring/quantiles.h"
#include "rendering/error_layer.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kReference = "max-pyramid";  // the same bits as `exact`, sooner

std::int64_t coveredPixels(const Frame& frame) {
    const auto& polygon = frame.rays->polygon;
    return static_cast<std::int64_t>(polygon.size()) - std::count(polygon.begin(), polygon.end(), kNoPolygon);
}

template <class T>
double meanOf(const std::vector<T>& values) {
    double sum = 0;
    for (const T value : values) sum += static_cast<double>(value);
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

// The 95th percentile by nearest rank.
template <class T>
std::int64_t p95Of(std::vector<T> values) {
    if (values.empty()) return 0;
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size())));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), at, values.end());
    return static_cast<std::int64_t>(*at);
}

BenchRow countedRow(const HeightField& field, const MethodChoice& choice, const Tracer& tracer, const RayBlock& rays,
                    const HitBlock& truth, Work& work) {
    HitBlock hits;
    BlockCounts counts;
    tracer.trace(rays, hits, counts, work);
    BenchRow row;
    row.width = field.width();
    row.heightTexels = field.height();
    row.surface = field.surface();
    row.address = field.address();
    row.reliefDepth = field.reliefDepth();
    row.method = choice;
    row.form = tracer.form();
    row.threads = work.threads().size();
    row.errors = tracerErrors(rays, truth, hits);
    row.stepsMean = meanOf(hits.steps);
    row.stepsP95 = p95Of(hits.steps);
    row.stepsMax = *std::max_element(hits.steps.begin(), hits.steps.end());
    row.readsMean = meanOf(hits.reads);
    row.memoryBytes = static_cast<std::int64_t>(tracer.bytes());
    row.compiler = compilerText();
    row.cpu = cpuText();
    row.commit = commitText();
    return row;
}

// Returns a frame of the same view whose hits are those of another method.
Frame retraced(const Frame& frame, const Tracer& tracer, Work& work) {
    auto hits = std::make_shared<HitStage>();
    NullSink sink;
    // The rays of pixels that no polygon covers are undefined.
    const std::size_t pixels = frame.rays->polygon.size();
    RayBlock rays;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (frame.rays->polygon[i] == kNoPolygon) continue;
        places.push_back(i);
        rays.push(frame.rays->rays[i]);
    }
    HitBlock own;
    tracer.trace(rays, own, sink, work);
    hits->hits.resize(pixels);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::size_t i = places[k];
        hits->hits.outcome[i] = own.outcome[k];
        hits->hits.lambda[i] = own.lambda[k];
        hits->hits.s[i] = own.s[k];
        hits->hits.t[i] = own.t[k];
    }
    Frame other = frame;
    other.hits = std::move(hits);
    return other;
}

// Returns the steps of the covered pixels, in the order of pixels.
std::vector<std::int64_t> stepsOf(const Frame& frame, const Tracer& tracer, Work& work) {
    const std::size_t pixels = frame.rays->polygon.size();
    std::vector<std::int64_t> steps;
    RayBlock rays;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (frame.rays->polygon[i] == kNoPolygon) continue;
        if (frame.hits->counted()) {
            steps.push_back(static_cast<std::int64_t>(frame.hits->hits.steps[i]));
        } else {
            rays.push(frame.rays->rays[i]);
        }
    }
    if (rays.size() == 0) return steps;
    HitBlock hits;
    BlockCounts counts;
    tracer.trace(rays, hits, counts, work);
    return {hits.steps.begin(), hits.steps.end()};
}

void fillSteps(FrameHistograms& out, const std::vector<std::int64_t>& steps) {
    constexpr std::int64_t kMostBins = 64;
    out.rays = static_cast<std::int64_t>(steps.size());
    if (steps.empty()) return;
    out.stepsMean = meanOf(steps);
    out.stepsP95 = p95Of(steps);
    out.stepsMost = *std::max_element(steps.begin(), steps.end());
    // The bin width runs through 1, 2, 5, 10, ...
    while (out.stepsMost / out.stepWidth >= kMostBins) {
        int lead = out.stepWidth;
        while (lead >= 10) lead /= 10;
        out.stepWidth = lead == 2 ? out.stepWidth / 2 * 5 : out.stepWidth * 2;
    }
    out.steps.assign(static_cast<std::size_t>(out.stepsMost / out.stepWidth) + 1, 0);
    for (const std::int64_t s : steps) ++out.steps[static_cast<std::size_t>(s / out.stepWidth)];
}

constexpr double kLeast = 1e-9;  // texels; smaller errors lie in the first bin

void fillErrors(FrameHistograms& out, const ErrorLayer& error) {
    double low = std::numeric_limits<double>::infinity();
    for (const float texels : error.texels) {
        if (texels > 0 && std::isfinite(texels)) low = std::min(low, static_cast<double>(texels));
    }
    out.largest = error.largest;
    out.exact = error.counts[static_cast<std::size_t>(ErrorKind::Right)];
    out.wrong = error.counts[static_cast<std::size_t>(ErrorKind::Wrong)];
    if (!std::isfinite(low)) return;
    out.lowDecade = static_cast<int>(std::floor(std::log10(std::max(low, kLeast))));
    // Rounded to float like the single errors, so that the largest error has a bin.
    const std::size_t bins = out.errorBin(static_cast<double>(static_cast<float>(error.largest))) + 1;
    out.before.assign(bins, 0);
    out.behind.assign(bins, 0);
    for (std::size_t i = 0; i < error.texels.size(); ++i) {
        const bool past = error.kinds[i] == ErrorKind::Past;
        if (!past && error.kinds[i] != ErrorKind::Short) continue;
        ++(past ? out.behind : out.before)[std::min(out.errorBin(static_cast<double>(error.texels[i])), bins - 1)];
    }
}

}  // namespace

RayBlock sampledRays(const Frame& frame, std::size_t most) {
    const auto covered = static_cast<double>(coveredPixels(frame));
    const int every = std::max(
        1, static_cast<int>(std::ceil(std::sqrt(covered / static_cast<double>(std::max<std::size_t>(most, 1))))));
    RayBlock rays;
    for (int y = every / 2; y < frame.height; y += every) {
        for (int x = every / 2; x < frame.width; x += every) {
            if (rays.size() < most && frame.rays->polygon[frame.index(x, y)] != kNoPolygon) rays.push(*frame.ray(x, y));
        }
    }
    return rays;
}

std::vector<BenchRow> benchRaysOfView(const HeightField& field, const RayBlock& rays,
                                      const std::vector<MethodChoice>& methods, int rounds, MapCache& maps,
                                      Work& work) {
    std::vector<BenchRow> rows;
    if (rays.size() == 0) return rows;
    std::vector<std::unique_ptr<Tracer>> tracers;
    HitBlock truth;
    NullSink null;
    work.progress().begin("maps", static_cast<std::int64_t>(methods.size()));
    makeTracer({kReference, {}}, field, maps, work)->trace(rays, truth, null, work);
    for (const MethodChoice& choice : methods) {
        work.throwIfStopped();
        if (supports(choice, field.surface(), field.address())) {
            tracers.push_back(makeTracer(choice, field, maps, work));
            rows.push_back(countedRow(field, choice, *tracers.back(), rays, truth, work));
        }
    }
    work.progress().begin("measuring", static_cast<std::int64_t>(tracers.size()) * (rounds + 1));
    std::vector<std::vector<double>> rates(tracers.size());
    HitBlock hits;
    hits.resize(rays.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t m = 0; m < tracers.size(); ++m) {
            work.throwIfStopped();
            const auto begun = Clock::now();
            tracers[m]->trace(rays, hits, null, work);
            const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
            if (round >= 0) rates[m].push_back(static_cast<double>(rays.size()) / seconds);
            work.progress().advance();
        }
    }
    for (std::size_t m = 0; m < rows.size(); ++m) {
        rows[m].rate = quantile(rates[m], 0.5);
        rows[m].spread = relativeSpread(rates[m]);
    }
    return rows;
}

std::optional<PixelPlace> worstPixel(const Frame& frame, const FrameRequest& request, const MethodChoice& method,
                                     MapCache& maps, Work& work) {
    const auto tracer = makeTracer(method, request.field, maps, work);
    const ErrorLayer error = errorAgainstExact(retraced(frame, *tracer, work), request, maps, work);
    std::optional<PixelPlace> worst;
    float most = 0;
    double nearest = 0;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const float texels = error.texels[frame.index(x, y)];
            if (!(texels > 0) || texels < most) continue;
            const double away = std::hypot(x + 0.5 - frame.width / 2.0, y + 0.5 - frame.height / 2.0);
            if (texels == most && worst && away >= nearest) continue;
            most = texels;
            nearest = away;
            worst = PixelPlace{x, y};
        }
    }
    return worst;
}

FrameHistograms frameHistograms(const Frame& frame, const FrameRequest& request, const Tracer& tracer, MapCache& maps,
                                Work& work) {
    FrameHistograms out;
    fillSteps(out, stepsOf(frame, tracer, work));
    fillErrors(out, errorAgainstExact(frame, request, maps, work));
    return out;
}

std::size_t FrameHistograms::errorBin(double texels) const {
    const double place = (std::log10(std::max(texels, kLeast)) - lowDecade) * kErrorBins;
    return static_cast<std::size_t>(std::max(place, 0.0));
}

namespace {

struct RankedPixel {
    double worse = 0;
    double away = 0;  // from the picture's centre
    PixelPlace place;
};

ErrorKind kindOf(HistogramPart part) {
    switch (part) {
        case HistogramPart::Before:
            return ErrorKind::Short;
        case HistogramPart::Behind:
            return ErrorKind::Past;
        case HistogramPart::Wrong:
            return ErrorKind::Wrong;
        default:
            return ErrorKind::Right;
    }
}

}  // namespace

std::vector<PixelPlace> pixelsOfBin(const Frame& frame, const FrameRequest& request, const Tracer& tracer,
                                    const FrameHistograms& data, HistogramBin bin, MapCache& maps, Work& work) {
    std::vector<RankedPixel> found;
    const auto add = [&](int x, int y, double worse) {
        found.push_back({worse, std::hypot(x + 0.5 - frame.width / 2.0, y + 0.5 - frame.height / 2.0), {x, y}});
    };
    const bool bySteps = bin.part == HistogramPart::Steps;
    const std::vector<std::int64_t> steps = bySteps ? stepsOf(frame, tracer, work) : std::vector<std::int64_t>();
    const ErrorLayer error = bySteps ? ErrorLayer() : errorAgainstExact(frame, request, maps, work);
    const bool binned = bin.part == HistogramPart::Before || bin.part == HistogramPart::Behind;
    std::size_t ray = 0;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const std::size_t i = frame.index(x, y);
            if (frame.rays->polygon[i] == kNoPolygon) continue;
            if (bySteps) {
                const std::int64_t count = steps[ray++];
                if (static_cast<std::size_t>(count / data.stepWidth) == bin.bin) add(x, y, static_cast<double>(count));
                continue;
            }
            if (error.kinds[i] != kindOf(bin.part)) continue;
            const auto texels = static_cast<double>(error.texels[i]);
            const std::size_t last = data.before.empty() ? 0 : data.before.size() - 1;
            if (!binned || std::min(data.errorBin(texels), last) == bin.bin) add(x, y, binned ? texels : 0);
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const RankedPixel& a, const RankedPixel& b) {
        return a.worse != b.worse ? a.worse > b.worse : a.away < b.away;
    });
    std::vector<PixelPlace> places;
    for (const RankedPixel& pixel : found) places.push_back(pixel.place);
    return places;
}

}  // namespace relief
