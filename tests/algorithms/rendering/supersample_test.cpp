// The supersampled picture: one sample gives the plain frame, many converge to the geometric solution, weights sum to
// one.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "algorithms/relief/fields.h"
#include "relief/methods/look_up_point.h"
#include "rendering/supersample.h"

namespace relief::test {
namespace {

// Sums of up to 4096 weights near 1, in double.
constexpr double kSumRounding = 1e-12;
// Rounding of a mean in [0, 2] to float.
constexpr double kFloatRounding = 2e-7;

FrameRequest bricks() {
    FrameRequest request(HeightField(share(makeRelief("bricks", 64, 48, 1))));
    request.width = 96;
    request.height = 72;
    return request;
}

std::shared_ptr<const Frame> rendered(const FrameRequest& request, int threads = 2) {
    Work work(threads);
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

FrameRequest supersampledRequest(FrameRequest request, int samples, PixelModel model = PixelModel::Box) {
    request.filter = {std::string(kSupersample), {}, samples, model};
    return request;
}

TEST(Supersample, oneSampleIsThePlainFrame) {
    FrameRequest request = bricks();
    for (const SceneKind scene : {SceneKind::Floor, SceneKind::Cube}) {
        request.scene = scene;
        const auto plain = rendered(request);
        const auto sampled = rendered(supersampledRequest(request, 1));
        EXPECT_TRUE(plain->light->color == sampled->light->color);
        EXPECT_FALSE(plain->light->color == rendered(supersampledRequest(request, 2))->light->color);
    }
}

// Samples are rendered as frames: compared with view rays and colours computed one by one, without the renderer's
// shift.
TEST(Supersample, boxIsTheMeanOfRaysThroughTheParts) {
    constexpr int kSamples = 3;
    const FrameRequest request = bricks();
    const auto sampled = rendered(supersampledRequest(request, kSamples));
    // A picture kSamples times as large has its pixel centres at the samples.
    FrameRequest large = request;
    large.width *= kSamples;
    large.height *= kSamples;
    const auto fine = rendered(large);
    double worst = 0;
    for (int y = 0; y < request.height; ++y) {
        for (int x = 0; x < request.width; ++x) {
            glm::dvec3 sum(0);
            for (int j = 0; j < kSamples; ++j) {
                for (int i = 0; i < kSamples; ++i) {
                    sum += glm::dvec3(fine->light->color(x * kSamples + i, y * kSamples + j));
                }
            }
            const glm::dvec3 apart = sum / 9.0 - glm::dvec3(sampled->light->color(x, y));
            worst = std::max(worst, glm::length(apart));
        }
    }
    // A sample within rounding of a silhouette could differ; this scene has none.
    EXPECT_LE(worst, 1e-5);
}

// The samples shown in the footprint pane: the positions hit by the rays of the pixel's parts, and their weights.
TEST(Supersample, samplesOfAPixelAreTheHitsOfItsParts) {
    constexpr int kSamples = 3;
    FrameRequest request = bricks();
    request.method = {"exact", {}};
    FrameRequest large = request;
    large.width *= kSamples;
    large.height *= kSamples;
    const auto fine = rendered(large);
    Work work(2);
    MapCache maps;
    const auto tracer = makeTracer(request.method, request.field, maps, work);
    request = supersampledRequest(request, kSamples);
    int hits = 0;
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{{48, 40}, {40, 33}, {58, 38}, {48, 0}, {30, 36}}) {
        std::vector<std::pair<double, double>> expected, found;
        for (int part = 0; part < kSamples * kSamples; ++part) {
            const int px = kSamples * x + part % kSamples, py = kSamples * y + part / kSamples;
            const std::size_t i = fine->index(px, py);
            if (!fine->ray(px, py) || fine->hits->hits.outcome[i] != Outcome::Hit) continue;
            const glm::dvec2 place = lookUpPoint(request.field, *fine->ray(px, py), fine->hits->hits[i]);
            expected.emplace_back(place.x, place.y);
        }
        for (const PixelSample& sample : pixelSamples(request, *tracer, x, y, work)) {
            found.emplace_back(sample.place.x, sample.place.y);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(sample.share[channel], 1.0 / (kSamples * kSamples), kFloatRounding);
            }
        }
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found.size(), expected.size()) << x << ' ' << y;
        for (std::size_t k = 0; k < found.size(); ++k) {
            // Cameras of both sizes round differently, most of all far away.
            EXPECT_NEAR(found[k].first, expected[k].first, 1e-6 * (1 + std::abs(expected[k].first)));
            EXPECT_NEAR(found[k].second, expected[k].second, 1e-6 * (1 + std::abs(expected[k].second)));
        }
        hits += static_cast<int>(found.size());
    }
    EXPECT_GT(hits, 3 * kSamples * kSamples);
    // Including the neighbours, the shares of a pixel that sees only relief sum to one.
    request.filter.pixelModel = PixelModel::Gaussian;
    glm::dvec3 sum(0);
    for (const PixelSample& sample : pixelSamples(request, *tracer, 48, 40, work)) sum += glm::dvec3(sample.share);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(sum[channel], 1, 1e-5);
}

// The same samples, weighted independently by the Gaussian over 5 x 5 pixels, in the middle of the picture.
TEST(Supersample, gaussianWeighsNeighbours) {
    constexpr int kSamples = 2;
    const FrameRequest request = bricks();
    const auto sampled = rendered(supersampledRequest(request, kSamples, PixelModel::Gaussian));
    FrameRequest large = request;
    large.width *= kSamples;
    large.height *= kSamples;
    const auto fine = rendered(large);
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{{48, 36}, {30, 50}, {60, 40}, {20, 30}}) {
        glm::dvec3 sum(0);
        double weights = 0;
        for (int j = (y - 2) * kSamples; j < (y + 3) * kSamples; ++j) {
            for (int i = (x - 2) * kSamples; i < (x + 3) * kSamples; ++i) {
                const double dx = (i + 0.5) / kSamples - (x + 0.5);
                const double dy = (j + 0.5) / kSamples - (y + 0.5);
                const double weight = std::exp(-(dx * dx + dy * dy) / (2 * kGaussianSigma * kGaussianSigma));
                sum += weight * glm::dvec3(fine->light->color(i, j));
                weights += weight;
            }
        }
        EXPECT_LE(glm::length(sum / weights - glm::dvec3(sampled->light->color(x, y))), 1e-5) << x << "," << y;
    }
}

TEST(Supersample, aConstantStaysThatConstantToTheEdges) {
    FrameRequest request(HeightField(constantHeights(16, 16, 1.0F)));
    request.width = 40;
    request.height = 30;
    request.camera.elevation = 90;
    request.camera.distance = 0.2;
    request.color = std::make_shared<ColorImage>(8, 8, Color(0.3F, 0.6F, 0.1F));
    const Color expected = rendered(request)->light->color(20, 15);
    for (const PixelModel model : {PixelModel::Box, PixelModel::Gaussian}) {
        for (const int samples : {1, 2, 5, 8}) {
            const auto frame = rendered(supersampledRequest(request, samples, model));
            for (const Color& c : frame->light->color.pixels()) {
                ASSERT_LE(glm::length(c - expected), kFloatRounding) << pixelModelName(model) << " " << samples;
            }
        }
    }
}

// The edge of a white wall against a black sky: the area of each pixel that the wall covers, in closed form from the
// straight edge on the screen.
TEST(Supersample, anEdgeConvergesToItsCoverage) {
    FrameRequest request(HeightField(constantHeights(16, 16, 1.0F)));
    request.width = 64;
    request.height = 48;
    request.scene = SceneKind::Wall;
    request.sky = Color(0);
    request.color = std::make_shared<ColorImage>(1, 1, Color(1));
    request.light = {0, 0, 1, 1};  // ambient light only: uniform illumination
    request.camera.elevation = 20;
    request.camera.azimuth = 30;
    request.camera.distance = 1.2;
    const PinholeCamera camera = requestCamera(request);
    const auto screen = [&](glm::dvec3 point) {
        const glm::dvec3 p = camera.project(point);
        return glm::dvec2(p.x / p.z, p.y / p.z);
    };
    // The wall's corners in either orientation: the sign is determined from its centre.
    const std::vector<glm::dvec2> corners{screen({-0.5, 0.5, 0}), screen({0.5, 0.5, 0}), screen({0.5, -0.5, 0}),
                                          screen({-0.5, -0.5, 0})};
    const auto coverage = [&](int x, int y) {
        // Clips the pixel's square by the wall's four half-planes (Sutherland-Hodgman), then computes its area by the
        // shoelace formula.
        std::vector<glm::dvec2> polygon{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec2 a = corners[k];
            const glm::dvec2 edge = corners[(k + 1) % 4] - a;
            const auto side = [&](glm::dvec2 p) { return edge.x * (p.y - a.y) - edge.y * (p.x - a.x); };
            std::vector<glm::dvec2> kept;
            for (std::size_t n = 0; n < polygon.size(); ++n) {
                const glm::dvec2 p = polygon[n];
                const glm::dvec2 q = polygon[(n + 1) % polygon.size()];
                if (side(p) >= 0) kept.push_back(p);
                if ((side(p) >= 0) != (side(q) >= 0)) kept.push_back(p + side(p) / (side(p) - side(q)) * (q - p));
            }
            polygon = kept;
        }
        double area = 0;
        for (std::size_t n = 0; n < polygon.size(); ++n) {
            const glm::dvec2 p = polygon[n];
            const glm::dvec2 q = polygon[(n + 1) % polygon.size()];
            area += 0.5 * (p.x * q.y - p.y * q.x);
        }
        return area;
    };
    double last = 1;
    for (const int samples : {1, 4, 16, 64}) {
        const auto frame = rendered(supersampledRequest(request, samples));
        double worst = 0;
        int edges = 0;
        for (int y = 0; y < request.height; ++y) {
            for (int x = 0; x < request.width; ++x) {
                const double covered = coverage(x, y);
                edges += covered > 0.01 && covered < 0.99 ? 1 : 0;
                worst = std::max(worst, std::abs(covered - static_cast<double>(frame->light->color(x, y).r)));
            }
        }
        std::cout << samples << " x " << samples << ": at most " << worst << " off\n";
        EXPECT_GT(edges, 50);
        // An edge crosses at most two parts in each of N columns (or rows), each with an error of at most a half.
        EXPECT_LE(worst, 1.0 / samples + 1e-6);
        EXPECT_LT(worst, last);
        last = worst;
    }
    EXPECT_LE(last, 0.01);
}

TEST(Supersample, gaussianWeightsSumToOne) {
    for (const int samples : {1, 2, 3, 8, 64}) {
        double ring = 0;
        double moment = 0;
        double spread = 0;
        for (int i = 0; i < samples; ++i) {
            const double place = (i + 0.5) / samples;
            const auto weights = sampleWeights(PixelModel::Gaussian, PixelAxis::Across, 0, place);
            for (int n = -kGaussianRing; n <= kGaussianRing; ++n) {
                const double weight = weights[static_cast<std::size_t>(n + kGaussianRing)];
                const double distance = place - 0.5 - n;
                ring += weight;
                moment += weight * distance;
                spread += weight * distance * distance;
            }
        }
        EXPECT_NEAR(moment / ring, 0, kSumRounding);
        if (samples > 1) {
            EXPECT_NEAR(std::sqrt(spread / ring), kGaussianSigma, 1e-3);
        }
        // The sums are normalised: a white input gives white.
        SampleSums sums(3, 2, PixelModel::Gaussian);
        Work work(1);
        for (int i = 0; i < samples; ++i) sums.add(ColorImage(7, 6, Color(1)), {(i + 0.5) / samples, 0.3}, work);
        const ColorImage mean = sums.mean(work);
        for (const Color& c : mean.pixels()) EXPECT_EQ(c, Color(1));
    }
    EXPECT_LT(std::exp(-0.5 * kGaussianReach * kGaussianReach / (kGaussianSigma * kGaussianSigma)), 5e-6);
}

// Every part occurs once; after the first k passes, for any k, the samples are well distributed: the largest empty
// square shrinks as 1 / sqrt k.
TEST(Supersample, passesAreWellDistributed) {
    for (int samples = 1; samples <= kMaxSamples; ++samples) {
        const auto order = sampleOrder(samples);
        ASSERT_EQ(order.size(), static_cast<std::size_t>(samples * samples));
        std::vector<int> seen(order.size(), 0);
        for (const glm::ivec2& part : order) ++seen[static_cast<std::size_t>(part.y * samples + part.x)];
        for (const int n : seen) ASSERT_EQ(n, 1) << samples;
    }
    for (const int samples : {8, 13, 64}) {
        const auto order = sampleOrder(samples);
        for (const int k : {4, 16, 49}) {
            glm::dvec2 mean(0);
            double emptiest = 0;
            for (int n = 0; n < k; ++n)
                mean += (glm::dvec2(order[static_cast<std::size_t>(n)]) + 0.5) / double(samples);
            for (int y = 0; y < 20; ++y) {
                for (int x = 0; x < 20; ++x) {
                    const glm::dvec2 p((x + 0.5) / 20, (y + 0.5) / 20);
                    double nearest = 2;
                    for (int n = 0; n < k; ++n) {
                        const glm::dvec2 q = (glm::dvec2(order[static_cast<std::size_t>(n)]) + 0.5) / double(samples);
                        nearest = std::min(nearest, glm::length(p - q));
                    }
                    emptiest = std::max(emptiest, nearest);
                }
            }
            EXPECT_LE(emptiest * std::sqrt(k), 1.35) << samples << " " << k;
            EXPECT_LE(glm::length(mean / double(k) - 0.5), 0.5 / std::sqrt(k)) << samples << " " << k;
        }
    }
}

TEST(Supersample, sameBitsForAnyNumberOfThreads) {
    FrameRequest request = supersampledRequest(bricks(), 3, PixelModel::Gaussian);
    request.shadows = true;
    EXPECT_TRUE(rendered(request, 1)->light->color == rendered(request, 3)->light->color);
}

TEST(Supersample, estimatesComeNearerAndACancelledPictureIsNone) {
    Work work(2);
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = bricks();
    const auto plain = renderer.render(request, work);
    request = supersampledRequest(request, 16);
    std::vector<ColorImage> estimates;
    std::vector<int> reported;
    const auto frame = renderer.render(request, work, [&](const ColorImage& estimate, int done, int total) {
        EXPECT_EQ(total, 256);
        reported.push_back(done);
        estimates.push_back(estimate);
    });
    EXPECT_EQ(reported, (std::vector<int>{1, 2, 4, 8, 16, 32, 64, 128, 192}));
    EXPECT_EQ(frame->hits, plain->hits) << "pixel centres keep their rays";
    EXPECT_EQ(frame->counters.at(MessageId::CountSamples), 256);
    const auto apart = [&](const ColorImage& a) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += glm::length(a.pixels()[i] - frame->light->color.pixels()[i]);
        return sum / static_cast<double>(a.size());
    };
    EXPECT_LT(apart(estimates[4]), 0.3 * apart(estimates[0]));
    EXPECT_LT(apart(estimates[7]), 0.3 * apart(estimates[4]));

    std::stop_source stop;
    Work cancelled(2, stop.get_token());
    FrameRequest other = request;
    other.camera.azimuth += 5;
    EXPECT_THROW(renderer.render(other, cancelled,
                                 [&](const ColorImage&, int done, int) {
                                     if (done == 4) stop.request_stop();
                                 }),
                 Cancelled);
    EXPECT_EQ(renderer.render(request, work)->light, frame->light) << "no incomplete data were kept";
    request.filter.samples = 65;
    EXPECT_THROW(renderer.render(request, work), InputError);
}

}  // namespace
}  // namespace relief::test
