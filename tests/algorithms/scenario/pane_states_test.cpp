// What is chosen in the window's panes, in scenario files.
#include "scenario/pane_states.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scenario/scenario.h"

namespace relief {
namespace {

// Nothing as it is at first.
PaneStates allOther() {
    PaneStates panes;
    panes.pyramid = {"all", true, false, true};
    panes.profile = {true, false, true};
    panes.distance = {"refined", "euclidean", "z", 3, 2, false, false};
    panes.footprint = {8};
    panes.rows = {{"direct", "subspan:error=0.25"}, 3840, true, false};
    panes.charts = {"histograms", "p9999", false, true};
    panes.trace = {"level", 2, true};
    panes.query = {-3.25, 4.5, 0.6};
    return panes;
}

TEST(PaneStates, writtenAndReadTheyAreTheSame) {
    Scenario scenario;
    scenario.panes = allOther();
    const PaneStates standard;
    ASSERT_NE(scenario.panes.pyramid, standard.pyramid);
    ASSERT_NE(scenario.panes.charts, standard.charts);
    const std::string text = scenarioText(scenario);
    EXPECT_EQ(parseScenario(text, "s.json"), scenario) << text;
    EXPECT_EQ(scenarioText(parseScenario(text, "s.json")), text);
}

// Files of before open, and nothing is written of panes that nobody touched.
TEST(PaneStates, untouchedPanesAreNotInTheFile) {
    EXPECT_EQ(scenarioText(Scenario{}).find("panes"), std::string::npos);
    EXPECT_EQ(parseScenario("{\"reliefscope\": 1}", "s.json").panes, PaneStates{});
    Scenario one;
    one.panes.footprint.neighbours = 4;
    const std::string text = scenarioText(one);
    EXPECT_NE(text.find("footprint"), std::string::npos);
    EXPECT_EQ(text.find("near-ray"), std::string::npos);
}

TEST(PaneStates, whatIsUnknownIsRefusedWithItsLine) {
    const auto refused = [](const std::string& panes, const std::string& line, const std::string& word) {
        const std::string text = "{\"reliefscope\": 1,\n \"panes\": {\n" + panes + "\n}}";
        try {
            parseScenario(text, "s.json");
            ADD_FAILURE() << panes;
        } catch (const InputError& error) {
            const std::string what = error.text(Language::English);
            EXPECT_NE(what.find("s.json"), std::string::npos) << what;
            EXPECT_NE(what.find(line), std::string::npos) << what;
            EXPECT_NE(what.find(word), std::string::npos) << what;
        }
    };
    refused("\"pyramid\": {\"levels\": \"highest\"}", "line 3", "highest");
    refused("\"distance\": {\n\"axis\": \"w\"}", "line 4", "w");
    refused("\"distance\": {\"map\": \"nearest\"}", "line 3", "nearest");
    refused("\"rows\": {\n\n\"variants\": [\"direkt\"]}", "line 5", "direkt");
    refused("\"charts\": {\"error\": \"worst\"}", "line 3", "worst");
    refused("\"charts\": {\"shwon\": \"all\"}", "line 3", "shwon");
    refused("\"trace\": {\"colors\": \"height\"}", "line 3", "height");
    refused("\"footprint\": {\"neighbours\": \"four\"}", "line 3", "neighbours");
    refused("\"query\": {\"s\": 1, \"t\": \"two\", \"z\": 0.5}", "line 3", "t");
    refused("\"query\": {\"s\": 1, \"t\": 2}", "line 3", "z");
    refused("\"query\": {\"s\": 1, \"t\": 2,\n\"z\": 0.5, \"height\": 1}", "line 4", "height");
    refused("\"pane\": {}", "line 3", "pane");
}

TEST(PaneStates, valuesOutOfRangeAreRefused) {
    const auto refused = [](const auto& change) {
        Scenario scenario;
        change(scenario.panes);
        EXPECT_THROW(checkScenario(scenario, "s.json"), InputError);
    };
    refused([](PaneStates& p) { p.footprint.neighbours = 5; });
    refused([](PaneStates& p) { p.distance.slice = -1; });
    refused([](PaneStates& p) { p.trace.heights = 100; });
    refused([](PaneStates& p) { p.trace.colors = "colour"; });
    refused([](PaneStates& p) { p.rows.pixels = -3; });
    refused([](PaneStates& p) { p.query = {1, 2, 1.5}; });
    refused([](PaneStates& p) { p.query = {1e12, 2, 0.5}; });
    refused([](PaneStates& p) { p.query = {1, std::nan(""), 0.5}; });
    refused([](PaneStates& p) { p.rows.variants.assign(kMostRowVariants + 1, "direct"); });
    EXPECT_NO_THROW(checkScenario(Scenario{}, "s.json"));
}

}  // namespace
}  // namespace relief
