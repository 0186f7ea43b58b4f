#include "rendering/supersample.h"

#include <cassert>
#include <cmath>

#include "base/parallel.h"
#include "relief/methods/look_up_point.h"

namespace relief {

namespace {

// Estimates are reported after 1, 2, 4, ... passes, and then after every kSnapshotEvery.
constexpr int kSnapshotEvery = 64;

bool toldOf(int done) {
    return (done & (done - 1)) == 0 || done % kSnapshotEvery == 0;
}

}  // namespace

std::vector<glm::ivec2> sampleOrder(int samples) {
    assert(samples >= 1);
    // M. Roberts 2018, R2 sequence: 1/p and 1/p^2 of the plastic number p, a low-discrepancy pair of steps.
    constexpr double kStepX = 0.7548776662466927;
    constexpr double kStepY = 0.5698402909980532;
    const auto count = static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
    std::vector<char> taken(count, 0);
    std::vector<glm::ivec2> order;
    order.reserve(count);
    // The sequence is dense in the square, so it reaches every part; parts already taken are skipped.
    for (double n = 0; order.size() < count; ++n) {
        const double x = 0.5 + n * kStepX;
        const double y = 0.5 + n * kStepY;
        const glm::ivec2 part{static_cast<int>((x - std::floor(x)) * samples),
                              static_cast<int>((y - std::floor(y)) * samples)};
        char& here = taken[static_cast<std::size_t>(part.y) * static_cast<std::size_t>(samples) +
                           static_cast<std::size_t>(part.x)];
        if (here == 0) order.push_back(part);
        here = 1;
    }
    return order;
}

SampleWeights sampleWeights(PixelModel model, PixelAxis axis, int channel, double place) {
    SampleWeights weights{};
    for (int n = -kGaussianRing; n <= kGaussianRing; ++n) {
        const double offset = place - 0.5 - n;
        weights[static_cast<std::size_t>(n + kGaussianRing)] = axis == PixelAxis::Across
                                                                   ? pixelFactorAcross(model, channel, offset)
                                                                   : pixelFactorDown(model, channel, offset);
    }
    return weights;
}

namespace {

// Weights of all channels.
using ChannelWeights = std::array<glm::dvec3, 2 * kGaussianRing + 1>;

ChannelWeights channelWeights(PixelModel model, PixelAxis axis, double place) {
    ChannelWeights weights{};
    for (int c = 0; c < 3; ++c) {
        const SampleWeights one = sampleWeights(model, axis, c, place);
        for (std::size_t n = 0; n < weights.size(); ++n) weights[n][c] = one[n];
    }
    return weights;
}

// Returns the request enlarged by `ring` pixels on every side, whose samples contribute to pixels at the border.
FrameRequest withRing(FrameRequest request, int ring) {
    request.margin += ring;
    request.width += 2 * ring;
    request.height += 2 * ring;
    return request;
}

// Returns the centre of a part of the pixel, [0, 1]^2.
glm::dvec2 samplePlace(glm::ivec2 part, int samples) {
    return (glm::dvec2(part) + 0.5) / static_cast<double>(samples);
}

}  // namespace

SampleSums::SampleSums(int width, int height, PixelModel model, int margin)
    : model_(model), margin_(margin), sums_(width, height, glm::dvec3(0)) {
    assert(margin >= 0 && margin <= kGaussianRing);
}

void SampleSums::add(const ColorImage& pass, glm::dvec2 place, Work& work) {
    assert(pass.width() == sums_.width() + 2 * margin() && pass.height() == sums_.height() + 2 * margin());
    const ChannelWeights across = channelWeights(model_, PixelAxis::Across, place.x);
    const ChannelWeights down = channelWeights(model_, PixelAxis::Down, place.y);
    glm::dvec3 weightAcross(0);
    glm::dvec3 weightDown(0);
    for (const glm::dvec3& w : across) weightAcross += w;
    for (const glm::dvec3& w : down) weightDown += w;
    weight_ += weightAcross * weightDown;
    const int ring = margin();
    parallelFor(work, sums_.height(), [&](int y) {
        std::vector<glm::dvec3> row(static_cast<std::size_t>(pass.width()), glm::dvec3(0));
        // A sample whose own pixel is n pixels left of or above a pixel sees that pixel n to its right or below it.
        for (int n = -ring; n <= ring; ++n) {
            const glm::dvec3 weight = down[static_cast<std::size_t>(kGaussianRing + n)];
            const auto from = pass.row(y + ring - n);
            for (std::size_t x = 0; x < row.size(); ++x) row[x] += weight * glm::dvec3(from[x]);
        }
        for (int x = 0; x < sums_.width(); ++x) {
            glm::dvec3 sum(0);
            for (int n = -ring; n <= ring; ++n) {
                sum +=
                    across[static_cast<std::size_t>(kGaussianRing + n)] * row[static_cast<std::size_t>(x + ring - n)];
            }
            sums_(x, y) += sum;
        }
    });
}

ColorImage SampleSums::mean(Work& work) const {
    ColorImage picture(sums_.width(), sums_.height());
    parallelFor(work, picture.height(), [&](int y) {
        for (int x = 0; x < picture.width(); ++x) picture(x, y) = Color(sums_(x, y) / weight_);
    });
    return picture;
}

std::vector<SamplePass> samplePasses(const FrameRequest& request) {
    const int ring = SampleSums(1, 1, request.filter.pixelModel).margin();
    std::vector<SamplePass> passes;
    glm::dvec3 total(0);
    for (const glm::ivec2 part : sampleOrder(request.filter.samples)) {
        SamplePass pass{withRing(request, ring), {}};
        pass.request.filter = {};
        pass.request.sample = samplePlace(part, request.filter.samples);
        const glm::dvec2 place = pass.request.sample;
        const ChannelWeights across = channelWeights(request.filter.pixelModel, PixelAxis::Across, place.x);
        const ChannelWeights down = channelWeights(request.filter.pixelModel, PixelAxis::Down, place.y);
        for (int m = -ring; m <= ring; ++m) {
            for (int n = -ring; n <= ring; ++n) {
                const glm::dvec3 both = across[static_cast<std::size_t>(kGaussianRing + n)] *
                                        down[static_cast<std::size_t>(kGaussianRing + m)];
                total += both;
                if (both != glm::dvec3(0)) pass.shares.push_back({-n, -m, both});
            }
        }
        passes.push_back(std::move(pass));
    }
    for (SamplePass& pass : passes) {
        for (SampleShare& share : pass.shares) share.share /= total;
    }
    return passes;
}

std::vector<PixelSample> pixelSamples(const FrameRequest& request, const Tracer& tracer, int x, int y, Work& work) {
    const std::vector<TexturedQuad> scene = makeScene(request.scene, request.field.width(), request.field.height());
    RayBlock rays;
    std::vector<glm::dvec3> shares;
    for (const SamplePass& pass : samplePasses(request)) {
        const int ring = pass.request.margin - request.margin;
        const VisiblePolygons visible =
            visiblePolygons(scene, requestCamera(pass.request), pass.request.width, pass.request.height,
                            request.field.reliefDepth(), request.mapping);
        for (const SampleShare& share : pass.shares) {
            const int column = x + ring + share.x, row = y + ring + share.y;
            const VisiblePolygon* const polygon = visible.at(column, row, pass.request.width);
            if (polygon == nullptr) continue;
            rays.push(polygon->entry(column, row).ray);
            shares.push_back(share.share);
        }
    }
    HitBlock hits;
    NullSink sink;
    tracer.trace(rays, hits, sink, work);
    std::vector<PixelSample> samples;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (hits.outcome[i] != Outcome::Hit) continue;
        samples.push_back({lookUpPoint(request.field, rays[i], hits[i]), Color(shares[i])});
    }
    return samples;
}

ColorImage supersampled(const FrameRequest& request, const std::shared_ptr<MapCache>& maps, Work& work,
                        const FrameRenderer::Snapshot& snapshot, std::map<MessageId, double>& counters, RowRange rows) {
    const int samples = request.filter.samples;
    SampleSums sums(request.width, rows.orAll(request.height).count(), request.filter.pixelModel);
    FrameRequest pass = withRing(request, sums.margin());
    pass.filter = {};
    const std::vector<glm::ivec2> order = sampleOrder(samples);
    const int total = samples * samples;
    work.progress().begin("samples", total);
    auto renderer = std::make_unique<FrameRenderer>(maps, true);
    PictureParts parts;
    // The pass begins `margin` rows higher, and every pixel needs the same number of rows above and below it.
    if (!rows.empty()) parts.onlyRows = {rows.begin, rows.end + 2 * sums.margin()};
    for (int done = 0; done < total; ++done) {
        pass.sample = samplePlace(order[static_cast<std::size_t>(done)], samples);
        const auto frame = renderer->picture(pass, work, parts);
        sums.add(frame->light->color, pass.sample, work);
        for (const auto& [one, all] : {std::pair(MessageId::CountRaysTraced, MessageId::CountSampleRays),
                                       std::pair(MessageId::CountSteps, MessageId::CountSampleSteps)}) {
            const auto found = frame->counters.find(one);
            if (found != frame->counters.end()) counters[all] += found->second;
        }
        work.progress().advance();
        if (snapshot && sums.complete() && done + 1 < total && toldOf(done + 1))
            snapshot(sums.mean(work), done + 1, total);
    }
    counters[MessageId::CountSamples] = total;
    // Releases the renderer's buffers before the mean is allocated.
    renderer.reset();
    return sums.mean(work);
}

}  // namespace relief
