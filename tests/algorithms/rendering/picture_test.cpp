// Pictures rendered in bands: the bits of whole frames, with few bytes per pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "algorithms/filtering/filter_cases.h"
#include "algorithms/relief/fields.h"
#include "rendering/frame_buffers.h"
#include "rendering/skip_ledger.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 71;
constexpr double kMostBytes = 40;  // per pixel

struct Case {
    std::string name;
    FrameRequest request;
};

// Three bands high, the last with an incomplete row of tiles.
FrameRequest bricks(SceneKind scene = SceneKind::Floor) {
    FrameRequest request(HeightField(share(makeRelief("bricks", 64, 48, 1))));
    request.width = 150;
    request.height = 107;
    request.scene = scene;
    request.camera.elevation = 30;
    return request;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    const auto add = [&](std::string name, FrameRequest request) {
        all.push_back({std::move(name), std::move(request)});
    };
    const auto filtered = [&](FilterChoice filter, bool shadows = false) {
        FrameRequest request = bricks();
        request.color = randomPicture(64, 48, kSeed);
        request.filter = std::move(filter);
        request.shadows = shadows;
        request.light.elevation = 20;
        return request;
    };
    add("plain", bricks(SceneKind::Cube));
    add("bilinear", filtered({"bilinear", {}}, true));
    add("elliptical", filtered({"elliptical", {}}));
    add("grid", filtered({"elliptical-visible", {{"form", "grid"}}}, true));
    add("plane", filtered({"elliptical-visible", {{"form", "plane"}}}));
    add("samples", filtered({std::string(kSupersample), {}, 3, PixelModel::Gaussian}, true));
    FrameRequest mesh = bricks();
    mesh.method.name = "displacement";
    add("mesh", mesh);
    FrameRequest bounded = filtered({"elliptical", {}});
    bounded.bounded = 2;
    add("bounded", bounded);
    // Hits at the top cast no shadow rays.
    FrameRequest plateaus = filtered({"elliptical-visible", {{"form", "grid"}}}, true);
    plateaus.field = HeightField(share(makeRelief("checker", 64, 48, 1)));
    plateaus.camera.distance = 1;
    add("plateaus", plateaus);
    plateaus.skip = false;
    add("no skip", plateaus);
    return all;
}

void expectSamePlanes(const std::vector<NamedPlane>& a, const std::vector<NamedPlane>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
        EXPECT_EQ(a[n].name, b[n].name);
        ASSERT_EQ(a[n].plane.bytes(), b[n].plane.bytes());
        EXPECT_EQ(std::memcmp(a[n].plane.data(), b[n].plane.data(), a[n].plane.bytes()), 0) << a[n].name;
    }
}

// Includes counters, layers and the measured error of bounded skipping.
TEST(Picture, bandsHaveTheBitsOfTheWholeFrame) {
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        const FrameRequest& request = one.request;
        Work wholeWork(2);
        MapCache maps;
        FrameRenderer wholeRenderer(std::make_shared<MapCache>());
        wholeRenderer.render(request, wholeWork);
        const auto whole = wholeRenderer.counted(wholeWork);
        const auto layers = layerPlanes(*whole, request, layerNames(), maps, wholeWork);
        const BoundedError error = measureBounded(*whole, request, maps, wholeWork);
        FrameRenderer renderer(std::make_shared<MapCache>());
        for (const int rows : {32, 64, 0}) {
            SCOPED_TRACE(rows);
            Work work(rows == 32 ? 1 : 2);
            LayerPlanes planes(request, layerNames(), maps);
            BoundedSums bounded;
            int next = 0;
            const auto done = [&](const Frame& part) {
                EXPECT_EQ(part.rows.begin, next);
                next = part.rows.end;
                planes.add(part, request, work);
                bounded.add(part, request, maps, work);
            };
            const auto frame = renderer.picture(request, work, {true, done, rows});
            EXPECT_EQ(next, request.height);
            EXPECT_TRUE(frame->light->color == whole->light->color);
            expectSamePlanes(planes.take(*frame), layers);
            EXPECT_EQ(frame->counters, whole->counters);
            EXPECT_EQ(bounded.error().rays, error.rays);
            EXPECT_EQ(bounded.error().rayMean, error.rayMean);
            EXPECT_EQ(bounded.error().footprints, error.footprints);
            EXPECT_EQ(bounded.error().colorMean, error.colorMean);
        }
    }
}

// One renderer may alternate between both; a picture that is held does not change.
TEST(Picture, framesAndPicturesInTurn) {
    Work work(2);
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = bricks();
    const auto first = renderer.picture(request, work);
    const ColorImage kept = first->light->color;
    request.light.azimuth += 30;
    const auto frame = renderer.render(request, work);
    EXPECT_TRUE(frame->rays != nullptr);
    const auto second = renderer.picture(request, work);
    EXPECT_TRUE(second->light->color == frame->light->color);
    EXPECT_FALSE(kept == frame->light->color);
    EXPECT_TRUE(first->light->color == kept);
}

// Counting traces each ray again, but the picture is made once.
TEST(Picture, progressEndsAtOneWhateverIsDoneWithTheParts) {
    FrameRequest request = bricks();
    request.width = request.height = 64;
    for (const bool counts : {false, true}) {
        std::vector<double> reported;  // the listener is called by one thread at a time
        Work work(2, {}, [&](std::string_view what, double fraction) {
            if (what == "frame") reported.push_back(fraction);
        });
        // What is done with a band may have stages of its own.
        const auto done = [&](const Frame&) {
            work.progress().begin("layer", 1);
            work.progress().advance();
        };
        FrameRenderer(std::make_shared<MapCache>()).picture(request, work, {counts, done, 32});
        ASSERT_FALSE(reported.empty());
        EXPECT_EQ(reported.back(), 1) << counts;
        EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end())) << counts;
    }
}

template <class T>
std::size_t bytesOf(const std::vector<T>& column) {
    return column.capacity() * sizeof(T);
}

std::size_t stageBytes(const Frame& part) {
    const RayBlock& rays = part.rays->rays;
    const HitBlock& hits = part.hits->hits;
    return bytesOf(rays.s0) + bytesOf(rays.t0) + bytesOf(rays.a) + bytesOf(rays.b) + bytesOf(part.rays->polygon) +
           bytesOf(part.rays->inverseDepth) + bytesOf(hits.lambda) + bytesOf(hits.s) + bytesOf(hits.t) +
           bytesOf(hits.outcome) + bytesOf(part.hits->by) + bytesOf(hits.steps) + bytesOf(hits.reads) +
           part.color->color.bytes() + bytesOf(part.shadows->shadowed);
}

// pictureBytes() equals the size of the buffers, and is small for large pictures.
TEST(Picture, bytesAPixel) {
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        FrameRequest request = one.request;
        Work work(2);
        FrameRenderer renderer(std::make_shared<MapCache>());
        std::size_t most = 0;
        const auto frame = renderer.picture(
            request, work, {true, [&](const Frame& part) { most = std::max(most, stageBytes(part)); }, 0});
        const std::size_t pixels = frame->light->color.size();
        EXPECT_EQ(frame->rays, nullptr);
        EXPECT_LE(most + frame->light->color.bytes(), pictureBytes(request, 2));
        EXPECT_GE(most, pixels * (kStageBytes + kCountBytes - (request.shadows ? 0 : 1)));
        for (const int side : {4096, 8192, kMaxPictureSide}) {
            request.width = request.height = side;
            const double bytes = static_cast<double>(pictureBytes(request, 2)) / (static_cast<double>(side) * side);
            // Includes the 8-bit values that are written, by when the sums of samples are freed.
            EXPECT_LE(request.filter.name == kSupersample ? bytes : bytes + 3, kMostBytes) << side;
        }
    }
}

}  // namespace
}  // namespace relief::test
