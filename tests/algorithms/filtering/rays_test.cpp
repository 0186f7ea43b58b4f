// elliptical-visible:form=rays: pixels sampled by a fixed number of rays.
#include "filtering/elliptical_rays.h"

#include <gtest/gtest.h>

#include "filter_cases.h"
#include "measuring/bench/bench_filters.h"
#include "relief/reliefs.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 41;
// Nested float sums of 16-bit texels.
constexpr double kRounding = 1e-4;
// The plane's Jacobian is computed from differences of hits, in double; a texel on the rim may be in or out.
constexpr double kSlopeRounding = 2e-3;

// As a multiple of the weights' radius: the outermost of 64 points represent the tail of the whole Gaussian.
constexpr double kReach = 1.25;

FilterChoice rays(const char* samples = "16") {
    return {"elliptical-visible", {{"form", "rays"}, {"samples", samples}}};
}

// Filter queries at hits of rays on the field, as seen by cameras at different elevations.
FilterBlock queries(const HeightField& field, int count, std::uint64_t seed) {
    MapCache maps;
    Work work(1);
    const auto tracer = makeTracer({"max-pyramid", {}}, field, maps, work);
    const RayBlock views = randomRays(seed, field, static_cast<std::size_t>(count), 12);
    HitBlock hits;
    NullSink sink;
    tracer->trace(views, hits, sink, work);
    Random random(seed + 1);
    FilterBlock all;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (hits.outcome[i] != Outcome::Hit) continue;
        all.push({{hits.s[i], hits.t[i]}, randomJacobian(random, 6), views[i], hits.lambda[i], random.between(0, 0.2)});
    }
    return all;
}

HeightField reliefOf(const char* name, Address address = Address::Repeat, Surface surface = Surface::Bilinear) {
    return HeightField(std::make_shared<const FloatImage>(makeRelief(name, 64, 48, kSeed)), surface, address, 0.1);
}

TEST(Rays, thePatternSeesAsWideAsPlainFiltering) {
    for (const char* weights : {"gaussian", "uniform"}) {
        for (const int samples : {8, 11, 16, 64}) {
            EllipticalOptions options;
            options.weights = weights;
            const EllipticalSettings settings = EllipticalSettings::of(options);
            const RayPattern pattern = RayPattern::of(settings, samples);
            ASSERT_EQ(pattern.places.size(), static_cast<std::size_t>(samples));
            glm::dvec2 mean(0);
            glm::dvec3 second(0);
            for (const glm::dvec2& p : pattern.places) {
                mean += p;
                second += glm::dvec3(p.x * p.x, p.y * p.y, p.x * p.y);
                EXPECT_LT(std::hypot(p.x, p.y), kReach * settings.radius) << weights << samples;
            }
            const double whole = weightVariance(settings);
            EXPECT_NEAR(mean.x, 0, 1e-12);
            EXPECT_NEAR(mean.y, 0, 1e-12);
            EXPECT_NEAR(second.x / samples + pattern.blur * pattern.blur * whole, whole, 1e-12);
            EXPECT_NEAR(second.y / samples + pattern.blur * pattern.blur * whole, whole, 1e-12);
            EXPECT_NEAR(second.z, 0, 1e-12);
        }
    }
    // The share that truncation removes, against a sum over the disc.
    const EllipticalSettings settings = EllipticalSettings::of({});
    double sum = 0, total = 0;
    constexpr double kStep = 0.004;
    for (double y = -settings.radius; y <= settings.radius; y += kStep) {
        for (double x = -settings.radius; x <= settings.radius; x += kStep) {
            if (std::hypot(x, y) > settings.radius) continue;
            const double w = std::exp(-(x * x + y * y) / (2 * settings.sigma * settings.sigma));
            sum += w * x * x;
            total += w;
        }
    }
    EXPECT_NEAR(weightVariance(settings), sum / total, 1e-4);
}

TEST(Rays, aConstantPictureStaysConstant) {
    const Color color(0.25F, 0.5F, 0.75F);
    const Picture picture = constantPicture(128, 96, color);
    for (const char* name : {"bricks", "city", "fractal"}) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
                const HeightField field = reliefOf(name, address, surface);
                MadeFilter made(rays(), picture, field);
                const FilterBlock block = queries(field, 200, kSeed);
                for (std::size_t i = 0; i < block.size(); ++i) {
                    const Color got = made.at(block[i]);
                    for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[c], color[c], kRounding) << name << ' ' << i;
                }
                EXPECT_GT(made.counts.tested, 100) << name;
            }
        }
    }
}

TEST(Rays, levelGroundAndSlopesArePlainFiltering) {
    const Picture picture = randomPicture(64, 64, kSeed);
    // Level ground: the same bits.
    for (const float height : {0.0F, 0.4F, 1.0F}) {
        const HeightField field = fieldFor(*picture, Address::Repeat, height);
        MadeFilter plain({"elliptical", {}}, picture, field);
        MadeFilter seen(rays(), picture, field);
        const FilterBlock block = queries(field, 200, kSeed);
        for (std::size_t i = 0; i < block.size(); ++i) ASSERT_EQ(plain.at(block[i]), seen.at(block[i])) << height;
        EXPECT_EQ(seen.counts.tested, 0);
    }
    // A slope: plain filtering with the Jacobian on its plane, J - r (g J) / (1 + r g).
    FloatImage ramp(64, 64);
    constexpr double kSlope = 1.0 / 128;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) ramp(x, y) = static_cast<float>(0.25 + kSlope * x);
    }
    const HeightField field(std::make_shared<const FloatImage>(ramp), Surface::Bilinear, Address::Clamp, 0.1);
    MadeFilter plain({"elliptical", {}}, picture, field);
    MadeFilter seen(rays(), picture, field);
    int tried = 0;
    for (const double run : {-20.0, -4.0, 6.0, 30.0}) {
        const glm::dvec2 place{32.3, 30.1};
        const double lambda = 1 - field.at(place.x, place.y);
        const Jacobian j = jacobian(3, 1.5, 0.4, 0.9);
        const FilterQuery query{place, j, {place.x - lambda * run, place.y, run, 0}, lambda, 0};
        const double alongX = kSlope * j.ux / (1 + run * kSlope), alongY = kSlope * j.uy / (1 + run * kSlope);
        const FilterQuery tilted{place, {j.ux - run * alongX, j.vx, j.uy - run * alongY, j.vy}, query.ray, lambda, 0};
        const Color got = seen.at(query), expected = plain.at(tilted);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], kSlopeRounding) << run;
        ++tried;
    }
    EXPECT_EQ(seen.counts.tested, 0);
    EXPECT_EQ(tried, 4);
}

TEST(Rays, anyPartOfABlockHasTheSameBits) {
    for (const char* name : {"bricks", "hills"}) {
        const Picture picture = randomPicture(128, 96, kSeed);
        const HeightField field = reliefOf(name);
        MadeFilter made(rays("11"), picture, field);
        const FilterBlock block = queries(field, 700, kSeed);
        std::vector<Color> colors(block.size());
        FootprintCounts together, apart;
        made.filter->colors(block, colors, together, made.work);
        EXPECT_GT(together.tested, 0);
        EXPECT_GT(together.flat, 0);
        for (const std::size_t part : {std::size_t{1}, std::size_t{7}, std::size_t{300}}) {
            apart = {};
            for (std::size_t i = 0; i < block.size(); i += part) {
                FilterBlock some;
                for (std::size_t k = i; k < std::min(i + part, block.size()); ++k) some.push(block[k]);
                std::vector<Color> got(some.size());
                made.filter->colors(some, got, apart, made.work);
                for (std::size_t k = 0; k < got.size(); ++k) ASSERT_EQ(got[k], colors[i + k]) << name << ' ' << i + k;
            }
            EXPECT_EQ(apart.texels, together.texels);
            EXPECT_EQ(apart.tested, together.tested);
        }
    }
}

TEST(Rays, framesAreTheSameForAnyNumberOfThreads) {
    FrameRequest request(reliefOf("city"));
    request.width = 200;
    request.height = 120;
    request.color = randomPicture(128, 96, kSeed);
    request.filter = rays();
    request.camera.elevation = 30;
    std::shared_ptr<const Frame> first;
    for (const int threads : {1, 3}) {
        Work work(threads);
        FrameRenderer renderer(std::make_shared<MapCache>());
        const auto frame = renderer.render(request, work);
        if (!first) first = frame;
        EXPECT_TRUE(frame->color->color == first->color->color);
    }
}

// Closer to the truth behind bricks than plain filtering, by the measured factor with some margin.
TEST(Rays, behindBricksTheErrorIsAtMostHalfOfPlain) {
    FilterBenchOptions options;
    options.scenes = {filterScene("bricks", 256, kSeed)};
    options.filters = {{"elliptical", {}}, rays(), rays("8")};
    options.pixelModels = {PixelModel::Gaussian};
    options.elevations = {25};
    options.width = 80;
    options.height = 60;
    options.samples = 8;
    options.rounds = 1;
    Work work(1);
    const auto rows = benchFilters(options, work);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_LT(rows[1].rmse, 0.5 * rows[0].rmse);
    EXPECT_LT(rows[1].rmse, rows[2].rmse);
}

// Samples that miss the relief, here those left of the picture, read nothing; if all do, the colour at the hit is read.
TEST(Rays, onlyTexelsThatAreReadAreCounted) {
    const Picture picture = randomPicture(64, 48, kSeed);
    MadeFilter made(rays(), picture, fieldFor(*picture, Address::Border, 0.5F));
    constexpr double kSide = 0.5;  // so small that samples are read bilinearly
    const auto texelsAt = [&](double s) {
        const std::int64_t before = made.counts.texels;
        made.at({{s, 24}, jacobian(kSide, kSide, 0), {s, 24, 0, 0}, 0.5});
        return made.counts.texels - before;
    };
    constexpr double kNear = 0.1;
    const RayPattern pattern = RayPattern::of(EllipticalSettings::of({}), 16);
    const auto hits = std::count_if(pattern.places.begin(), pattern.places.end(),
                                    [](const glm::dvec2& p) { return kNear + kSide * p.x > 0; });
    EXPECT_GT(hits, 4);
    EXPECT_LT(hits, 12);
    EXPECT_EQ(texelsAt(kNear), 4 * hits);
    EXPECT_EQ(made.counts.allHidden, 0);
    EXPECT_EQ(texelsAt(-5), 4);
    EXPECT_EQ(made.counts.allHidden, 1);
    EXPECT_EQ(made.counts.tested, 2 * 16);
}

// Rays and the grid serve uniform and Gaussian weights only.
TEST(Rays, withOtherWeightsTheTexelsAreReadInstead) {
    const Picture picture = randomPicture(128, 96, kSeed);
    const HeightField field = reliefOf("bricks");
    const FilterBlock block = queries(field, 100, kSeed);
    for (const char* weights : {"texel-distance", "box", "crt"}) {
        const auto made = [&](const char* form) {
            return MadeFilter({"elliptical-visible", {{"form", form}, {"weights", weights}}}, picture, field);
        };
        MadeFilter texels = made("position-area"), rays = made("rays"), grid = made("grid");
        for (std::size_t i = 0; i < block.size(); ++i) {
            const Color expected = texels.at(block[i]);
            ASSERT_EQ(rays.at(block[i]), expected) << weights << " " << i;
            ASSERT_EQ(grid.at(block[i]), expected) << weights << " " << i;
        }
    }
}

// The logged samples sum up to the colour, whether or not the pixel was treated as a plane.
TEST(Rays, theLogSumsUpToTheColour) {
    const Picture picture = randomPicture(128, 96, kSeed);
    const HeightField field = reliefOf("bricks");
    MadeFilter made(rays(), picture, field);
    const ColorLevels levels(picture, made.work);
    const FilterBlock block = queries(field, 300, kSeed);
    int planes = 0, sampled = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        FootprintLog log;
        const Color color = made.at(block[i], &log);
        ASSERT_EQ(color, log.color);
        ASSERT_EQ(color, made.at(block[i])) << "the log changed it";
        (log.skipped ? planes : sampled) += 1;
        if (log.texels.empty()) continue;
        glm::dvec3 sum(0), total(0);
        for (const FootprintTexel& texel : log.texels) {
            sum += glm::dvec3(texel.weight * levels.level(texel.level)(texel.i, texel.j));
            total += glm::dvec3(texel.weight);
        }
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum[c] / total[c], color[c], 2 * kRounding) << i;
    }
    EXPECT_GT(planes, 10);
    EXPECT_GT(sampled, 10);
}

}  // namespace
}  // namespace relief::test
