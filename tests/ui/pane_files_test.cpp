// What is chosen in the window's panes, in scenario files.
#include "workspace/pane_states.h"

#include <cmath>

#include <gtest/gtest.h>

namespace reliefui {
namespace {

using relief::InputError;
using relief::Scenario;

// Nothing as it is at first.
PaneStates allOther() {
    PaneStates panes;
    panes.pyramid = {"all", true, false, true};
    panes.profile = {true, false, true};
    panes.distance = {"refined", "euclidean", "z", 3, 2, false, false};
    panes.footprint = {8, false};
    panes.rows = {{"direct", "subspan:error=0.25"}, 3840, true, false};
    panes.charts = {"histograms", "p9999", false, true};
    panes.trace = {"level", 2, true};
    panes.query = {-3.25, 4.5, 0.6};
    return panes;
}

TEST(PaneFiles, writtenAndReadTheyAreTheSame) {
    Scenario scenario;
    setPanesOf(scenario, allOther());
    const PaneStates standard;
    ASSERT_NE(panesOf(scenario).pyramid, standard.pyramid);
    ASSERT_NE(panesOf(scenario).charts, standard.charts);
    const std::string text = relief::scenarioText(scenario);
    EXPECT_EQ(parseWindowScenario(text, "s.json"), scenario) << text;
    EXPECT_EQ(relief::scenarioText(parseWindowScenario(text, "s.json")), text);
}

// Nothing is written of panes that nobody touched.
TEST(PaneFiles, untouchedPanesAreNotInTheFile) {
    EXPECT_EQ(relief::scenarioText(Scenario{}).find("\"ui\""), std::string::npos);
    EXPECT_EQ(panesOf(parseWindowScenario("{\"reliefscope\": 1}", "s.json")), PaneStates{});
    Scenario one;
    PaneStates panes;
    panes.footprint.neighbours = 4;
    setPanesOf(one, panes);
    const std::string text = relief::scenarioText(one);
    EXPECT_NE(text.find("footprint"), std::string::npos);
    EXPECT_EQ(text.find("near-ray"), std::string::npos);
}

TEST(PaneFiles, whatIsUnknownIsRefusedWithItsLine) {
    const auto refused = [](const std::string& panes, const std::string& line, const std::string& word) {
        const std::string text = "{\"reliefscope\": 1,\n \"ui\": {\n" + panes + "\n}}";
        try {
            parseWindowScenario(text, "s.json");
            ADD_FAILURE() << panes;
        } catch (const InputError& error) {
            const std::string what = error.text(relief::Language::English);
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

TEST(PaneFiles, valuesOutOfRangeAreRefused) {
    const auto refused = [](const auto& change) {
        PaneStates panes;
        change(panes);
        EXPECT_THROW(checkPanes(panes, "s.json"), InputError);
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
    EXPECT_NO_THROW(checkPanes({}, "s.json"));
}

Scenario oldFile(const std::string& name) {
    return loadWindowScenario(RELIEF_SOURCE "/tests/files/v1/" + name);
}

// Files of the first edition call the object `panes`.
TEST(PaneFiles, notesOfTheFirstEditionMeanWhatTheyMeant) {
    PaneStates panes;
    panes.pyramid = {"mean", true, false, true};
    panes.profile = {true, false, true};
    panes.distance = {"refined", "euclidean-conservative", "y", 5, 0, false, false};
    panes.footprint = {8};
    panes.rows = {{"direct", "streams:streams=4", "subspan:error=0.25"}, 2000, true, false};
    panes.charts = {"histograms", "p95", false, true};
    panes.trace = {"level", 2, true};
    EXPECT_EQ(panesOf(oldFile("window.json")), panes);
}

TEST(PaneFiles, wordsOfTheFirstEditionMeanWhatTheyMeant) {
    const auto notes = [](int number) { return panesOf(oldFile("notes-" + std::to_string(number) + ".json")); };
    EXPECT_EQ(notes(1).pyramid.levels, "min");
    EXPECT_EQ(notes(2).pyramid.levels, "all");
    EXPECT_EQ(notes(1).distance.map, "cone");
    EXPECT_EQ(notes(2).distance.minus, "relaxed-cone");
    EXPECT_EQ(notes(3).distance.minus, "refined-sampled");
    EXPECT_EQ(notes(3).distance.sector, 3);
    EXPECT_EQ(notes(1).charts.shown, "pareto");
    EXPECT_EQ(notes(1).trace.colors, "phase");
    for (int number = 1; number <= 3; ++number) EXPECT_GE(notes(number).rows.variants.size(), 3U);
}

// What only reads the scenario carries it along as it stands, with words of later windows.
TEST(PaneFiles, aCommandCarriesWhatItDoesNotKnow) {
    const std::string text = R"({"reliefscope": 1, "ui": {"telescope": {"zoom": 3}}})";
    EXPECT_NE(relief::scenarioText(relief::parseScenario(text, "s.json")).find("telescope"), std::string::npos);
    EXPECT_THROW(parseWindowScenario(text, "s.json"), InputError);
    const std::string deep =
        R"({"reliefscope": 1, "ui": {"a": )" + std::string(100000, '[') + std::string(100000, ']') + "}}";
    EXPECT_THROW(relief::parseScenario(deep, "s.json"), InputError);
    const std::string both =
        R"({"reliefscope": 1, "panes": {"charts": {"maps": true}}, "ui": {"charts": {"live": false}}})";
    const PaneStates panes = panesOf(parseWindowScenario(both, "s.json"));
    EXPECT_EQ(panes, panesOf(relief::parseScenario(both, "s.json"))) << "commands and the window take the same one";
    EXPECT_FALSE(panes.charts.maps);
}

}  // namespace
}  // namespace reliefui
