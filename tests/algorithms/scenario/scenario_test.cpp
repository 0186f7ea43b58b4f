// Scenarios are preserved by the round trip through JSON; invalid ones are refused with the line number.
#include <clocale>
#include <filesystem>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "relief/files.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

Scenario unusual() {
    Scenario s;
    s.pictures.height = "тека з пробілами/висоти.png";
    s.pictures.color = "a'b.jpg";
    s.pictures.reading.channel = "A";
    s.pictures.reading.invert = true;
    s.pictures.reading.range = parseHeightRange("0.125,3.5");
    s.reliefDepth = 0.1 + 0.2;  // not 0.3: every bit must be preserved
    s.address = Address::Border;
    s.surface = Surface::Columns;
    s.method.name = "exact";
    s.filter.name = "nearest";
    s.scene = SceneKind::Cube;
    s.camera.elevation = 1.0 / 3;
    s.light.ambient = 0.1;
    s.sky = {0.1, 0.2, 0.3};
    s.width = 321;
    s.height = 123;
    s.pixel = PixelChoice{320, 7};
    s.step = 5;
    s.breakpoints = {{StopKind::Texel, 3, -1, 7},
                     {StopKind::RayBelow, 2, 0, 0, 1.0 / 3, false},
                     {StopKind::Overshoot},
                     {StopKind::Condition, 2, 0, 0, 0.5, true, 3, "level == 3 && pixel == 4,-5"}};
    Bookmark bookmark{"шпиль", {5, 6}, {}, 9};
    bookmark.camera.azimuth = 0.1;
    s.bookmarks = {bookmark, {"", {0, 0}, {}, 0}};
    s.other = {"rays.csv", "steps.json", 3, false};
    return s;
}

TEST(Scenario, survivesTheRoundTrip) {
    EXPECT_EQ(parseScenario(scenarioText(unusual()), "s.json"), unusual());
    Scenario other = unusual();
    other.pictures = {};
    other.pictures.recipe = "bricks";
    other.pictures.seed = 18446744073709551615ULL;
    other.camera.kind = Camera::Kind::Free;
    other.camera.elevation = Camera().elevation;  // not stored: the free camera has no elevation
    other.pixel.reset();
    EXPECT_EQ(parseScenario(scenarioText(other), "s.json"), other);
}

// Paths in a scenario are relative to its folder, whatever the working folder.
TEST(Scenario, anotherTracersFilesAreNamedFromItsFolder) {
    const testing::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "other");
    Scenario scenario;
    scenario.other = {folder / "other/rays.csv", folder / "other/steps.json", 3, false};
    saveScenario(folder / "s.json", scenario);
    const std::string text = readTextFile(folder / "s.json");
    EXPECT_NE(text.find("\"other/rays.csv\""), std::string::npos) << text;
    EXPECT_NE(text.find("\"other/steps.json\""), std::string::npos) << text;
    const Scenario back = loadScenario(folder / "s.json");
    EXPECT_TRUE(std::filesystem::path(back.other.rays).lexically_normal() == (folder / "other/rays.csv"));
    EXPECT_TRUE(std::filesystem::path(back.other.steps).lexically_normal() == (folder / "other/steps.json"));
}

Scenario drawn() {
    Scenario s = unusual();
    s.pictures = {};
    s.pictures.drawn = {3, 2, {0, 1, 0.1 + 0.2, 0.125, 1.0 / 3, 1}};
    s.comparison.others = {{"layers", {{"layers", "32"}}}, {"exact", {}}};
    s.comparison.subject = CompareSubject::Filters;
    s.comparison.filters = {{"supersample", {{"samples", "3"}}}};
    s.comparison.mappings = {{"incremental", {{"anchor", "0"}}}};
    s.comparison.heights = {{"quantised", {{"bits", "6"}}}};
    s.comparison.mode = CompareMode::Swipe;
    s.comparison.measure = CompareMeasure::L1;
    s.comparison.reference = CompareReference::MethodA;
    s.comparison.dividers = {0.25, 1.0 / 3};
    s.comparison.rate = 0.7;
    return s;
}

TEST(Scenario, DrawnReliefAndComparisonSurviveTheRoundTrip) {
    EXPECT_EQ(parseScenario(scenarioText(drawn()), "s.json"), drawn());
    Scenario profile = drawn();
    profile.pictures.drawn = {4, 3, {0, 0.5, 1, 0.25}};
    const Scenario back = parseScenario(scenarioText(profile), "s.json");
    EXPECT_EQ(back, profile);
    Work work;
    AssetStore store;
    const FloatImage& heights = *store.load(back.pictures, work).heights;
    ASSERT_EQ(heights.width(), 4);
    ASSERT_EQ(heights.height(), 3);
    for (int j = 0; j < 3; ++j) EXPECT_EQ(heights(3, j), 0.25F);
    // Another height makes it another picture.
    profile.pictures.drawn.heights[3] = 0.75;
    EXPECT_EQ((*store.load(profile.pictures, work).heights)(3, 1), 0.75F);
}

TEST(Scenario, pathsAreRelativeToTheFile) {
    const Scenario read =
        parseScenario(R"({"reliefscope": 1, "pictures": {"height": "a/b.png"}})", "/some/where/s.json");
    EXPECT_EQ(read.pictures.height, "/some/where/a/b.png");
    EXPECT_NE(scenarioText(read, "/some/where").find("\"a/b.png\""), std::string::npos);
}

TEST(Scenario, numbersDoNotFollowTheLocale) {
    if (std::setlocale(LC_ALL, "uk_UA.UTF-8") == nullptr) GTEST_SKIP() << "locale uk_UA.UTF-8 is not installed";
    const std::string text = scenarioText(unusual());
    const Scenario back = parseScenario(text, "s.json");
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(text, scenarioText(unusual()));
    EXPECT_EQ(back, unusual());
}

void expectRefused(const std::string& text, const std::string& fragment) {
    try {
        parseScenario(text, "s.json");
        ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(fragment), std::string::npos) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

// The output of relief render --report is a scenario, too; errors name the report's own lines.
TEST(Scenario, aReportIsOne) {
    const std::string text = scenarioText(unusual());
    const std::string report = "{\"tool\": \"relief\",\n\"relief\": {\"depth\": 1},\n\"scenario\": " + text + "}";
    EXPECT_EQ(parseScenario(report, "r.json"), parseScenario(text, "r.json"));
    expectRefused("{\"tool\": \"relief\",\n\"scenario\": 3}", "s.json: line 2: \"scenario\" must be an object");
    expectRefused("{\"method\": 1, \"scenario\": {\"reliefscope\": 1,\n\"method\": {\n\"name\": \"magic\"}}}",
                  "s.json: line 3: there is no tracer");
    expectRefused("{\"scenario\": {}}", "is missing");
}

TEST(Scenario, brokenFilesAreRefusedWithTheLine) {
    expectRefused("", "s.json: line 1: this is not JSON");
    expectRefused("{\n\"reliefscope\": 1,\n oops}", "line 3: this is not JSON");
    expectRefused("[]", "s.json: line 1: a JSON object is expected here");
    expectRefused("{}", "s.json: is not a scenario: \"reliefscope\" is missing");
    expectRefused("{\"reliefscope\": 2}", "not a scenario of version 1");
    expectRefused("{\"reliefscope\": 1,\n\"colour\": 3}", "line 2: unknown key \"colour\"");
    expectRefused("{\"reliefscope\": 1,\n\"relief\": {\n\"depth\": \"deep\"}}", "line 3: \"depth\" must be a number");
    expectRefused("{\"reliefscope\": 1, \"relief\": {\"depth\": -1}}", "relief-depth is -1");
    expectRefused("{\"reliefscope\": 1, \"relief\": {\"address\": \"mirror\"}}", "no address \"mirror\"");
    expectRefused("{\"reliefscope\": 1, \"method\": {\"name\": \"magic\"}}", "no tracer \"magic\"");
    expectRefused("{\"reliefscope\": 1, \"size\": [0, 5]}", "width is 0");
    expectRefused("{\"reliefscope\": 1, \"size\": [99999999999, 5]}", "a smaller number");
    expectRefused("{\"reliefscope\": 1, \"size\": [1.5, 5]}", "a whole number");
    expectRefused("{\"reliefscope\": 1, \"pixel\": [800, 0]}", "pixel 800,0 is outside");
    expectRefused("{\"reliefscope\": 1, \"sky\": [1, 2]}", "an array of 3 numbers");
    expectRefused("{\"reliefscope\": 1,\n\"breakpoints\": [\n{\"stop\": \"overshoot\"},\n{\"stop\": \"never\"}]}",
                  "line 4: there is no breakpoint \"never\"");
    expectRefused("{\"reliefscope\": 1,\n\"breakpoints\": [{\"stop\": \"overshoot\"},\n{\"level\": \"[,\"}]}",
                  "line 3: \"level\" must be a whole number");
    expectRefused("{\"reliefscope\": 1, \"breakpoints\": [{\"level\": 33}]}", "level is 33, but must be 0 to 32");
    expectRefused("{\"reliefscope\": 1, \"breakpoints\": 3}", "\"breakpoints\" must be an array of objects");
    expectRefused("{\"reliefscope\": 1,\n\"bookmarks\": [{\"name\": \"a\"},\n{\"nam\": \"b\"}]}",
                  "line 3: unknown key \"nam\"");
    expectRefused("{\"reliefscope\": 1,\n\"sky\": [0, 0, 0],\n\"[1]\": 2}", "line 3: unknown key \"[1]\"");
    // Keys that look like the number of an element.
    for (const char* key : {"[ame", "[1", "[99999999999999999999999]", "["})
        expectRefused(
            "{\"reliefscope\": 1,\n\"bookmarks\": [\n{\"name\": \"a\"},\n{\"" + std::string(key) + "\": \"b\"}]}",
            "line 4: unknown key \"" + std::string(key) + "\"");
    expectRefused("{\"reliefscope\": 1,\n\"step\": -1}", "s.json: line 2: step is -1");
    expectRefused("{\"reliefscope\": 1,\n\"sky\": [2000, 0, 0]}", "s.json: line 2: sky is 2000");
    expectRefused("{\"reliefscope\": 1, \"pictures\": {\n\"max-pixels\": 0}}", "s.json: line 2: max-pixels is 0");
    const std::string recipe = "{\"reliefscope\": 1, \"pictures\": {\"recipe\": {\n";
    expectRefused(recipe + "\"name\": \"ctiy\"}}}",
                  "s.json: line 2: there is no relief \"ctiy\"; did you mean \"city\"?");
    expectRefused(recipe + "\"name\": \"city\",\n\"width\": 0}}}", "s.json: line 3: width is 0");
    expectRefused(recipe + "\"name\": \"city\",\n\"height\": 32769}}}", "s.json: line 3: height is 32769");
    expectRefused(recipe + "\"name\": \"paper8x8\", \"width\": 9}}}", "s.json: line 1: paper8x8: ");
    EXPECT_EQ(parseScenario(recipe + "\"name\": \"paper8x8\"}}}", "s.json").pictures.recipeWidth, 8);
    const std::string rows = "{\"reliefscope\": 1, \"pictures\": {\"drawn\": {\"width\": 2, \"height\": 2,\n\"rows\": ";
    expectRefused(rows + "[\"0,1\", \"0.5,x\"]}}}", "line 2");
    expectRefused(rows + "[\"0,1\", \"0.5\"]}}}", "has 3 heights; it needs 4");
    expectRefused(rows + "[\"0,1\", \"0.5,1.5\"]}}}", "a drawn height is 1.5");
    expectRefused(rows + "[\"0,1\", \"0.5,nan\"]}}}", "s.json");
    expectRefused(rows + "[]}}}", "an array of strings");
    expectRefused(rows + "[\"0,1\", \"0,1\"]}, \"height\": \"a.png\"}}", "give only one of them");
    const std::string wide = "{\"reliefscope\": 1, \"pictures\": {\"drawn\": {\"width\": 33, \"height\": 2, ";
    expectRefused(wide + "\"rows\": [\"0,1\"]}}}", "33");
    const std::string compare = "{\"reliefscope\": 1,\n\"compare\": {";
    expectRefused(compare + "\"mode\": \"blink\"}}", "no comparison mode \"blink\"");
    expectRefused(compare + "\"methods\": [3]}}", "an object");
    expectRefused(compare + "\"methods\": [{\"name\": \"magic\"}]}}", "no tracer \"magic\"");
    expectRefused(compare + "\"dividers\": [0.5, 0.2]}}", "a divider is 0.2");
    expectRefused(compare + "\"rate\": 0}}", "rate is 0");
    expectRefused(compare + "\"subject\": \"lights\"}}",
                  "line 2: compare: there is no subject of comparison \"lights\"");
    expectRefused(compare + "\"filters\": [{\"name\": \"magic\"}]}}", "s.json: line 2: there is no filter \"magic\"");
    expectRefused(compare + "\"mappings\": [{\"name\": \"fill\"}]}}", "s.json: line 2: there is no mapping \"fill\"");
    const std::string bits = compare + "\"heights\": [{\"name\": \"quantised\", \"options\": {\"bits\": ";
    expectRefused(bits + "17}}]}}", "17");
    expectRefused(compare + "\"filters\": [{}, {}, {}, {}]}}", "compared filters is 5");
    expectRefused("{\"reliefscope\": 1, \"camera\": {\"fov\": 1e999}}", "s.json");
    const std::string method = "{\"reliefscope\": 1, \"method\": {\n\"name\": ";
    expectRefused(method + "\"coen\"}}", "s.json: line 2: there is no tracer \"coen\"; did you mean \"cone\"?");
    expectRefused(method + "\"layers\", \"options\": {\n\"layers\": \"x\"}}}",
                  "s.json: line 3: \"layers=x\" is not a number");
    expectRefused(method + "\"hybrid\", \"options\": {\"inner\": \"layers\",\n\"inner.layers\": 0}}}",
                  "s.json: line 3: inner.layers is 0");
    expectRefused(method + "\"distance-refined\", \"options\": {\"horizons\": 16,\n\"sectors\": 3}}}",
                  "s.json: line 3: sectors is 3");
    expectRefused(method + "\"distance-conservative\", \"options\": {\n\"sectors\": 4}}}",
                  "s.json: line 3: sectors: needs map=refined");
    EXPECT_NO_THROW(parseScenario(method + "\"distance-conservative\", \"options\": {\n\"flattest\": 5,\n"
                                           "\"map\": \"refined\", \"sectors\": 4}}}",
                                  "s.json"));
    expectRefused("{\"reliefscope\": 1, \"filter\": \"elliptical\",\n\"filter-options\": {\n\"sigma\": 9}}",
                  "s.json: line 3: sigma is 9");
    expectRefused("{\"reliefscope\": 1, \"filter\": \"supersample\",\n\"supersample\": 65}",
                  "s.json: line 2: supersample is 65");
    expectRefused("{\"reliefscope\": 1,\n\"scene\": \"sea\"}", "s.json: line 2: there is no scene \"sea\"");
    expectRefused("{\"reliefscope\": 1,\n\"camera\": {\n\"elevation\": 91}}", "s.json: line 3: elevation is 91");
    expectRefused("{\"reliefscope\": 1,\n\"light\": {\"azimuth\": 0,\n\"elevation\": 91}}",
                  "s.json: line 3: light-elevation is 91");
    expectRefused("{\"reliefscope\": 1, \"camera\": {\"eye\": [0,0,0], \"target\": [0,0,0]}}", "distance from eye");
}

TEST(Scenario, theTraceCommandQuotesForTheShell) {
    const std::string line = traceCommand(unusual());
    EXPECT_NE(line.find("--height 'тека з пробілами/висоти.png'"), std::string::npos) << line;
    EXPECT_NE(line.find("--pixel 320,7"), std::string::npos) << line;
    EXPECT_NE(line.find("--relief-depth 0.30000000000000004"), std::string::npos) << line;
    EXPECT_NE(traceCommand(drawn()).find("--relief drawn:3x2:0,1,0.30000000000000004,0.125,"), std::string::npos);
}

}  // namespace
}  // namespace relief::test
