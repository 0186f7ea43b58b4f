// Filtering of the visible part of a footprint: equal to plain filtering on flat maps; skipping is lossless; hidden
// texels are really hidden; closer to the truth behind relief.
#include <gtest/gtest.h>

#include "filter_cases.h"
#include "filtering/elliptical_visible.h"
#include "measuring/bench/bench_filters.h"
#include "relief/reliefs.h"

using namespace relief;
using namespace relief::test;

namespace {

const std::vector<std::string>& forms() {
    static const std::vector<std::string> all{"plane", "position", "position-area"};
    return all;
}

// Filter queries at hits of rays on the field.
std::vector<FilterQuery> queries(const HeightField& field, int count, std::uint64_t seed, double lowest = 8) {
    MapCache maps;
    Work work(1);
    const auto tracer = makeTracer({"max-pyramid", {}}, field, maps, work);
    const RayBlock rays = randomRays(seed, field, static_cast<std::size_t>(count), lowest);
    HitBlock hits;
    NullSink sink;
    tracer->trace(rays, hits, sink, work);
    Random random(seed + 1);
    std::vector<FilterQuery> all;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits.outcome[i] != Outcome::Hit) continue;
        all.push_back({{hits.s[i], hits.t[i]}, randomJacobian(random, 6), rays[i], hits.lambda[i]});
    }
    return all;
}

TEST(Visible, flatMapsGiveThePlainFiltersBits) {
    const Picture picture = randomPicture(48, 40, 1);
    for (const float height : {0.0F, 0.3F, 1.0F}) {
        for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
            const HeightField field = fieldFor(*picture, Address::Repeat, height, surface);
            MadeFilter plain({"elliptical", {}}, picture, field);
            for (const std::string& form : forms()) {
                MadeFilter visible({"elliptical-visible", {{"form", form}}}, picture, field);
                for (const FilterQuery& query : queries(field, 100, 2)) {
                    ASSERT_EQ(plain.at(query), visible.at(query)) << form << " " << height;
                }
                EXPECT_EQ(visible.counts.tested, 0);
            }
        }
    }
}

TEST(Visible, skippingChangesNoBit) {
    std::int64_t skipped = 0;
    std::int64_t hidden = 0;
    for (const char* relief : {"hills", "bricks", "city", "fractal", "columns", "steps"}) {
        const auto heights = std::make_shared<const FloatImage>(makeRelief(relief, 64, 64, 3));
        const Picture picture = randomPicture(64, 64, 4);
        for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
            for (const double depth : {0.002, 0.05}) {
                const HeightField field(heights, surface, Address::Repeat, depth);
                for (const std::string& form : forms()) {
                    const FilterChoice choice{"elliptical-visible", {{"form", form}}};
                    MadeFilter skipping(choice, picture, field);
                    MadeFilter testing(choice, picture, field, false);
                    for (const FilterQuery& query : queries(field, 40, 5)) {
                        FootprintLog log;
                        ASSERT_EQ(skipping.at(query), testing.at(query, &log)) << relief << " " << form << " " << depth;
                        const bool tested = std::any_of(log.texels.begin(), log.texels.end(),
                                                        [](const FootprintTexel& texel) { return texel.tested; });
                        ASSERT_FALSE(log.skipped && tested) << relief << " " << form << " " << depth;
                    }
                    skipped += skipping.counts.skipped;
                    hidden += skipping.counts.hidden;
                    EXPECT_EQ(skipping.counts.hidden, testing.counts.hidden) << relief << " " << form;
                }
            }
        }
    }
    EXPECT_GT(skipped, 1000);
    EXPECT_GT(hidden, 1000);
}

// A distant wall hides ground that is flat all around the footprint: the height range under the footprint alone would
// not show that.
TEST(Visible, aFarWallHidesFlatGround) {
    FloatImage heights(64, 64, 0.1F);
    for (int y = 0; y < 64; ++y) heights(10, y) = 1;
    const HeightField field(std::make_shared<const FloatImage>(heights), Surface::Bilinear, Address::Clamp, 0.25);
    const Picture picture = randomPicture(64, 64, 6);
    // The ray comes from the left over the wall's top, down to the ground behind the edge of its shadow.
    const double a = 20;
    const FilterQuery query{{29.5, 32}, jacobian(8, 3, 0), {29.5 - 0.9 * a, 32, a, 0}, 0.9};
    MadeFilter visible({"elliptical-visible", {{"form", "plane"}}}, picture, field);
    FootprintLog log;
    visible.at(query, &log);
    EXPECT_FALSE(log.skipped);
    int hidden = 0;
    for (const FootprintTexel& texel : log.texels) {
        if (!texel.hidden) continue;
        ++hidden;
        EXPECT_NEAR(texel.blocker.x, 10.5, 1.0);  // the cells next to the wall
        EXPECT_LT(texel.u, log.footprint.centre.x);
    }
    EXPECT_GT(hidden, 3);
    EXPECT_LT(hidden, static_cast<int>(log.texels.size()));
}

// The same wall hides the red third of an lcd pixel: red is the colour at the hit, and the other channels the mean of
// their visible texels. The logged weights sum up to the colour.
TEST(Visible, aChannelThatSeesNothingLeavesTheOthers) {
    FloatImage heights(64, 64, 0.1F);
    for (int y = 0; y < 64; ++y) heights(10, y) = 1;
    const HeightField field(std::make_shared<const FloatImage>(heights), Surface::Bilinear, Address::Clamp, 0.25);
    const Picture picture = randomPicture(64, 64, 6);
    const double a = 20;
    const FilterQuery query{{29.5, 32}, jacobian(12, 6, 0), {29.5 - 0.9 * a, 32, a, 0}, 0.9};
    MadeFilter visible({"elliptical-visible", {{"form", "plane"}, {"weights", "lcd"}, {"levels", "exhaustive"}}},
                       picture, field);
    FootprintLog log;
    const Color color = visible.at(query, &log);
    EXPECT_FALSE(log.allHidden);
    EXPECT_EQ(visible.counts.allHidden, 0);
    EXPECT_GT(visible.counts.hidden, 0);
    EXPECT_EQ(visible.counts.texels, static_cast<std::int64_t>(log.texels.size()) + 2)
        << "two of the four texels at the hit have no weight and are not logged";
    const Color atHit = ColorLevels(picture, visible.work).bilinear(0, query.place, field.address());
    EXPECT_EQ(color.r, atHit.r);
    glm::dvec3 sum(0), total(0);
    for (const FootprintTexel& texel : log.texels) {
        if (texel.hidden) continue;
        sum += glm::dvec3(texel.weight * (*picture)(texel.i, texel.j));
        total += glm::dvec3(texel.weight);
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / total[c], color[c], 1e-5) << c;
    EXPECT_EQ(color, visible.at(query)) << "the log changed it";
}

// Texels reported as hidden are hidden according to an exact traversal from the viewer: the ray through the texel's
// point hits something in front of it.
TEST(Visible, hiddenTexelsAreBehindTheFirstHit) {
    int hidden = 0, seen = 0;
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        const auto heights = std::make_shared<const FloatImage>(makeRelief("city", 64, 64, 3));
        const HeightField field(heights, surface, Address::Repeat, 0.1);
        const Picture picture = randomPicture(64, 64, 4);
        MapCache maps;
        Work work(1);
        const auto exact = makeTracer({"exact", {}}, field, maps, work);
        MadeFilter visible({"elliptical-visible", {{"form", "plane"}, {"levels", "exhaustive"}}}, picture, field);
        for (const FilterQuery& query : queries(field, 150, 7, 20)) {
            FootprintLog log;
            visible.at(query, &log);
            for (const FootprintTexel& texel : log.texels) {
                const double h = field.at(texel.u, texel.v);
                const double lambda = 1 - h;
                const ViewRay ray{texel.u - lambda * query.ray.a, texel.v - lambda * query.ray.b, query.ray.a,
                                  query.ray.b};
                RayBlock one;
                one.push(ray);
                HitBlock hit;
                NullSink sink;
                exact->trace(one, hit, sink, work);
                // A hit within this height difference is the point itself.
                constexpr double kHere = 1e-6;
                if (!texel.tested) continue;
                EXPECT_EQ(texel.hidden, hit.lambda[0] < lambda - kHere) << texel.u << " " << texel.v;
                (texel.hidden ? hidden : seen) += 1;
            }
        }
    }
    EXPECT_GT(hidden, 500);
    EXPECT_GT(seen, 500);
}

// The sum over the visible surface against the supersampled picture: much closer than the plain ellipse. The bounds are
// 1.5 times the ratios measured first (0.18 on bricks, 0.11 on city).
TEST(Visible, nearerToTheTruthBehindRelief) {
    constexpr double kLargestShare = 0.3;
    Work work(2);
    FilterBenchOptions options;
    for (const char* name : {"bricks", "city"}) {
        FilterScene scene = filterScene(name, 128, 1);
        scene.field = HeightField(scene.field.sharedHeights(), Surface::Bilinear, Address::Repeat, 0.05);
        options.scenes.push_back(scene);
    }
    options.filters = {parseFilter("elliptical", "test"), parseFilter("elliptical-visible:form=position-area", "test")};
    options.pixelModels = {PixelModel::Gaussian};
    options.elevations = {30};
    options.width = 64;
    options.height = 48;
    options.samples = 12;
    options.rounds = 1;
    const auto rows = benchFilters(options, work);
    ASSERT_EQ(rows.size(), 4U);
    for (std::size_t n = 0; n < rows.size(); n += 2) {
        EXPECT_LT(rows[n + 1].rmse, kLargestShare * rows[n].rmse) << rows[n].scene << " plain " << rows[n].rmse;
        EXPECT_GT(rows[n + 1].hidden, 0.5) << rows[n].scene;
    }
}

// Rows of columns, every second one higher by a tenth. A ray that runs four texels per slab sees 0.4 texels of each
// wall.
TEST(Visible, wallsCountUnderPixelsOfThousandsOfColumns) {
    FloatImage heights(128, 128);
    ColorImage colors(128, 128);
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) {
            heights(x, y) = x % 2 == 0 ? 0.5F : 0.4F;
            colors(x, y) = x % 2 == 0 ? Color(1, 0, 0) : Color(0, 1, 0);
        }
    }
    const HeightField field(std::make_shared<const FloatImage>(heights), Surface::Columns, Address::Repeat);
    const Picture picture = std::make_shared<const ColorImage>(colors);
    MadeFilter visible({"elliptical-visible", {{"form", "position-area"}, {"levels", "exhaustive"}}}, picture, field);
    for (const double size : {5.0, 26.0, 36.0}) {
        const Color color = visible.at({{64.5, 64}, jacobian(size, size, 0), {62.5, 64, 4, 0}, 0.5});
        EXPECT_NEAR(color.r, 1.4 / 2.4, 0.02) << size;
    }
}

TEST(Visible, boundsHoldEveryHeight) {
    Random random(9);
    for (const auto& [w, h] : std::vector<std::pair<int, int>>{{64, 64}, {37, 21}, {1, 5}, {3, 1}}) {
        auto heights = std::make_shared<FloatImage>(w, h);
        for (float& value : heights->pixels()) value = static_cast<float>(random.unit());
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            const HeightField field(heights, Surface::Bilinear, address);
            MapCache maps;
            Work work(1);
            const auto map = heightBoundsMap(field, maps, work);
            for (int n = 0; n < 200; ++n) {
                const double s0 = random.between(-2.0 * w, 3.0 * w), t0 = random.between(-2.0 * h, 3.0 * h);
                const double s1 = s0 + random.between(0, 1.5 * w), t1 = t0 + random.between(0, 1.5 * h);
                const HeightBounds bounds = heightBounds(*map, field, s0, t0, s1, t1);
                for (int k = 0; k < 40; ++k) {
                    const double z = field.at(random.between(s0, s1), random.between(t0, t1));
                    ASSERT_GE(z, bounds.low - 1e-7);
                    ASSERT_LE(z, bounds.high + 1e-7);
                }
            }
        }
    }
}

}  // namespace
