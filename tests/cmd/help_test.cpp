// What a newcomer types first, and what is answered to a slip of the finger.
#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class HelpTest : public CommandTest {};
INSTANTIATE_TEST_SUITE_P(Places, HelpTest, testing::ValuesIn(everyPlace()), placeName);

TEST_P(HelpTest, EveryCommandExplainsItself) {
    const std::string page = runFine({"--help"});
    for (const std::string command : {"info", "make", "list", "map", "render", "trace", "compare", "bench", "stress",
                                      "certify", "recommend", "claims", "merge"}) {
        EXPECT_NE(page.find("\n  " + command + " "), std::string::npos) << command;
        const std::string help = runFine({command, "--help"});
        EXPECT_NE(help.find("Usage: relief " + command), std::string::npos) << help;
        EXPECT_NE(help.find("Example:\n  relief " + command), std::string::npos) << help;
        for (const std::string& line : lines(help)) EXPECT_LE(line.size(), 120U) << line;
    }
    EXPECT_EQ(runFine({"--version"}).substr(0, 7), "relief ");
}

TEST_P(HelpTest, OptionsNameUnitsRangesAndDefaults) {
    std::string help;  // as if it were not wrapped
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

TEST_P(HelpTest, WrongCommandsAndOptions) {
    expectRefusal({}, 2, {"--help"});
    expectRefusal({"redner"}, 2, {"\"redner\"", "render"});
    expectRefusal({"render", "--hieght", "x.png"}, 2, {"--hieght", "relief render --help"});
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
    expectRefusal({"--language=uk", "redner"}, 2, {"немає такого"});
}

TEST_P(HelpTest, FilesMayBeCalledLikeCommands) {
    expectRefusal({"info", "list"}, 2, {"list: no such file"});
}

TEST_P(HelpTest, InfoSaysWhatAScenarioLooksAt) {
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
