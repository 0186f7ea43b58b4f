// Shadows: compared with dense sampling towards the light that shares no code with the query; only what changed is
// computed again.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "algorithms/relief/fields.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

// If the light passes the surface within this height, dense sampling may decide either way.
constexpr double kGraze = 2e-3;

FrameRequest shadowed(const std::string& relief, SceneKind scene = SceneKind::Floor) {
    FrameRequest request(HeightField(share(makeRelief(relief, 64, 48, 1)), Surface::Bilinear, Address::Repeat, 0.15));
    request.width = 120;
    request.height = 90;
    request.scene = scene;
    request.light.elevation = 25;
    request.shadows = true;
    return request;
}

std::shared_ptr<const Frame> rendered(const FrameRequest& request, int threads = 2) {
    Work work(threads);
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

// Shadow queries, and those of them that found an obstacle, by rays or by bounds of the horizon.
double queriesOf(const Frame& frame) {
    return frame.counters.at(MessageId::CountShadowRays) + frame.counters.at(MessageId::CountShadowBounds);
}
double blockedOf(const Frame& frame) {
    return frame.counters.at(MessageId::CountShadowBlocked) + frame.counters.at(MessageId::CountShadowBoundsBlocked);
}

// Returns the largest height of the surface above the line from the hit to the light, sampled every 1/32 texel.
double highestOver(const FrameRequest& request, const TexturedQuad& quad, const Hit& hit) {
    const glm::dvec3 light = lightDirection(request.light);
    const double texel = glm::length(quad.plane.perS);
    const double rise = glm::dot(light, quad.normal) / (request.field.slabTexels() * texel);
    const double alongS = glm::dot(light, quad.plane.perS) / (texel * texel);
    const double alongT = glm::dot(light, quad.plane.perT) / (texel * texel);
    const double length = hit.lambda / rise;
    const int looks = 2 + static_cast<int>(32 * length * std::hypot(alongS, alongT));
    double highest = -1;
    for (int k = 1; k <= looks; ++k) {
        const double way = length * k / looks;
        const double z = 1 - hit.lambda + way * rise;
        highest = std::max(highest, request.field.at(hit.s + way * alongS, hit.t + way * alongT) - z);
    }
    return highest;
}

TEST(Shadows, agreeWithDenseSamplingTowardsTheLight) {
    int allDark = 0;
    for (const char* relief : {"bricks", "hills", "city"}) {
        for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall}) {
            const FrameRequest request = shadowed(relief, scene);
            const auto frame = rendered(request);
            int dark = 0;
            int lit = 0;
            int wrong = 0;
            for (int y = 0; y < frame->height; ++y) {
                for (int x = 0; x < frame->width; ++x) {
                    const std::size_t i = frame->index(x, y);
                    const Hit hit = frame->hits->hits[i];
                    if (hit.outcome != Outcome::Hit) continue;
                    const TexturedQuad& quad = frame->polygons[frame->rays->polygon[i]];
                    if (glm::dot(glm::dvec3(frame->normal(x, y, request)), lightDirection(request.light)) <= 0)
                        continue;
                    const double over = highestOver(request, quad, hit);
                    if (std::abs(over) < kGraze) continue;
                    const bool shade = frame->shadows->shadowed[i] != 0;
                    ++(shade ? dark : lit);
                    wrong += shade != (over > 0) ? 1 : 0;
                }
            }
            std::cout << relief << " " << sceneName(scene) << ": " << dark << " dark, " << lit << " lit\n";
            EXPECT_EQ(wrong, 0) << relief << " " << sceneName(scene);
            EXPECT_GT(lit, 500);
            allDark += dark;
        }
    }
    EXPECT_GT(allDark, 2000);
}

// A lit wall of a column must not shadow itself, however the hit is rounded: artefacts would appear as changes between
// neighbouring pixels of a wall.
TEST(Shadows, litWallsOfColumnsDoNotShadeThemselves) {
    FloatImage heights(8, 8, 0.0F);
    for (int y = 0; y < 8; ++y) heights(4, y) = 1.0F;
    FrameRequest request(HeightField(share(std::move(heights)), Surface::Columns, Address::Clamp, 0.5));
    request.width = 200;
    request.height = 150;
    request.light = {60, 30, 0.2, 1};  // from the right, like the camera
    request.camera.azimuth = 50;
    request.shadows = true;
    const auto frame = rendered(request);
    int wall = 0;
    for (std::size_t i = 0; i < frame->hits->hits.size(); ++i) {
        const Hit hit = frame->hits->hits[i];
        if (hit.outcome != Outcome::Hit || std::abs(hit.s - 5) > 1e-9) continue;
        ++wall;
        EXPECT_EQ(frame->shadows->shadowed[i], 0) << hit.s << "," << hit.t << " at " << hit.lambda;
    }
    EXPECT_GT(wall, 500);
}

TEST(Shadows, onlyTheLightIsDoneAgain) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = shadowed("bricks");
    const auto first = renderer.render(request, work);
    EXPECT_GT(queriesOf(*first), 500);
    EXPECT_GT(blockedOf(*first), 100);
    EXPECT_LE(first->counters.at(MessageId::CountShadowBlocked), first->counters.at(MessageId::CountShadowRays));
    EXPECT_GT(first->counters.at(MessageId::CountShadowBounds), queriesOf(*first) / 2);
    EXPECT_GT(first->counters.at(MessageId::CountShadowAway), 10);
    request.light.azimuth += 40;
    const auto moved = renderer.render(request, work);
    EXPECT_EQ(moved->hits, first->hits);
    EXPECT_EQ(moved->counters.at(MessageId::CountRaysTraced), 0);
    EXPECT_NE(moved->shadows, first->shadows);
    EXPECT_TRUE(moved->light->color == rendered(request)->light->color);
    request.light.ambient = 0.5;
    request.sky = Color(0, 1, 0);
    const auto stronger = renderer.render(request, work);
    EXPECT_EQ(stronger->shadows, moved->shadows) << "the light's intensity does not change shadows";
    EXPECT_TRUE(stronger->light->color == rendered(request)->light->color);
    request.color = std::make_shared<ColorImage>(2, 2, Color(1, 0, 0));
    EXPECT_EQ(renderer.render(request, work)->shadows, moved->shadows);
    request.camera.azimuth += 10;
    const auto turned = renderer.render(request, work);
    EXPECT_NE(turned->shadows, moved->shadows);
    EXPECT_TRUE(turned->light->color == rendered(request)->light->color);
    request.shadows = false;
    const auto without = renderer.render(request, work);
    EXPECT_EQ(without->hits, turned->hits);
    EXPECT_TRUE(without->shadows->shadowed.empty());
    EXPECT_FALSE(without->counters.contains(MessageId::CountShadowRays));
    EXPECT_TRUE(without->light->color == rendered(request)->light->color);
    // The max pyramid, its depths for SIMD, and the cones for shadow rays.
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 3)
        << "the view rays' and the shadow rays', each once";
}

TEST(Shadows, polygonsTurnedAwayFromTheLightAreUnlit) {
    FrameRequest request = shadowed("hills", SceneKind::Wall);
    request.light.azimuth = 180;
    request.light.ambient = 0.3;
    request.light.intensity = 1;
    const auto frame = rendered(request);
    EXPECT_EQ(queriesOf(*frame), 0);
    int seen = 0;
    for (std::size_t i = 0; i < frame->hits->hits.size(); ++i) {
        if (frame->hits->hits.outcome[i] != Outcome::Hit) continue;
        ++seen;
        EXPECT_LE(glm::length(frame->light->color.pixels()[i] - 0.3F * frame->color->color.pixels()[i]), 1e-6F);
    }
    EXPECT_GT(seen, 500);
}

// The hits of approximate methods may lie below the surface: a plane found by them must stay fully lit.
TEST(Shadows, approximateMethodsDoNotShadeThemselves) {
    for (const MethodDescription& method : tracerList()) {
        FrameRequest request = shadowed("hills");
        request.light.elevation = 80;
        request.light.azimuth = 20;
        request.method = {method.name, {}};
        const auto frame = rendered(request);
        EXPECT_LE(blockedOf(*frame), 0.02 * (queriesOf(*frame) + 1)) << method.name;
    }
}

// Without skipping, every shadow query is a ray: the bounds of the horizon change no bit, whatever the light. They are
// kept from frame to frame, but not for another light or relief.
TEST(Shadows, boundsOfTheHorizonAnswerAsRaysDo) {
    double decided = 0, queries = 0, unskipped = 0;
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            Work work(2);
            FrameRenderer renderer(std::make_shared<MapCache>());
            for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
                for (const auto& [azimuth, elevation] : std::vector<std::pair<double, double>>{
                         {-50, 40}, {35, 25}, {90, 15}, {180, 10}, {200, 0.5}, {45, 60}, {-120, 89.99}, {0, 90}}) {
                    const double depth = elevation < 20 ? 0.05 : 0.4;
                    FrameRequest request = shadowed("city", scene);
                    request.field = HeightField(request.field.sharedHeights(), surface, address, depth);
                    request.light.azimuth = azimuth, request.light.elevation = elevation;
                    request.width = 61, request.height = 47;
                    const auto frame = renderer.render(request, work);
                    decided += frame->counters.at(MessageId::CountShadowBounds);
                    queries += queriesOf(*frame);
                    request.skip = false;
                    const auto all = rendered(request);
                    unskipped += queriesOf(*all);
                    EXPECT_EQ(all->counters.at(MessageId::CountShadowBounds), 0);
                    ASSERT_TRUE(frame->light->color == all->light->color)
                        << sceneName(scene) << ", light " << azimuth << "," << elevation << ", depth " << depth;
                }
            }
        }
    }
    std::cout << decided << " of " << queries << " decided by bounds\n";
    EXPECT_GT(decided, queries / 3);
    EXPECT_GT(unskipped, queries) << "hits that face away from the light are queried, too";
}

TEST(Shadows, sameBitsForAnyNumberOfThreads) {
    const FrameRequest request = shadowed("city", SceneKind::Cube);
    EXPECT_EQ(rendered(request, 1)->shadows->shadowed, rendered(request, 3)->shadows->shadowed);
}

}  // namespace
}  // namespace relief::test
