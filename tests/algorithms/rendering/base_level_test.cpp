#include "rendering/base_level.h"

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "measuring/bench/base_level_measure.h"
#include "rendering/pinhole.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

FrameRequest request(double distance, int texels) {
    FrameRequest view(
        HeightField(share(makeRelief("hills", texels, texels, 1)), Surface::Bilinear, Address::Repeat, 0.05));
    view.width = 64;
    view.height = 48;
    view.scene = SceneKind::Floor;
    view.camera.elevation = 90;
    view.camera.distance = distance;
    return view;
}

// At twice the distance the pixel is twice as wide: one level more.
TEST(BaseLevel, isThatOfTheNarrowestPixel) {
    const FootprintLevel near = footprintLevel(request(2, 256));
    const FootprintLevel far = footprintLevel(request(4, 256));
    EXPECT_NEAR(far.pixelTexels, 2 * near.pixelTexels, 0.1 * far.pixelTexels);
    EXPECT_EQ(far.level, near.level + 1);
    EXPECT_LE(1 << near.level, near.pixelTexels);
    EXPECT_GT(2 << near.level, near.pixelTexels);
    EXPECT_EQ(footprintLevel(request(2, 16)).level, 0) << "texels wider than pixels";
    FrameRequest away = request(2, 256);
    away.camera.kind = Camera::Kind::Free;
    away.camera.eye = {0, 0, 5};
    away.camera.target = {0, 0, 10};
    EXPECT_EQ(footprintLevel(away).level, 0) << "nothing is seen";
}

// A picture so small that every pixel is examined, seen at an angle: the narrowest pixel lies in a corner.
TEST(BaseLevel, examinesThePixelsThemselves) {
    FrameRequest view = request(0.3, 256);
    view.width = 24;
    view.height = 20;
    view.camera.elevation = 50;
    view.camera.azimuth = 25;
    const TexturedPlane plane = makeScene(view.scene, 256, 256).front().plane;
    const Homography map = fromCameraAndPlane(pinholeCamera(view.camera, view.width, view.height), plane);
    double narrowest = std::numeric_limits<double>::infinity();
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            narrowest = std::min(narrowest, ellipseOf(jacobianAt(map, x + 0.5, y + 0.5)).semiAxes().minor);
        }
    }
    EXPECT_NEAR(footprintLevel(view).pixelTexels, narrowest, 1e-9 * narrowest);
}

TEST(BaseLevel, autoIsReplacedAndNumbersStay) {
    const FrameRequest view = request(4, 256);
    const std::string level = std::to_string(footprintLevel(view).level);
    EXPECT_EQ(methodOfView(view, {"max-pyramid", {{"base", "auto"}}}).options.at("base"), level);
    EXPECT_EQ(methodOfView(view, {"max-pyramid", {{"base", "1"}}}).options.at("base"), "1");
    EXPECT_TRUE(methodOfView(view, {"max-pyramid", {}}).options.empty());
    MapCache cache;
    Work work;
    EXPECT_THROW(makeTracer({"max-pyramid", {{"base", "auto"}}}, view.field, cache, work), InputError);
    EXPECT_THROW(makeTracer({"max-pyramid", {{"base", "self"}}}, view.field, cache, work), InputError);
    EXPECT_THROW(makeTracer({"max-pyramid", {{"base", "32"}}}, view.field, cache, work), InputError);
    EXPECT_EQ(makeTracer({"max-pyramid-paper", {{"base", "2"}}}, view.field, cache, work)->baseLevel(), 2);
}

TEST(BaseLevel, scenariosCarryBothAndRequestsTheNumber) {
    Scenario scenario;
    scenario.pictures.recipe = "hills";
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 64;
    scenario.method = {"max-pyramid", {{"base", "2"}}};
    EXPECT_EQ(parseScenario(scenarioText(scenario), "old.json").method.options.at("base"), "2");
    scenario.method.options["base"] = "auto";
    EXPECT_EQ(parseScenario(scenarioText(scenario), "new.json").method.options.at("base"), "auto");
    AssetStore store;
    Work work;
    const Assets assets = store.load(scenario.pictures, work);
    const std::string base = frameRequest(scenario, assets).method.options.at("base");
    EXPECT_NE(base, "auto");
}

TEST(BaseLevel, errorAndRateAreMeasured) {
    FrameRequest view = request(8, 256);
    view.camera.elevation = 20;  // seen straight down, a ray takes equally many steps on every level
    MapCache cache;
    Work work;
    EXPECT_FALSE(measureBaseLevel(view, {"max-pyramid", {{"base", "1"}}}, cache, work));
    EXPECT_FALSE(measureBaseLevel(view, {"exact", {}}, cache, work));
    const auto measure = measureBaseLevel(view, {"max-pyramid", {{"base", "auto"}}}, cache, work);
    ASSERT_TRUE(measure);
    EXPECT_GT(measure->footprint.level, 0);
    EXPECT_GT(measure->based.errors.max, 0);
    EXPECT_EQ(measure->whole.errors.max, 0);
    EXPECT_LT(measure->based.stepsMean, measure->whole.stepsMean);
    EXPECT_GT(measure->based.rate, 0);
    for (const Language language : {Language::English, Language::Ukrainian}) {
        EXPECT_EQ(sentence(baseLevelSentence(*measure), language).find('{'), std::string::npos);
    }
}

}  // namespace
}  // namespace relief::test
