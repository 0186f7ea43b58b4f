// tangent_footprint.h: a footprint reported as clear is not hidden; one reported as planar is visible where its tangent
// plane is.
#include "filtering/tangent_footprint.h"

#include <gtest/gtest.h>

#include "filter_cases.h"
#include "relief/reliefs.h"
#include "relief/visibility/any_hit.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 31;
constexpr int kPoints = 40;
// Footprints have at least two texels: the size of the texels, which the bound includes, is a tenth of that.
constexpr double kTexelAllowance = 1.15;

double runOf(double elevation) {
    constexpr double kDepthTexels = 12;
    return kDepthTexels / std::tan(elevation * 0.017453292519943295);
}

// Level ground with walls of various heights, thin and far apart, so that each hidden point is hidden by a single wall.
FloatImage walls(int width, int height, std::uint64_t seed) {
    constexpr int kApart = 32;
    Random random(seed);
    FloatImage image(width, height, 0.2F);
    for (int x = 0; x < width; x += kApart) {
        const auto wall = static_cast<float>(random.between(0.2, 1));
        for (int y = 0; y < height; ++y) image(x, y) = wall;
    }
    return image;
}

TEST(TangentFootprint, ClearIsNotHiddenAndPlanarIsSeenOnItsPlane) {
    Random random(kSeed);
    int clear = 0, planar = 0, hidden = 0;
    for (const std::string name : {"bricks", "hills", "fractal", "city", "walls"}) {
        for (const Address address : {Address::Repeat, Address::Clamp}) {
            FloatImage heights = name == "walls" ? walls(96, 80, kSeed) : makeRelief(name, 96, 80, kSeed);
            const HeightField field(std::make_shared<const FloatImage>(std::move(heights)), Surface::Bilinear, address);
            Work work(1);
            MapCache maps;
            const auto bounds = heightBoundsMap(field, maps, work);
            const auto query = makeAnyHit({anyHitList().front().name, {}}, field, maps, work);
            const EllipticalSettings settings = EllipticalSettings::of({});
            for (int n = 0; n < 600; ++n) {
                const double elevation = random.between(6, 80), azimuth = random.between(0, 6.3);
                const ViewRay ray{0, 0, runOf(elevation) * std::cos(azimuth), runOf(elevation) * std::sin(azimuth)};
                const Jacobian j = jacobian(random.between(2.5, 6), 2, random.between(0, 3));
                const glm::dvec2 hit{random.between(0, 96), random.between(0, 80)};
                const double h0 = field.at(hit.x, hit.y);
                const TangentFootprint got = tangentFootprint({*bounds, field, settings, {1, 1}}, j, hit, ray, 1 - h0);
                clear += got.clear ? 1 : 0;
                planar += got.planar ? 1 : 0;
                const Jacobian& seen = got.planar ? got.jacobian : j;
                const PixelFromTexel pixel = pixelFromTexel(j), onPlane = pixelFromTexel(seen);
                AnyRayBlock rays;
                for (int p = 0; p < kPoints; ++p) {
                    const double angle = random.between(0, 6.3);
                    const double r = settings.radius * std::sqrt(random.unit());
                    const double x = r * std::cos(angle), y = r * std::sin(angle);
                    const double u = seen.ux * x + seen.uy * y, v = seen.vx * x + seen.vy * y;
                    const double h = field.at(hit.x + u, hit.y + v);
                    rays.push({hit.x + u, hit.y + v, h, -(1 - h) * ray.a, -(1 - h) * ray.b, 1 - h});
                    if (!got.planar) continue;
                    const double su = u + (h - h0) * ray.a, sv = v + (h - h0) * ray.b;
                    EXPECT_LE(std::hypot(pixel.dx(su, sv) - onPlane.dx(u, v), pixel.dy(su, sv) - onPlane.dy(u, v)),
                              kPlanarSpread * kTexelAllowance)
                        << name << ' ' << n;
                }
                VisibilityBlock results;
                NullSink sink;
                query->query(rays, results, sink, work);
                for (std::size_t p = 0; p < rays.size(); ++p) {
                    const bool blocked = results.visibility[p] == Visibility::Blocked;
                    hidden += blocked ? 1 : 0;
                    ASSERT_FALSE(got.clear && blocked) << name << ' ' << n << ' ' << p;
                }
            }
        }
    }
    // Both cases occur.
    EXPECT_GT(clear, 300);
    EXPECT_GT(planar, 15);
    EXPECT_GT(hidden, 10000);
}

TEST(TangentFootprint, ABlockHasTheBitsOfItsPixels) {
    Random random(kSeed + 1);
    const Picture picture = randomPicture(96, 80, kSeed);
    const HeightField field(std::make_shared<const FloatImage>(makeRelief("hills", 96, 80, kSeed)), Surface::Bilinear,
                            Address::Repeat);
    for (const char* form : {"plane", "position", "position-area"}) {
        MadeFilter made({"elliptical-visible", {{"form", form}}}, picture, field);
        FilterBlock block;
        for (int n = 0; n < 300; ++n) {
            const double azimuth = random.between(0, 6.3), run = runOf(random.between(15, 80));
            FilterQuery query;
            query.ray = {0, 0, run * std::cos(azimuth), run * std::sin(azimuth)};
            query.place = {random.between(0, 96), random.between(0, 80)};
            query.lambda = 1 - field.at(query.place.x, query.place.y);
            query.jacobian = jacobian(random.between(0.2, 6), random.between(0.1, 2), random.between(0, 3));
            block.push(query);
        }
        std::vector<Color> colors(block.size());
        FootprintCounts together;
        made.filter->colors(block, colors, together, made.work);
        for (std::size_t i = 0; i < block.size(); ++i) ASSERT_EQ(made.at(block[i]), colors[i]) << form << ' ' << i;
        EXPECT_EQ(together.texels, made.counts.texels) << form;
        EXPECT_EQ(together.skipped, made.counts.skipped) << form;
        EXPECT_EQ(together.flat, made.counts.flat) << form;
    }
}

HeightField fieldOf(double (*height)(int x, int y)) {
    FloatImage image(128, 128);
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) image(x, y) = static_cast<float>(height(x, y));
    }
    return {std::make_shared<const FloatImage>(std::move(image)), Surface::Bilinear, Address::Repeat};
}

// Far from the seams of the repeated field. perColor: texels of the height map per texel of the picture.
TangentFootprint footprintOn(const HeightField& field, const Jacobian& j, const ViewRay& ray, glm::dvec2 perColor) {
    Work work(1);
    MapCache maps;
    const auto bounds = heightBoundsMap(field, maps, work);
    const EllipticalSettings settings = EllipticalSettings::of({});
    return tangentFootprint({*bounds, field, settings, perColor}, j, {40, 88}, ray, 1 - field.at(40, 88));
}

TEST(TangentFootprint, OnAPlaneItIsSeenWhereThePixelsAre) {
    const glm::dvec2 slope(0.003, -0.002), run(60, 40);
    const HeightField field = fieldOf([](int x, int y) { return 0.4 + 0.003 * x - 0.002 * y; });
    const Jacobian j{2, 0.7, -0.5, 1.5};
    const TangentFootprint got = footprintOn(field, j, {0, 0, run.x, run.y}, {1, 1});
    EXPECT_TRUE(got.planar);
    for (const glm::dvec2 pixel : {glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
        const Jacobian& to = got.jacobian;
        const glm::dvec2 at(to.ux * pixel.x + to.uy * pixel.y, to.vx * pixel.x + to.vy * pixel.y);
        const glm::dvec2 seen = at + (slope.x * at.x + slope.y * at.y) * run;
        EXPECT_NEAR(seen.x, j.ux * pixel.x + j.uy * pixel.y, 1e-3);
        EXPECT_NEAR(seen.y, j.vx * pixel.x + j.vy * pixel.y, 1e-3);
    }
}

// Ripples that move the surface by up to a texel in the pixel.
TEST(TangentFootprint, OnlyTexelsThatAreLargeAlongBothAxesHideRipples) {
    const HeightField field = fieldOf([](int x, int) { return x % 2 == 0 ? 0.5 : 0.51; });
    const auto planar = [&](double run, glm::dvec2 perColor) {
        return footprintOn(field, Jacobian{10, 0, 0, 0.2}, {0, 0, 0, run}, perColor).planar;
    };
    EXPECT_TRUE(planar(2, {1, 1}));
    EXPECT_FALSE(planar(5, {1, 1}));
    EXPECT_FALSE(planar(5, {1, 8}));
    EXPECT_FALSE(planar(5, {8, 1}));
    EXPECT_TRUE(planar(5, {8, 8}));
}

}  // namespace
}  // namespace relief::test
