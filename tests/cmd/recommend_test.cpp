// relief recommend: texts, JSON, files, refusals.
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class RecommendTest : public CommandTest {
  protected:
    static std::vector<std::string> with(const std::vector<std::string>& more) {
        std::vector<std::string> all{"recommend", "--relief", "city:24x16:3", "--form", "scalar", "--seconds", "30"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, RecommendTest, testing::ValuesIn(places()), placeName);

TEST_P(RecommendTest, TextAndJsonAndFiles) {
    const std::string text = run(with({"--quiet"})).out;
    EXPECT_NE(text.find("city:24x16:3: 24 x 16 texels"), std::string::npos) << text;
    EXPECT_NE(text.find("\nMethod: "), std::string::npos) << text;
    EXPECT_NE(text.find("\nFilter: "), std::string::npos) << text;
    const auto json = nlohmann::json::parse(run(with({"--quiet", "--json", "--no-filter"})).out);
    EXPECT_EQ(json["size"], "24x16");
    EXPECT_FALSE(json.contains("filter"));
    EXPECT_EQ(json["chosen"]["verdict"], "kept");
    EXPECT_NE(text.find("\nMethod: " + json["chosen"]["text"].get<std::string>() + "\n"), std::string::npos) << text;
    EXPECT_EQ(run(with({"--quiet", "--no-filter", "-o", path("a.json")})).status, 0);
    const auto file = nlohmann::json::parse(read("a.json"));
    EXPECT_EQ(file["chosen"]["text"], json["chosen"]["text"]);
    EXPECT_EQ(file["chosen"]["cost"], json["chosen"]["cost"]);
    EXPECT_EQ(files(), std::vector<std::string>{"a.json"});
}

TEST_P(RecommendTest, ReadsTilesWithinTheGivenMemory) {
    const std::string map = path("map.tif");
    runFine({"make", "hills", "--size", "300x200", "--tiled", "-o", map});
    const std::vector<std::string> byTiles{"recommend", map,  "--resident", "1",      "--form",     "scalar",
                                           "--seconds", "30", "--quiet",    "--json", "--no-filter"};
    const auto json = nlohmann::json::parse(run(byTiles).out);
    EXPECT_EQ(json["chosen"]["verdict"], "kept");
    std::set<std::string> names;
    for (const auto& form : json["forms"]) names.insert(form["method"].get<std::string>());
    EXPECT_TRUE(names.contains("max-pyramid")) << json;
    EXPECT_FALSE(names.contains("cone"));
    // A map as small as this one is measured as a whole.
    std::vector<std::string> whole = byTiles;
    whole.erase(whole.begin() + 2, whole.begin() + 4);
    EXPECT_EQ(nlohmann::json::parse(run(whole).out)["relief"], json["relief"]);
    expectRefusal({"recommend", map, "--resident", "1"}, 2, {"--resident", "--no-filter"});
    expectRefusal({"recommend", map, "--resident", "0", "--no-filter"}, 2, {"--resident"});
}

TEST_P(RecommendTest, ComparedWithTheFullTable) {
    const std::string text = run(with({"--quiet", "--check"})).out;
    EXPECT_NE(text.find("city:24x16:3"), std::string::npos) << text;
    EXPECT_NE(text.find("regret: median "), std::string::npos) << text;
}

// Every command that the advice for shaders prints runs, and the shader decodes cones as the map's sidecar states.
TEST_P(RecommendTest, CommandsOfTheAdviceForShadersRun) {
    const auto json =
        nlohmann::json::parse(run({"recommend", "--relief", "hills:24x16:3", "--form", "shader", "--max-steps", "24",
                                   "--quiet", "--address", "clamp", "--seconds", "600", "--views", "30", "--json"})
                                  .out);
    EXPECT_EQ(json["form"], "shader");
    EXPECT_LE(json["chosen"]["steps_max"], 24);
    std::set<std::string> tracers;
    for (const auto& form : json["forms"]) {
        if (!tracers.insert(form["method"]).second) continue;
        double scale = 0;
        for (const std::string command : form["commands"]) {
            std::istringstream words(command);
            std::vector<std::string> arguments;
            for (std::string word; words >> word;) {
                const bool isFile = word.ends_with(".png") || word.ends_with(".frag");
                arguments.push_back(isFile ? path(word) : word);
            }
            ASSERT_EQ(arguments.front(), "relief");
            arguments.erase(arguments.begin());
            const Result result = run(arguments);
            ASSERT_EQ(result.status, 0) << command << "\n" << result.err;
            if (arguments[0] == "map") {
                const auto sidecar = nlohmann::json::parse(read(arguments.back().substr(path("").size()) + ".json"));
                if (sidecar.contains("cone")) scale = sidecar["cone"]["scale"];
            }
        }
        const std::string shader = read("relief.frag");
        const std::size_t at = shader.find("CONE_SCALE = ");
        EXPECT_EQ(at != std::string::npos, scale > 0) << form["text"];
        if (scale > 0) {
            EXPECT_EQ(std::stod(shader.substr(at + 13)), scale);
        }
    }
    EXPECT_EQ(tracers.size(), 11U);
}

TEST_P(RecommendTest, Refusals) {
    expectRefusal(with({"--views", "70,10"}), 2, {"--views", "70,10"});
    expectRefusal(with({"--views", "flat"}), 2, {"--views", "flat"});
    expectRefusal(with({"--error", "-1"}), 2, {"--error", "-1"});
    expectRefusal(with({"--memory", "much"}), 2, {"--memory", "much"});
    expectRefusal({"recommend", "--relief", "city", "--seconds", "0"}, 2, {"--seconds", "0"});
    expectRefusal(with({"--outliers", "101"}), 2, {"--outliers", "101"});
    expectRefusal(with({"--height", "x.png"}), 2, {"--height", "--relief"});
    expectRefusal({"recommend", "--relief", "city", "--form", "wide"}, 2, {"wide", "simd, scalar"});
    expectRefusal(with({"--fetches", "4"}), 2, {"--fetches", "--form shader"});
    const auto shader = [&](const std::vector<std::string>& more, const std::vector<std::string>& parts) {
        std::vector<std::string> all{"recommend", "--relief", "city:16x16", "--form", "shader"};
        all.insert(all.end(), more.begin(), more.end());
        expectRefusal(all, 2, parts);
    };
    shader({"--fetches", "0"}, {"--fetches", "0"});
    shader({"--error", "2"}, {"--error", "2"});
    shader({"--surface", "columns"}, {"--surface", "bilinear"});
    for (const char* const option : {"--outliers", "--step-cost"}) shader({option, "1"}, {option, "--form shader"});
    shader({"--check"}, {"--check", "--form shader"});
    expectRefusal({"recommend", "--height", path("none.png")}, 2, {"none.png", "no such file"});
    expectRefusal({"recommend"}, 2, {"no height map"});
    expectRefusal(with({"-o", path("no/a.txt")}), 1, {"no"});
    expectRefusal(with({"--check", "-o", path("regret.json")}), 2, {"--check", path("regret.json")});
    EXPECT_TRUE(files().empty());
}

}  // namespace relief::test
