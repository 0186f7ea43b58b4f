// The state of the window's panes in scenario files.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "panes/charts/charts_state.h"
#include "panes/distance/distance_state.h"
#include "panes/footprint/footprint_state.h"
#include "panes/point_state.h"
#include "panes/profile/profile_state.h"
#include "panes/pyramid/pyramid_state.h"
#include "panes/rows/rows_state.h"
#include "panes/shader/shader_state.h"
#include "panes/trace/trace_state.h"
#include "panes/watch/watch_state.h"
#include "windows/pane_list.h"
#include "workspace/annotation_state.h"
#include "workspace/range_json.h"

namespace reliefui {
namespace {

using relief::InputError;
using relief::Scenario;

const StateReaders kReaders = stateReaders();

Scenario parsed(const std::string& text) {
    return parseWindowScenario(text, "s.json", kReaders);
}

// Every state differs from its default, in each of its members. A new state is added here.
Scenario allOther() {
    Scenario scenario;
    setState(scenario, PyramidPane{"all", true, false, true});
    setState(scenario, ProfilePane{true, false, true});
    setState(scenario, WatchPane{{"level", "z_out - value"}, 1});
    setState(scenario, DistancePane{"refined", "euclidean", "z", 3, 2, false, false});
    setState(scenario, FootprintPane{8, false});
    setState(scenario, RowsPane{{"direct", "subspan:error=0.25"}, 3840, true, false});
    setState(scenario, ChartsPane{"histograms", "p9999", false, true});
    setState(scenario, TracePane{"level", 2, true});
    setState(scenario, ShaderPane{ShaderMeasure::Hits});
    setState(scenario, PointState{QueryPoint{-3.25, 4.5, 0.6}});
    setState(scenario,
             AnnotationState{{{AnnotationKind::Arrow, "profile", {4, 0.8}, {6.5, 0.4}, "hit", "влучання", "green"},
                              {AnnotationKind::Number, "result", {90, 80}, {}, "12", "", "text"}}});
    return scenario;
}

relief::Json readJson(const std::string& path) {
    std::ifstream file(path);
    return relief::Json::parse(file);
}

TEST(PaneFiles, writtenAndReadTheyAreTheSame) {
    const Scenario scenario = allOther();
    ASSERT_EQ(stateOf<PyramidPane>(scenario), (PyramidPane{"all", true, false, true}));
    ASSERT_EQ(stateOf<ChartsPane>(scenario), (ChartsPane{"histograms", "p9999", false, true}));
    const std::string text = relief::scenarioText(scenario);
    EXPECT_EQ(parsed(text), scenario) << text;
    EXPECT_EQ(relief::scenarioText(parsed(text)), text);
}

// Each state of the panes in the list is tested here, and described by the schema of scenarios. The colour ranges are
// tested in range_box_test.cpp.
TEST(PaneFiles, everyStateIsTestedAndDescribed) {
    const relief::Json states = relief::Json::parse(allOther().ui);
    const relief::Json schema = readJson(RELIEF_SOURCE "/algorithms/scenario/scenario.schema.json");
    const relief::Json& described = schema.at("properties").at("ui").at("properties");
    for (const auto& [name, reader] : kReaders) {
        EXPECT_TRUE(described.contains(name)) << name << " is not in algorithms/scenario/scenario.schema.json, ui";
        if (name == RangesState::kName) continue;
        EXPECT_TRUE(states.contains(name)) << "add the state " << name << " to allOther()";
    }
    for (const auto& [name, state] : states.items()) {
        EXPECT_TRUE(kReaders.contains(name)) << "no pane in windows/pane_list.cpp reads the state " << name;
        if (!described.contains(name)) continue;
        for (const auto& [key, value] : state.items()) {
            EXPECT_TRUE(described.at(name).at("properties").contains(key))
                << name << "/" << key << " is not in algorithms/scenario/scenario.schema.json, ui";
        }
    }
}

// States with default values are not written.
TEST(PaneFiles, untouchedPanesAreNotInTheFile) {
    EXPECT_EQ(relief::scenarioText(Scenario{}).find("\"ui\""), std::string::npos);
    EXPECT_TRUE(parsed("{\"reliefscope\": 1}").ui.empty());
    EXPECT_TRUE(parsed(R"({"reliefscope": 1, "ui": {"pyramid": {"levels": "max"}}})").ui.empty())
        << "as it is at first";
    Scenario one;
    setState(one, FootprintPane{4});
    const std::string text = relief::scenarioText(one);
    EXPECT_NE(text.find("footprint"), std::string::npos);
    EXPECT_EQ(text.find("near-ray"), std::string::npos);
}

TEST(PaneFiles, whatIsUnknownIsRefusedWithItsLine) {
    const auto refused = [](const std::string& panes, const std::string& line, const std::string& word) {
        const std::string text = "{\"reliefscope\": 1,\n \"ui\": {\n" + panes + "\n}}";
        try {
            parsed(text);
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
    const auto annotation = [&](const std::string& text, const std::string& line, const std::string& word) {
        refused("\"annotations\": {\"list\": [\n{" + text + "}]}", line, word);
    };
    annotation(R"("kind": "circle", "view": "profile", "at": [1, 2])", "line 4", "circle");
    annotation(R"("kind": "label", "view": "trace", "at": [1, 2], "text": "a")", "line 4", "trace");
    annotation(R"("kind": "arrow", "view": "profile", "at": [1, 2])", "line 4", "to");
    annotation(R"("kind": "arrow", "view": "profile", "at": [1, "2"], "to": [1, 2])", "line 4", "at");
    annotation(R"("kind": "label", "view": "profile", "at": [1, 1e9], "text": "a")", "line 4", "1e+09");
    annotation(R"("kind": "label", "view": "profile", "at": [1, 2])", "line 4", "text");
    annotation(R"("kind": "number", "view": "profile", "at": [1, 2], "text": "1234")", "line 4", "4");
    annotation(R"("kind": "label", "view": "profile", "at": [1, 2], "text": {"en": "a", "de": "b"})", "line 4", "de");
    annotation(R"("kind": "label", "view": "profile", "at": [1, 2], "text": "a", "color": "red")", "line 4", "red");
}

TEST(PaneFiles, valuesOutOfRangeAreRefused) {
    const auto refused = [](const auto& state) {
        EXPECT_THROW(state.check("s.json"), InputError);
        EXPECT_THROW(checkStates(withState(Scenario{}, state), kReaders, "s.json"), InputError);
    };
    refused(FootprintPane{5});
    DistancePane distance;
    distance.slice = -1;
    refused(distance);
    refused(TracePane{.heights = 100});
    refused(TracePane{.colors = "colour"});
    refused(RowsPane{.pixels = -3});
    refused(PointState{QueryPoint{1, 2, 1.5}});
    refused(PointState{QueryPoint{1e12, 2, 0.5}});
    refused(PointState{QueryPoint{1, std::nan(""), 0.5}});
    refused(RowsPane{std::vector<std::string>(kMostRowVariants + 1, "direct")});
    const auto label = [](double x, std::string text) {
        return Annotation{AnnotationKind::Label, "profile", {x, 0.5}, {}, std::move(text), "", "text"};
    };
    refused(AnnotationState{{label(std::nan(""), "a")}});
    refused(AnnotationState{{label(1, std::string(kMostAnnotationText + 1, 'a'))}});
    refused(AnnotationState{std::vector<Annotation>(kMostAnnotations + 1, label(1, "a"))});
    std::string longest;
    for (int n = 0; n < kMostAnnotationText; ++n) longest += "і";
    EXPECT_NO_THROW((AnnotationState{{label(1, longest)}}.check("s.json"))) << "characters are counted, not bytes";
    EXPECT_NO_THROW(checkStates({}, kReaders, "s.json"));
    EXPECT_NO_THROW(checkStates(allOther(), kReaders, "s.json"));
}

Scenario oldFile(const std::string& name) {
    return loadWindowScenario(RELIEF_SOURCE "/tests/files/v1/" + name, kReaders);
}

// Files of the first version call the object `panes`.
TEST(PaneFiles, notesOfTheFirstEditionMeanWhatTheyMeant) {
    const Scenario old = oldFile("window.json");
    EXPECT_EQ(stateOf<PyramidPane>(old), (PyramidPane{"mean", true, false, true}));
    EXPECT_EQ(stateOf<ProfilePane>(old), (ProfilePane{true, false, true}));
    EXPECT_EQ(stateOf<DistancePane>(old), (DistancePane{"refined", "euclidean-conservative", "y", 5, 0, false, false}));
    EXPECT_EQ(stateOf<FootprintPane>(old), FootprintPane{8});
    EXPECT_EQ(stateOf<RowsPane>(old),
              (RowsPane{{"direct", "streams:streams=4", "subspan:error=0.25"}, 2000, true, false}));
    EXPECT_EQ(stateOf<ChartsPane>(old), (ChartsPane{"histograms", "p95", false, true}));
    EXPECT_EQ(stateOf<TracePane>(old), (TracePane{"level", 2, true}));
    EXPECT_EQ(stateOf<PointState>(old), PointState{});
}

TEST(PaneFiles, wordsOfTheFirstEditionMeanWhatTheyMeant) {
    const auto notes = [](int number) { return oldFile("notes-" + std::to_string(number) + ".json"); };
    EXPECT_EQ(stateOf<PyramidPane>(notes(1)).levels, "min");
    EXPECT_EQ(stateOf<PyramidPane>(notes(2)).levels, "all");
    EXPECT_EQ(stateOf<DistancePane>(notes(1)).map, "cone");
    EXPECT_EQ(stateOf<DistancePane>(notes(2)).minus, "relaxed-cone");
    EXPECT_EQ(stateOf<DistancePane>(notes(3)).minus, "refined-sampled");
    EXPECT_EQ(stateOf<DistancePane>(notes(3)).sector, 3);
    EXPECT_EQ(stateOf<ChartsPane>(notes(1)).shown, "pareto");
    EXPECT_EQ(stateOf<TracePane>(notes(1)).colors, "phase");
    // Of the row methods that these files name, the pane has no curve for fill and for those of derivatives.
    EXPECT_EQ(stateOf<RowsPane>(notes(1)).variants.size(), 4U);
    EXPECT_EQ(stateOf<RowsPane>(notes(2)).variants,
              (std::vector<std::string>{"incremental-reciprocal", "opposed:anchor=0", "rows-parallel:streams=8"}));
    EXPECT_EQ(stateOf<RowsPane>(notes(3)).variants, std::vector<std::string>{"subspan:span=8"});
}

// Programs that only read the scenario preserve unknown states unchanged, such as those of later versions.
TEST(PaneFiles, aCommandCarriesWhatItDoesNotKnow) {
    const std::string text = R"({"reliefscope": 1, "ui": {"telescope": {"zoom": 3}}})";
    EXPECT_NE(relief::scenarioText(relief::parseScenario(text, "s.json")).find("telescope"), std::string::npos);
    EXPECT_THROW(parsed(text), InputError);
    const std::string deep =
        R"({"reliefscope": 1, "ui": {"a": )" + std::string(100000, '[') + std::string(100000, ']') + "}}";
    EXPECT_THROW(relief::parseScenario(deep, "s.json"), InputError);
    const std::string both =
        R"({"reliefscope": 1, "panes": {"charts": {"maps": true}}, "ui": {"charts": {"live": false}}})";
    const auto charts = stateOf<ChartsPane>(parsed(both));
    EXPECT_EQ(charts, stateOf<ChartsPane>(relief::parseScenario(both, "s.json")))
        << "commands and the window read the same object";
    EXPECT_FALSE(charts.maps);
    EXPECT_FALSE(charts.live);
}

}  // namespace
}  // namespace reliefui
