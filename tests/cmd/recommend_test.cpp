// relief recommend: texts, JSON, files, refusals.
#include <set>

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

TEST_P(RecommendTest, Refusals) {
    expectRefusal(with({"--views", "70,10"}), 2, {"--views", "70,10"});
    expectRefusal(with({"--views", "flat"}), 2, {"--views", "flat"});
    expectRefusal(with({"--error", "-1"}), 2, {"--error", "-1"});
    expectRefusal(with({"--memory", "much"}), 2, {"--memory", "much"});
    expectRefusal({"recommend", "--relief", "city", "--seconds", "0"}, 2, {"--seconds", "0"});
    expectRefusal(with({"--outliers", "101"}), 2, {"--outliers", "101"});
    expectRefusal(with({"--height", "x.png"}), 2, {"--height", "--relief"});
    expectRefusal({"recommend", "--relief", "city", "--form", "wide"}, 2, {"wide", "simd, scalar"});
    expectRefusal({"recommend", "--height", path("none.png")}, 2, {"none.png", "no such file"});
    expectRefusal({"recommend"}, 2, {"no height map"});
    expectRefusal(with({"-o", path("no/a.txt")}), 1, {"no"});
}

}  // namespace relief::test
