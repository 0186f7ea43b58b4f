// Rendered pictures with texture coordinates from the row variants of [PERSP].
#include <gtest/gtest.h>

#include "relief/reliefs.h"
#include "rendering/frame.h"
#include "rendering/visible_polygons.h"
#include "scenario/row_methods.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

// Coordinates up to 256 texels in float, a few roundings of them, times 8 for cancellation near the far end of the
// wall.
constexpr double kFloatTexels = 8 * 256 * 0x1p-24 * 16;
// The error that recommendedAnchor() permits.
constexpr double kAnchored = kAnchorError;

FrameRequest wallRequest(const std::string& mapping) {
    FrameRequest request(HeightField(std::make_shared<FloatImage>(makeRelief("bricks", 256, 256, 1)), Surface::Bilinear,
                                     Address::Repeat, 0.1));
    request.scene = SceneKind::Wall;
    request.camera.azimuth = 60;
    request.camera.elevation = 4;
    request.width = 160;
    request.height = 120;
    request.mapping = parseMapping(mapping, "--mapping");
    return request;
}

std::shared_ptr<const Frame> rendered(const FrameRequest& request, int threads = 2) {
    Work work{threads};
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

TEST(Mapping, DirectIsThePictureOfBefore) {
    const FrameRequest plain = wallRequest("direct");
    EXPECT_EQ(plain.mapping, kDirectRows);
    EXPECT_EQ(rendered(plain)->mappingOff, 0);
}

TEST(Mapping, EachVariantIsOffAsItsRowsAre) {
    for (const std::string& name : mappingNames()) {
        const double off = rendered(wallRequest(name))->mappingOff;
        SCOPED_TRACE(name + " " + std::to_string(off));
        if (name == "direct") {
            EXPECT_EQ(off, 0);
        } else if (name == "affine" || name == "subspan") {
            EXPECT_GT(off, kAnchored);
        } else {
            EXPECT_GT(off, 0) << "rows in float are not those in double";
            EXPECT_LT(off, kAnchored + kFloatTexels);
        }
    }
    EXPECT_GT(rendered(wallRequest("affine"))->mappingOff, 10) << "a slanted wall is bent";
    // Rows longer than the anchor interval.
    const auto wide = [](const char* name) {
        FrameRequest request = wallRequest(name);
        request.width = 1600;
        request.height = 1200;
        return rendered(request)->mappingOff;
    };
    EXPECT_GT(wide("incremental:anchor=0"), 2 * wide("incremental"));
}

TEST(Mapping, AFrameThatKeepsItsRaysKeepsTheirError) {
    FrameRequest request = wallRequest("affine");
    Work work{1};
    FrameRenderer renderer(std::make_shared<MapCache>());
    const double off = renderer.render(request, work)->mappingOff;
    request.light.azimuth += 30;
    EXPECT_EQ(renderer.render(request, work)->mappingOff, off);
    request.mapping = kDirectRows;
    EXPECT_EQ(renderer.render(request, work)->mappingOff, 0);
}

// If the camera is not rolled, a row of the floor has constant depth, so affine rows are right.
TEST(Mapping, AffineIsRightWhereDepthIsConstant) {
    FrameRequest request = wallRequest("affine");
    request.scene = SceneKind::Floor;
    request.camera = {};
    request.camera.azimuth = 0;
    EXPECT_LT(rendered(request)->mappingOff, kFloatTexels);
}

TEST(Mapping, TilesAndThreadsDoNotShow) {
    for (const char* name : {"affine", "opposed", "incremental:anchor=0", "subspan:span=7"}) {
        const FrameRequest request = wallRequest(name);
        const auto one = rendered(request, 1), two = rendered(request, 2);
        for (int y = 0; y < request.height; y += 7) {
            for (int x = 0; x < request.width; x += 3) {
                const auto ray = one->ray(x, y);
                ASSERT_EQ(ray, two->ray(x, y)) << name;
                EXPECT_EQ(ray, pixelRay(request, x, y)) << name << ": the pixel's ray is the one that was drawn";
            }
        }
    }
}

TEST(Mapping, ScenariosAndCommandsCarryIt) {
    Scenario scenario;
    scenario.mapping = "subspan:span=32";
    EXPECT_EQ(parseScenario(scenarioText(scenario), "s.json"), scenario);
    EXPECT_NE(renderCommand(scenario).find("--mapping subspan:span=32"), std::string::npos);
    EXPECT_EQ(scenarioText(Scenario{}).find("mapping"), std::string::npos);
    EXPECT_EQ(parseMapping("subspan:span=32", "").span, 32);
    for (const char* wrong : {"fill", "derivatives-cached", "bent", "affine:span=2", "subspan:error=0.5"}) {
        EXPECT_THROW(parseMapping(wrong, "--mapping"), InputError) << wrong;
    }
    try {
        parseMapping("subspan:span=0", "--mapping");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(error.subject(), "--mapping");
    }
    // Triangles are not mapped row by row: their rays are the same as in the rendered picture.
    scenario.method.name = "displacement";
    Assets assets;
    assets.heights = std::make_shared<FloatImage>(makeRelief("bricks", 16, 16, 1));
    EXPECT_EQ(frameRequest(scenario, assets).mapping, kDirectRows);
    scenario.method.name = "exact";
    EXPECT_EQ(frameRequest(scenario, assets).mapping, parseMapping(scenario.mapping, ""));
}

}  // namespace
}  // namespace relief::test
