// Frames: the same bits for any number of threads (reused frames: reuse_test.cpp); a change of the light traces
// nothing; single pixels have the same rays as the frame.
#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "rendering/display.h"
#include "rendering/error_layer.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

FrameRequest brickRequest(SceneKind scene = SceneKind::Floor) {
    FrameRequest request(HeightField(share(makeRelief("bricks", 64, 48, 1))));
    request.width = 160;
    request.height = 120;
    request.scene = scene;
    return request;
}

std::shared_ptr<const Frame> renderFresh(const FrameRequest& request, int threads) {
    Work work(threads);
    FrameRenderer renderer(std::make_shared<MapCache>());
    return renderer.render(request, work);
}

bool samePicture(const Frame& a, const Frame& b) {
    if (!(a.light->color == b.light->color)) return false;
    for (std::size_t i = 0; i < a.hits->hits.size(); ++i) {
        if (!sameBits(a.hits->hits[i], b.hits->hits[i])) return false;
    }
    return true;
}

TEST(Frame, sameBitsForAnyThreadCount) {
    for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
        const FrameRequest request = brickRequest(scene);
        EXPECT_TRUE(samePicture(*renderFresh(request, 1), *renderFresh(request, 2)));
    }
}

TEST(Frame, movingTheLightTracesNoRayAgain) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = brickRequest();
    const auto first = renderer.render(request, work);
    EXPECT_GT(first->counters.at(MessageId::CountRaysTraced), 1000);
    request.light.azimuth += 30;
    const auto lit = renderer.render(request, work);
    EXPECT_EQ(lit->counters.at(MessageId::CountRaysTraced), 0);
    EXPECT_EQ(lit->hits, first->hits);
    EXPECT_EQ(lit->color, first->color);
    EXPECT_NE(lit->light, first->light);
    EXPECT_TRUE(samePicture(*lit, *renderFresh(request, 1)));
    EXPECT_FALSE(lit->light->color == first->light->color);
}

// Buffers of older frames are reused, but those of larger pictures are freed.
TEST(Frame, aSmallerPictureTakesLessMemory) {
    Work work(1);
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = brickRequest();
    for (const int width : {160, 160, 160, 80, 80}) {
        request.width = width;
        request.camera.azimuth += 5;
        const auto frame = renderer.render(request, work);
        const std::size_t pixels = frame->light->color.size();
        EXPECT_EQ(frame->rays->rays.s0.capacity(), pixels);
        EXPECT_EQ(frame->rays->polygon.capacity(), pixels);
        EXPECT_EQ(frame->hits->hits.lambda.capacity(), pixels);
    }
}

TEST(Frame, changingTheDepthKeepsTheMaxPyramid) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = brickRequest();
    renderer.render(request, work);
    // The max pyramid, its depths for SIMD, and the cones, which pay off within the first frame for so few texels.
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 3);
    request.field = HeightField(request.field.sharedHeights(), Surface::Bilinear, Address::Repeat, 0.3);
    renderer.render(request, work);
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 3);
}

TEST(Frame, aSinglePixelGetsTheFramesRay) {
    for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
        const FrameRequest request = brickRequest(scene);
        const auto frame = renderFresh(request, 1);
        int covered = 0;
        for (int y = 0; y < request.height; y += 3) {
            for (int x = 0; x < request.width; x += 3) {
                const auto alone = pixelRay(request, x, y);
                ASSERT_EQ(alone, frame->ray(x, y)) << x << "," << y;
                covered += alone ? 1 : 0;
            }
        }
        EXPECT_GT(covered, 100);
    }
    EXPECT_THROW(pixelRay(brickRequest(), 160, 0), InputError);
}

// A flat relief at the top of the slab is the polygon itself: texture coordinates and depth are known in closed form.
TEST(Frame, aFlatFieldIsThePlane) {
    FrameRequest request(HeightField(constantHeights(32, 32, 1.0F)));
    request.width = 64;
    request.height = 48;
    const auto frame = renderFresh(request, 1);
    int seen = 0;
    for (int y = 0; y < request.height; ++y) {
        for (int x = 0; x < request.width; ++x) {
            const Hit hit = frame->hits->hits[frame->index(x, y)];
            if (hit.outcome != Outcome::Hit) continue;
            ++seen;
            // The floor is y = 0, and one texel is 1/32: the pixel's direction is intersected with it.
            const glm::dvec3 d = frame->camera.rayThrough(x + 0.5, y + 0.5);
            const double distance = -frame->camera.eye.y / d.y;
            const glm::dvec3 p = frame->camera.eye + distance * d;
            EXPECT_NEAR(hit.s, (p.x + 0.5) * 32, 1e-9);
            EXPECT_NEAR(hit.t, (p.z + 0.5) * 32, 1e-9);
            EXPECT_NEAR(frame->depth(x, y), distance, 1e-5 * distance);
        }
    }
    EXPECT_GT(seen, 500);
}

// A floor of depth D with level relief at h looks like a plane that is D (1 - h) lower: the hit must lie on it.
TEST(Frame, aSunkenFloorIsLower) {
    const double reliefDepth = 0.2;
    FrameRequest request(HeightField(constantHeights(32, 32, 0.25F), Surface::Bilinear, Address::Repeat, reliefDepth));
    request.width = 64;
    request.height = 48;
    const auto frame = renderFresh(request, 1);
    for (int y = 0; y < request.height; y += 5) {
        for (int x = 0; x < request.width; x += 5) {
            const Hit hit = frame->hits->hits[frame->index(x, y)];
            if (hit.outcome != Outcome::Hit) continue;
            const glm::dvec3 d = frame->camera.rayThrough(x + 0.5, y + 0.5);
            const double distance = (-0.75 * reliefDepth - frame->camera.eye.y) / d.y;
            const glm::dvec3 p = frame->camera.eye + distance * d;
            EXPECT_NEAR(hit.s, (p.x + 0.5) * 32, 1e-9);
            EXPECT_NEAR(hit.t, (p.z + 0.5) * 32, 1e-9);
            EXPECT_NEAR(frame->depth(x, y), distance, 1e-5 * distance);
        }
    }
}

TEST(Frame, cullsWhatIsNotSeen) {
    FrameRequest request = brickRequest(SceneKind::Cube);
    request.camera.azimuth = 45;
    auto frame = renderFresh(request, 1);
    EXPECT_EQ(frame->counters.at(MessageId::CountPolygons), 6);
    EXPECT_EQ(frame->counters.at(MessageId::CountPolygonsAway), 3);
    request = brickRequest(SceneKind::Floor);
    request.camera.elevation = -30;
    frame = renderFresh(request, 1);
    EXPECT_EQ(frame->counters.at(MessageId::CountPolygonsAway), 1);
    EXPECT_EQ(frame->counters.at(MessageId::CountRaysTraced), 0);
    request.camera.elevation = 30;
    request.camera.target = {50, 0, 0};
    frame = renderFresh(request, 1);
    EXPECT_EQ(frame->counters.at(MessageId::CountPolygonsOff), 1);
}

TEST(Frame, aPlateauNeedsNoTracing) {
    FrameRequest request(HeightField(constantHeights(16, 16, 0.5F)));
    request.width = 40;
    request.height = 30;
    request.counts = true;
    const auto frame = renderFresh(request, 1);
    EXPECT_EQ(frame->counters.at(MessageId::CountRaysTraced), 0);
    EXPECT_EQ(frame->counters.at(MessageId::CountRaysFlat), frame->counters.at(MessageId::CountRays));
    EXPECT_EQ(frame->counters.at(MessageId::CountRaysHighest), 0) << "each ray is counted once";
}

// Counting traces a second time: the same hits, with the counts that each ray's own log has.
TEST(Frame, countsAreMadeOnRequestAndChangeNothing) {
    FrameRequest request = brickRequest();
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    const auto plain = renderer.render(request, work);
    EXPECT_FALSE(plain->hits->counted());
    EXPECT_FALSE(plain->counters.contains(MessageId::CountSteps));
    request.counts = true;
    const auto counted = renderer.render(request, work);
    ASSERT_TRUE(counted->hits->counted());
    EXPECT_EQ(counted->counters.at(MessageId::CountRaysTraced), 0) << "no stage was stale";
    EXPECT_EQ(counted->color, plain->color);
    EXPECT_TRUE(samePicture(*counted, *plain));
    EXPECT_EQ(renderer.counted(work), counted);
    const auto fresh = renderFresh(request, 1);
    EXPECT_EQ(fresh->hits->hits.steps, counted->hits->hits.steps);
    EXPECT_EQ(fresh->hits->hits.reads, counted->hits->hits.reads);
    double steps = 0;
    for (std::size_t i = 0; i < counted->hits->hits.size(); ++i) {
        steps += counted->hits->hits.steps[i];
        if (counted->rays->polygon[i] == kNoPolygon || i % 97 != 0) continue;
        RayBlock ray;
        ray.push(counted->rays->rays[i]);
        HitBlock hit;
        StepLog log;
        renderer.tracer()->trace(ray, hit, log, work);
        EXPECT_EQ(counted->hits->hits.steps[i], log.steps.size());
        EXPECT_EQ(counted->hits->hits.reads[i], log.reads[0]);
    }
    EXPECT_EQ(counted->counters.at(MessageId::CountSteps), steps);
    request.camera.azimuth += 5;
    request.counts = false;
    EXPECT_FALSE(renderer.render(request, work)->hits->counted());
}

TEST(Frame, aCancelledFrameIsNotPublished) {
    FrameRenderer renderer(std::make_shared<MapCache>());
    Work work;
    FrameRequest request = brickRequest();
    const auto first = renderer.render(request, work);
    std::stop_source stop;
    stop.request_stop();
    Work cancelled(1, stop.get_token());
    request.camera.azimuth = 77;
    EXPECT_THROW(renderer.render(request, cancelled), Cancelled);
    request.camera = brickRequest().camera;
    EXPECT_EQ(renderer.render(request, work)->hits, first->hits);
}

TEST(Frame, layersHaveTheirPlanes) {
    FrameRequest request = brickRequest();
    request.counts = true;
    const auto frame = renderFresh(request, 1);
    MapCache maps;
    Work work;
    const auto planes = layerPlanes(*frame, request, layerNames(), maps, work);
    std::vector<std::string> names;
    for (const NamedPlane& plane : planes) names.push_back(plane.name);
    EXPECT_EQ(names, (std::vector<std::string>{"R", "G", "B", "depth.Z", "uv.u", "uv.v", "normal.X", "normal.Y",
                                               "normal.Z", "steps.Y", "outcome.Y", "error.Y", "error.kind",
                                               "footprint.major", "footprint.minor", "hidden.Y"}));
    EXPECT_EQ(planes[0].plane(80, 60), frame->light->color(80, 60).r);
    EXPECT_EQ(planes[10].plane(80, 60), 1.0F);
    EXPECT_THROW(layerPlanes(*frame, request, {"taste"}, maps, work), InputError);
}

// Compared with exact tracing over every cell, ray by ray.
TEST(Frame, errorIsTheWayBetweenTheHits) {
    FrameRequest request = brickRequest();
    for (const char* const method : {"max-pyramid", "layers", "offset"}) {
        request.method = {method, {}};
        if (request.method.name == "layers") request.method.options["layers"] = "6";
        const auto frame = renderFresh(request, 1);
        MapCache maps;
        Work work;
        const ErrorLayer error = errorAgainstExact(*frame, request, maps, work);
        const auto exact = makeTracer({"exact", {}}, request.field, maps, work);
        ASSERT_EQ(error.texels.size(), frame->rays->polygon.size());
        std::array<std::int64_t, kErrorKinds> counts{};
        for (std::size_t i = 0; i < error.texels.size(); ++i) {
            ++counts[static_cast<std::size_t>(error.kinds[i])];
            if (frame->rays->polygon[i] == kNoPolygon) {
                EXPECT_TRUE(std::isnan(error.texels[i]));
                EXPECT_EQ(error.kinds[i], ErrorKind::None);
                continue;
            }
            RayBlock ray;
            ray.push(frame->rays->rays[i]);
            HitBlock truth;
            NullSink sink;
            exact->trace(ray, truth, sink, work);
            const Hit hit = frame->hits->hits[i];
            if (hit.outcome != truth.outcome[0]) {
                EXPECT_EQ(error.kinds[i], ErrorKind::Wrong);
                EXPECT_TRUE(std::isinf(error.texels[i]));
                continue;
            }
            const double by = hit.outcome == Outcome::Hit ? hit.lambda - truth.lambda[0] : 0;
            EXPECT_EQ(error.kinds[i], by > 0 ? ErrorKind::Past : by < 0 ? ErrorKind::Short : ErrorKind::Right);
            const double texels = std::abs(by) * std::max(1.0, std::hypot(ray.a[0], ray.b[0]));
            EXPECT_EQ(error.texels[i], static_cast<float>(texels));
        }
        EXPECT_EQ(counts, error.counts);
        const bool isExact = request.method.name == "max-pyramid";
        EXPECT_EQ(error.largest == 0, isExact) << method;
        EXPECT_EQ(error.counts[static_cast<std::size_t>(ErrorKind::Past)] == 0, isExact) << method;
    }
}

TEST(Display, theTableIsWithinOneCode) {
    std::vector<Color> colors;
    for (int i = 0; i <= 100000; ++i) colors.emplace_back(static_cast<float>(i) / 100000.0F);
    std::vector<std::uint32_t> codes(colors.size());
    toSrgb32(colors, codes);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const double exact = 255.0 * static_cast<double>(srgbFromLinear(colors[i].r));
        EXPECT_NEAR(static_cast<double>(codes[i] & 255U), exact, 1.0);
    }
}

}  // namespace
}  // namespace relief::test
