// The first commands that a newcomer types, and the answers to typing errors.
#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class HelpTest : public CommandTest {};
INSTANTIATE_TEST_SUITE_P(Places, HelpTest, testing::ValuesIn(everyPlace()), placeName);

TEST_P(HelpTest, EveryCommandExplainsItself) {
    const std::string page = runFine({"--help"});
    for (const std::string command :
         {"info", "make", "list", "map", "render", "trace", "compare", "bench", "stress", "certify", "diagnose",
          "export", "recommend", "claims", "merge", "tile", "help"}) {
        EXPECT_NE(page.find("\n  " + command + " "), std::string::npos) << command;
        const std::string help = runFine({command, "--help"});
        EXPECT_NE(help.find("Usage: relief " + command), std::string::npos) << help;
        const std::size_t example = help.find("\nExample:\n  relief ");
        ASSERT_NE(example, std::string::npos) << help;
        EXPECT_NE(help.find("\n  relief " + command, example), std::string::npos) << help;
        for (const std::string& line : lines(help)) EXPECT_LE(line.size(), 120U) << line;
    }
    EXPECT_EQ(runFine({"--version"}).substr(0, 7), "relief ");
}

TEST_P(HelpTest, OptionsNameUnitsRangesAndDefaults) {
    std::string help;  // with line breaks removed
    for (const char c : runFine({"render", "--help"})) {
        if (c != ' ' && c != '\n')
            help += c;
        else if (!help.ends_with(' '))
            help += ' ';
    }
    for (const std::string part : {"--relief-depth", "texture widths", "0 to 4", "default 0.1", "--camera", "degrees",
                                   "--address", "--surface", "--threads", "--quiet", "--report", "--layers"}) {
        EXPECT_NE(help.find(part), std::string::npos) << part;
    }
}

TEST_P(HelpTest, ManualPagesTagEachExitStatus) {
    runFine({"--manual", path("manual")});
    const std::string page = read("manual/man1/relief.1");
    for (const std::string part : {".TP\n\\fB0\\fR\ndone\n.TP\n\\fB1\\fR\nthe work failed", "\nstress, merge of stress",
                                   "\n141 if the reader", ".TP\n\\fB129, 130, 143\\fR\nended by"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

TEST_P(HelpTest, WrongCommandsAndOptions) {
    expectRefusal({}, 2, {"--help"});
    expectRefusal({"redner"}, 2, {"\"redner\"; did you mean \"render\"? Known: "});
    expectRefusal({"render", "--hieght", "x.png"}, 2, {"--hieght", "did you mean --height?", "relief render --help"});
    expectRefusal({"render", "--hieght=x.png"}, 2, {"did you mean --height?"});
    expectRefusal({"render", "--abracadabra"}, 2, {"--abracadabra: unknown argument; see relief render --help"});
    expectRefusal({"render", "--quiet", "--verbose"}, 2, {"--verbose", "--quiet"});
    expectRefusal({"render", "--height"}, 2, {"--height", "needs a value"});
    expectRefusal({"render", "--height", "a.png", "--height", "b.png", "-o", path("x.png")}, 2,
                  {"--height", "more than once"});
    expectRefusal({"render", "a.json", "b.json", "-o", path("x.png")}, 2, {"b.json"});
    expectRefusal({"make", "bricks"}, 2, {"--output"});
    expectRefusal({"info"}, 2, {"FILE"});
    expectRefusal({"compare", "a.png"}, 2, {"B"});
    expectRefusal({"--language", "fr", "list"}, 2, {"--language", "en, uk"});
}

TEST_P(HelpTest, MessagesSpeakUkrainian) {
    expectRefusal({"info", path("nothing.png"), "--language", "uk"}, 2, {"такого файлу немає"});
    expectRefusal({"--language=uk", "redner"}, 2, {"не знайдено"});
}

TEST_P(HelpTest, OptionsOfOtherCommandsAreNamed) {
    expectRefusal({"make", "bricks", "--camera", "elevation=30", "-o", path("x.png")}, 2,
                  {"--camera: is an option of relief export, relief render, relief trace, not of relief make"});
    expectRefusal({"certify", "--relief", "bricks", "--scene=wall"}, 2, {"--scene: is an option of", "relief certify"});
    expectRefusal({"--seed", "3", "list"}, 2, {"--seed: is an option of", "not of relief"});
}

TEST_P(HelpTest, HelpAndListExplainOneThing) {
    EXPECT_EQ(runFine({"help", "render"}), runFine({"render", "--help"}));
    EXPECT_EQ(runFine({"help"}), runFine({"--help"}));
    expectRefusal({"help", "rendr"}, 2, {"did you mean \"render\""});
    for (const char* part : {"0    done", "3    not decided", "130"}) {
        EXPECT_NE(runFine({"help"}).find(part), std::string::npos) << part;
    }
    const std::string cone = runFine({"list", "cone"});
    for (const char* part : {"Tracers: ", "\n  cone  ", "--set sectors=..", "Maps that"}) {
        EXPECT_NE(cone.find(part), std::string::npos) << part << "\n" << cone;
    }
    EXPECT_EQ(cone.find("layers-secant"), std::string::npos) << cone;
    const auto json = nlohmann::json::parse(runFine({"list", "cone", "--json"}));
    ASSERT_EQ(json.size(), 2U) << json;
    EXPECT_EQ(json["tracers"].size(), 1U);
    EXPECT_EQ(json["maps"][0]["tracer"], "cone");
    EXPECT_EQ(runFine({"list", "reliefs"}).find("Tracers"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(runFine({"list", "filters", "--json"})).size(), 1U);
    expectRefusal({"list", "briks"}, 2, {"did you mean \"bricks\""});
    // The whole list is the concatenation of its sections.
    std::string all;
    for (const std::string kind : {"tracers", "shading", "meshes", "any-hit", "maps", "conventions", "rows", "filters",
                                   "reliefs", "numbers", "render-layers"}) {
        all += (all.empty() ? "" : "\n") + runFine({"list", kind});
    }
    EXPECT_TRUE(runFine({"list"}) == all);
}

TEST_P(HelpTest, FilesMayBeCalledLikeCommands) {
    expectRefusal({"info", "list"}, 2, {"list: no such file"});
}

TEST_P(HelpTest, InfoForPrograms) {
    const std::string height = makeRelief("hills", "hills.png", {"--size", "24x16"});
    const auto one = nlohmann::json::parse(runFine({"info", height, "--json", "--range", "0,32767"}));
    EXPECT_EQ(one["width"], 24);
    EXPECT_EQ(one["channels"], nlohmann::json::array({"Y"}));
    EXPECT_EQ(one["file_values"][1], 65535);
    EXPECT_EQ(one["heights"][1], 1);
    runFine({"render", height, "--size", "8", "--tracer", "exact", "-o", path("p.png"), "--report", path("r.json")});
    const auto both = nlohmann::json::parse(runFine({"info", height, path("r.json"), "--json"}));
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[1]["scenario"]["method"]["name"], "exact");
    const std::string text = runFine({"info", height, path("r.json")});
    EXPECT_NE(text.find(height + "\n"), std::string::npos) << text;
    EXPECT_NE(text.find("24 x 16"), std::string::npos) << text;
    expectRefusal({"info", path("r.json"), "--channel", "0"}, 2, {"--channel", "r.json"});
}

TEST_P(HelpTest, InfoDescribesAScenario) {
    runFine({"render", "--relief", "bricks", "--eye", "1,2,3", "--target", "0,0,0.5", "--fov", "40", "--size", "32x24",
             "-o", path("p.png"), "--report", path("r.json")});
    auto scenario = nlohmann::json::parse(read("r.json"))["scenario"];
    scenario["pixel"] = {7, 5};
    const std::string said = runFine({"info", write("s.json", scenario.dump())});
    for (const char* part : {"eye 1,2,3, target 0,0,0.5, fov 40", "7,5", "bricks", "32 x 24"}) {
        EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
    }
}

}  // namespace relief::test
