#include "measuring/advise/shader_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measuring/bench/bench_filters.h"
#include "measuring/compare/flip.h"
#include "measuring/compare/picture_error.h"
#include "measuring/quantiles.h"

namespace relief {

namespace {

constexpr const char* kExact = "max-pyramid";  // the same bits as `exact`, sooner
// Elevations in place of a random view, degrees.
constexpr double kRandomViews[]{20, 55};
constexpr double kAzimuth = 25, kTurn = 137.5;  // of the first view, and between views; degrees
// Of the camera, texture widths: so that a texel is about as large as a pixel.
constexpr double kNearest = 0.3, kFarthest = 1.4;

FrameRequest requestOf(const ShaderAdviceOptions& options, const HeightField& field, double elevation, double azimuth,
                       const std::shared_ptr<const ColorImage>& color) {
    FrameRequest request(field);
    request.width = options.width;
    request.height = options.height;
    request.color = color;
    request.camera.elevation = elevation;
    request.camera.azimuth = azimuth;
    const double seen = 2 * std::tan(request.camera.fov / 2 * std::numbers::pi / 180);  // heights of it, at distance 1
    request.camera.distance = std::clamp(options.height / (seen * field.width()), kNearest, kFarthest);
    return request;
}

// How far a hit's texture appears from its place, pixels: `texels` in texture coordinates by the pixel's neighbours.
double pixelsOf(const Frame& frame, std::size_t pixel, glm::dvec2 texels, const HeightField& field) {
    const auto width = static_cast<std::size_t>(frame.width);
    const std::size_t x = pixel % width, y = pixel / width;
    const std::size_t across = x + 1 < width ? pixel + 1 : pixel - 1;
    const std::size_t down = y + 1 < static_cast<std::size_t>(frame.height) ? pixel + width : pixel - width;
    const auto& polygon = frame.rays->polygon;
    if (polygon[across] != polygon[pixel] || polygon[down] != polygon[pixel]) return 0;
    const RayBlock& rays = frame.rays->rays;
    const auto step = [&](std::size_t to) {
        glm::dvec2 d{rays.s0[to] - rays.s0[pixel], rays.t0[to] - rays.t0[pixel]};
        // Origins are reduced to a period.
        d.x -= std::round(d.x / field.width()) * field.width();
        d.y -= std::round(d.y / field.height()) * field.height();
        return d;
    };
    const glm::dvec2 a = step(across), b = step(down);
    const double area = a.x * b.y - a.y * b.x;
    if (area == 0) return 0;
    return std::hypot(texels.x * b.y - texels.y * b.x, a.x * texels.y - a.y * texels.x) / std::abs(area);
}

}  // namespace

struct ShaderPictures::Totals {
    double flip = 0, worst = 0;
    std::int64_t pixels = 0, displaced = 0;
    std::vector<double> shifts, steps, fetches;
};

ShaderPictures::ShaderPictures(const ShaderAdviceOptions& options, Work& work) {
    const auto color = options.color ? options.color : patchPicture(options.field.heights(), options.seed);
    std::vector<double> elevations;
    for (const Elevation& view : options.views) {
        if (view) elevations.push_back(*view);
    }
    if (elevations.empty()) elevations.assign(std::begin(kRandomViews), std::end(kRandomViews));
    // The seed turns the views.
    double azimuth = kAzimuth + kTurn * static_cast<double>(options.seed % 1000);
    FrameRenderer renderer(std::make_shared<MapCache>(), true);
    for (const double elevation : elevations) {
        Exact exact{requestOf(options, options.field, elevation, std::remainder(azimuth, 360), color), nullptr, {}};
        exact.request.method = {kExact, {}};
        exact.frame = renderer.render(exact.request, work);
        const auto& polygon = exact.frame->rays->polygon;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            if (polygon[i] != kNoPolygon) exact.pixels.push_back(i);
        }
        exact_.push_back(std::move(exact));
        azimuth += kTurn;
    }
}

std::int64_t ShaderPictures::rays() const {
    std::int64_t all = 0;
    for (const Exact& one : exact_) all += static_cast<std::int64_t>(one.pixels.size());
    return all;
}

void ShaderPictures::compare(const Exact& exact, const Frame& frame, Totals& totals, Work& work) const {
    const FloatImage errors = flipErrors(exact.frame->light->color, frame.light->color, kPixelsPerDegree, work);
    double sum = 0;
    for (const std::size_t i : exact.pixels) {
        sum += static_cast<double>(errors.pixels()[i]);
        const Hit right = exact.frame->hits->hits[i], found = frame.hits->hits[i];
        if (right.outcome != found.outcome) {
            ++totals.displaced;
        } else if (right.outcome == Outcome::Hit) {
            const double off = found.lambda - right.lambda;
            const RayBlock& rays = frame.rays->rays;
            const double shift = pixelsOf(frame, i, {off * rays.a[i], off * rays.b[i]}, exact.request.field);
            totals.shifts.push_back(shift);
            if (shift > 1) ++totals.displaced;
        }
    }
    const auto pixels = static_cast<std::int64_t>(exact.pixels.size());
    if (pixels == 0) return;
    totals.flip += sum;
    totals.pixels += pixels;
    totals.worst = std::max(totals.worst, sum / static_cast<double>(pixels));
}

void ShaderPictures::measure(ShaderForm& form, const ShaderStore& store, Work& work) const {
    Totals totals;
    FrameRenderer renderer(store.maps, true);
    for (const Exact& exact : exact_) {
        FrameRequest request = exact.request;
        request.field = store.field;
        request.method = form.method;
        const auto frame = renderer.render(request, work);
        compare(exact, *frame, totals, work);
        constexpr std::size_t kBatch = 4096;
        for (std::size_t begin = 0; begin < exact.pixels.size(); begin += kBatch) {
            work.throwIfStopped();
            const std::size_t end = std::min(exact.pixels.size(), begin + kBatch);
            RayBlock rays(end - begin);
            for (std::size_t k = begin; k < end; ++k) rays.set(k - begin, frame->rays->rays[exact.pixels[k]]);
            HitBlock hits;
            if (form.map == ShaderMap::Maxima) {
                StepLog log;
                renderer.tracer()->trace(rays, hits, log, work);
                for (std::size_t n = 0; n < log.rays(); ++n) {
                    const std::span<const Step> steps(log.steps.data() + log.begin[n], log.begin[n + 1] - log.begin[n]);
                    totals.steps.push_back(static_cast<double>(steps.size()));
                    totals.fetches.push_back(static_cast<double>(pyramidFetches(steps)));
                }
                continue;
            }
            BlockCounts counts;
            renderer.tracer()->trace(rays, hits, counts, work);
            for (std::size_t n = 0; n < hits.size(); ++n) {
                totals.steps.push_back(hits.steps[n]);
                totals.fetches.push_back(
                    static_cast<double>(fetchesOf(form, hits.steps[n], hits.reads[n], hits.outcome[n])));
            }
        }
    }
    if (totals.pixels == 0) {
        form.flip = form.flipWorst = form.displaced = 0;
        return;
    }
    const auto pixels = static_cast<double>(totals.pixels);
    const auto mean = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    constexpr double kMostButFew = 0.99;
    form.flip = totals.flip / pixels;
    form.flipWorst = totals.worst;
    form.displaced = static_cast<double>(totals.displaced) / pixels;
    form.shiftP99 = totals.shifts.empty() ? 0 : quantile(totals.shifts, kMostButFew);
    form.stepsMean = mean(totals.steps);
    form.fetchesMean = mean(totals.fetches);
    form.stepsP99 = quantile(totals.steps, kMostButFew);
    form.fetchesP99 = quantile(totals.fetches, kMostButFew);
    if (form.bounded) return;
    form.mostSteps = static_cast<std::int64_t>(*std::max_element(totals.steps.begin(), totals.steps.end()));
    form.mostFetches = static_cast<std::int64_t>(*std::max_element(totals.fetches.begin(), totals.fetches.end()));
}

}  // namespace relief
