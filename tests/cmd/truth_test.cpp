// relief render --supersample, --shadows and the methods that are not tracers; relief compare on their pictures.
#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

using Json = nlohmann::json;

class TruthTest : public CommandTest {
  protected:
    std::vector<std::string> render(const std::string& output, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", "--relief", "bricks:64x64:1", "--size", "60x45", "-o", path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, TruthTest, testing::ValuesIn(places()), placeName);

TEST_P(TruthTest, SupersamplingIsAFilterAndAnOption) {
    runFine(render("plain.png", {}));
    runFine(render("one.png", {"--supersample", "1"}));
    EXPECT_EQ(read("plain.png"), read("one.png")) << "one sample is the plain picture";
    runFine(render("eight.png", {"--supersample", "8", "--threads", "1"}));
    runFine(render("filter.png", {"--filter", "supersample", "--threads", "2"}));
    EXPECT_EQ(read("eight.png"), read("filter.png"));
    EXPECT_NE(read("eight.png"), read("one.png"));
    const Json report = Json::parse(
        runFine(render("bell.png", {"--supersample", "3", "--pixel-model", "gaussian", "--shadows", "--report", "-"})));
    EXPECT_EQ(report["scenario"]["filter"], "supersample");
    EXPECT_EQ(report["scenario"]["supersample"], 3);
    EXPECT_EQ(report["scenario"]["pixel-model"], "gaussian");
    EXPECT_EQ(report["scenario"]["shadows"], true);
    EXPECT_EQ(report["counters"]["samples a pixel"], 9);
    EXPECT_GT(report["counters"]["samples: rays traced"].get<double>(),
              8 * report["counters"]["rays traced"].get<double>());
    const std::string scenario = write("s.json", report["scenario"].dump());
    runFine({"render", scenario, "-o", path("again.png")});
    EXPECT_EQ(read("bell.png"), read("again.png"));
    expectRefusal(render("x.png", {"--supersample", "65"}), 2, {"--supersample", "64"});
    expectRefusal(render("x.png", {"--supersample", "0"}), 2, {"--supersample"});
    expectRefusal(render("x.png", {"--supersample", "2", "--filter", "nearest"}), 2, {"--supersample", "nearest"});
    expectRefusal(render("x.png", {"--pixel-model", "gaussian"}), 2, {"--pixel-model", "--supersample"});
    expectRefusal(render("x.png", {"--supersample", "2", "--pixel-model", "tent"}), 2, {"tent", "gaussian"});
    expectRefusal({"render", write("bad.json", "{\"reliefscope\": 1,\n\"supersample\": 65}"), "-o", path("x.png")}, 2,
                  {path("bad.json"), "65"});
}

TEST_P(TruthTest, ShadowsAreCountedAndOldScenariosHaveNone) {
    const Json report =
        Json::parse(runFine(render("dark.png", {"--shadows", "--light", "elevation=20", "--report", "-"})));
    const auto counted = [&](const char* what) { return report["counters"][what].get<double>(); };
    const double decided = counted("shadow rays not needed: decided by bounds of the horizon");
    EXPECT_GT(decided, 0);
    EXPECT_GT(counted("shadow rays") + decided, 100);
    EXPECT_GT(counted("shadow rays blocked") + counted("hits in shadow by bounds of the horizon"), 50);
    EXPECT_EQ(report["stages"].size(), 5U);
    // The max pyramid, its depths for SIMD, and the cones for shadow rays.
    EXPECT_EQ(report["maps"]["builds"], 3);
    Json old = report["scenario"];
    old.erase("shadows");
    const std::string scenario = write("old.json", old.dump());
    const Json plain = Json::parse(runFine({"render", scenario, "-o", path("lit.png"), "--report", "-"}));
    EXPECT_FALSE(plain["counters"].contains("shadow rays"));
    EXPECT_NE(read("dark.png"), read("lit.png"));
}

TEST_P(TruthTest, MethodsThatAreNoTracersWorkEverywhere) {
    const std::string text = runFine({"list"});
    const std::size_t shading = text.find("\nShading only");
    const std::size_t meshes = text.find("\nMeshes");
    for (const std::string name : {"flat", "bump", "normal-map"}) {
        const std::size_t at = text.find("\n  " + name + "\n");
        EXPECT_TRUE(at > shading && at < meshes) << name;
    }
    EXPECT_GT(text.find("\n  displacement\n"), meshes);
    std::vector<std::string> pictures;
    for (const std::string name : {"flat", "bump", "normal-map", "displacement"}) {
        runFine(render(name + ".png", {"--tracer", name}));
        pictures.push_back(read(name + ".png"));
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back()) << name;
        const auto hits = lines(runFine({"trace", "--relief", "bricks:64x64:1", "--size", "60x45", "--tracer", name,
                                         "--pixel", "30,25", "--steps", path("s.csv")}));
        ASSERT_EQ(hits.size(), 2U);
        EXPECT_EQ(fields(hits[1])[0], "hit") << name;
        const auto steps = lines(read("s.csv"));
        ASSERT_GE(steps.size(), 3U);
        EXPECT_NE(steps[1].find("start"), std::string::npos);
        EXPECT_NE(steps.back().find("hit"), std::string::npos);
    }
    expectRefusal(render("x.png", {"--tracer", "displacement", "--set", "density=0"}), 2, {"density"});
}

TEST_P(TruthTest, PixelsPerDegreeChangeFlipAlone) {
    runFine(render("a.png", {}));
    runFine(render("b.png", {"--relief-depth", "0.2"}));
    const auto usual = lines(runFine({"compare", path("a.png"), path("b.png")}));
    EXPECT_EQ(lines(runFine({"compare", path("a.png"), path("b.png"), "--ppd", "67"})), usual);
    const auto near = lines(runFine({"compare", path("a.png"), path("b.png"), "--ppd", "20"}));
    EXPECT_EQ(near[0], usual[0]);
    EXPECT_EQ(near[1], usual[1]);
    EXPECT_NE(near[2], usual[2]);
    expectRefusal({"compare", path("a.png"), path("b.png"), "--ppd", "0"}, 2, {"--ppd"});
    const std::string help = runFine({"compare", "--help"});
    EXPECT_NE(help.find("67"), std::string::npos);
}

}  // namespace relief::test
