// The command line as users expect it: a picture wherever a height map is read, options after a name, one spelling of
// sizes; typing errors and misplaced options are answered in one line.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class SpellingTest : public CommandTest {
  protected:
    std::string walls() const { return makeRelief("bricks", "walls.png", {"--size", "32x24"}); }
    // Checks that both commands write the same.
    void expectSame(const std::vector<std::string>& one, const std::vector<std::string>& other) const {
        const Result a = run(one);
        const Result b = run(other);
        EXPECT_EQ(a.status, 0) << a.err;
        EXPECT_EQ(b.status, 0) << b.err;
        EXPECT_EQ(a.out, b.out);
        EXPECT_FALSE(a.out.empty());
    }
    // Returns the picture of `render` with these options.
    std::string picture(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", "-o", path("picture.png"), "--scene", "wall"};
        all.insert(all.end(), more.begin(), more.end());
        runFine(all);
        return read("picture.png");
    }
};
INSTANTIATE_TEST_SUITE_P(Places, SpellingTest, testing::ValuesIn(places()), placeName);

TEST_P(SpellingTest, APictureStandsWhereAHeightMapIsRead) {
    const std::string height = walls();
    EXPECT_EQ(picture({height, "--size", "24x16"}), picture({"--height", height, "--size", "24x16"}));
    expectSame({"trace", height, "--pixel", "400,300"}, {"trace", "--height", height, "--pixel", "400,300"});
    expectSame({"certify", height, "--tracer", "cone", "--rays", "500"},
               {"certify", "--height", height, "--tracer", "cone", "--rays", "500"});
    expectSame({"map", "refined", height, "--at", "3,4,0.95"},
               {"map", "refined", "--height", height, "--at", "3,4,0.95"});
    EXPECT_NE(runFine({"map", "cone", height, "-o", path("map.tif")}).find("32 x 24"), std::string::npos);
    runFine({"certify", height, "--map", path("map.tif"), "--rays", "500"});
    expectRefusal({"recommend", path("none.png")}, 2, {path("none.png") + ": no such file"});
    const auto table = lines(
        run({"bench", "tracers", height, "--tracers", "exact", "--rays", "100", "--rounds", "1", "--elevations", "60"})
            .out);
    ASSERT_EQ(table.size(), 2U);
    EXPECT_EQ(fields(table[1])[0], height);
    // With several pictures, one output for each.
    const std::string other = makeRelief("hills", "hills.png", {"--size", "16"});
    runFine({"render", height, other, "--size", "8", "-o", path("both")});
    EXPECT_EQ(read("both/walls.png"), [&] {
        runFine({"render", height, "--size", "8", "-o", path("one.png")});
        return read("one.png");
    }());
    EXPECT_FALSE(read("both/hills.png").empty());
    expectRefusal({"render", height, "--height", other, "-o", path("x.png")}, 2, {"--height", height});
    expectRefusal({"render", height, "--relief", "bricks", "-o", path("x.png")}, 2, {"--relief", height});
    expectRefusal({"render", path("none.png"), "-o", path("x.png")}, 2, {path("none.png") + ": no such file"});
    expectRefusal({"render", write("letter.txt", "Dear picture\n"), "-o", path("x.png")}, 2, {"letter.txt"});
}

TEST_P(SpellingTest, OptionsStandBesideAName) {
    const std::string height = walls();
    const std::vector<std::string> view{height, "--size", "24x16"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), view.begin(), view.end());
        return more;
    };
    EXPECT_EQ(picture(with({"--tracer", "layers:layers=7"})),
              picture(with({"--tracer", "layers", "--set", "layers=7"})));
    EXPECT_NE(picture(with({"--tracer", "layers:layers=7"})), picture(with({"--tracer", "layers"})));
    EXPECT_EQ(picture(with({"--tracer", "hybrid:inner=layers:inner.layers=5"})),
              picture(with({"--tracer", "hybrid", "--set", "inner=layers", "--set", "inner.layers=5"})));
    EXPECT_EQ(picture(with({"--filter", "supersample:samples=3:pixel-model=gaussian"})),
              picture(with({"--supersample", "3", "--pixel-model", "gaussian"})));
    expectSame({"certify", height, "--tracer", "cone:sectors=4", "--rays", "100"},
               {"certify", height, "--tracer", "cone", "--set", "sectors=4", "--rays", "100"});
    runFine({"map", "refined:layers=5", height, "-o", path("a.tif")});
    runFine({"map", "refined", height, "--set", "layers=5", "-o", path("b.tif")});
    EXPECT_EQ(withoutDate(read("a.tif")), withoutDate(read("b.tif")));
    // A scenario's method keeps its options if only its name is given.
    runFine({"render", height, "--tracer", "layers:layers=7", "--size", "24x16", "-o", path("p.png"), "--report",
             path("r.json")});
    EXPECT_EQ(picture({path("r.json"), "--tracer", "layers"}), picture({path("r.json")}));
    const auto refuse = [&](const std::string& option, const std::string& value,
                            const std::vector<std::string>& parts) {
        expectRefusal({"render", height, option, value, "-o", path("x.png")}, 2, parts);
    };
    refuse("--tracer", "coen", {"--tracer: there is no tracer \"coen\"; did you mean \"cone\"?"});
    refuse("--tracer", "layers:layer=7", {"--tracer", "\"layer\"; did you mean \"layers\"?"});
    refuse("--tracer", "layers:layers=x", {"--tracer: \"layers=x\" is not a number"});
    refuse("--tracer", "layers:7", {"--tracer", "NAME:OPTION=VALUE"});
    refuse("--tracer", "exact:layers=7", {"--tracer: there is no option of exact \"layers\"; none exist"});
    refuse("--filter", "elliptcal", {"--filter", "did you mean \"elliptical\"?"});
    refuse("--filter", "elliptical:sigma=9", {"--filter: sigma is 9"});
    refuse("--filter", "supersample:samples=65", {"--filter: samples is 65"});
    expectRefusal({"map", "refinde", height, "-o", path("x.tif")}, 2, {"did you mean \"refined\"?", "max-pyramid"});
    expectRefusal({"map", "max-pyramid:layers=3", height, "-o", path("x.tif")}, 2, {"\"layers\""});
    expectRefusal({"map", "cone:sektors=4", height, "-o", path("x.tif")}, 2, {"did you mean \"sectors\"?"});
    expectRefusal({"bench", "tracers", height, "--tracers", "exact,coen"}, 2, {"--tracers", "\"cone\"?"});
    expectRefusal({"make", "briks", "-o", path("x.png")}, 2, {"did you mean \"bricks\"?"});
}

TEST_P(SpellingTest, SizesHaveOneSpelling) {
    const auto sized = [&](const std::vector<std::string>& make) {
        runFine(make);
        return nlohmann::json::parse(runFine({"info", path("x.png"), "--json"}));
    };
    EXPECT_EQ(sized({"make", "bricks", "--size", "24", "-o", path("x.png")})["height"], 24);
    EXPECT_EQ(sized({"make", "bricks:24x12:3", "-o", path("x.png")})["height"], 12);
    const std::string picture = read("x.png");
    sized({"make", "bricks", "--size", "24x12", "--seed", "3", "-o", path("x.png")});
    EXPECT_EQ(read("x.png"), picture);
    EXPECT_EQ(sized({"render", "--relief", "bricks:24", "--size", "16", "-o", path("x.png")})["width"], 16);
    const std::vector<std::string> bench{"bench",        "tracers", "--relief", "hills",    "--tracers",
                                         "exact",        "--rays",  "100",      "--rounds", "1",
                                         "--elevations", "60",      "--sizes",  "16,24x12"};
    const auto table = lines(run(bench).out);
    ASSERT_EQ(table.size(), 3U);
    EXPECT_EQ(fields(table[1])[0], "hills:16x16:1");
    EXPECT_EQ(fields(table[2])[0], "hills:24x12:1");
    expectRefusal({"claims", "--measure", "--size", "64x32"}, 2, {"--size", "64x32 is not square"});
    expectRefusal({"make", "bricks:24", "--size", "32", "-o", path("x.png")}, 2, {"--size", "bricks:24"});
    expectRefusal({"make", "bricks:24:3", "--seed", "4", "-o", path("x.png")}, 2, {"--seed", "bricks:24:3"});
    expectRefusal({"make", "bricks:big", "-o", path("x.png")}, 2, {"\"big\" is not a size", "512 for 512x512"});
}

// No option is ignored silently.
TEST_P(SpellingTest, OptionsOutOfPlaceAreRefused) {
    const std::string height = walls();
    expectRefusal({"bench", "tracers", height, "--filters", "nearest"}, 2,
                  {"--filters: is an option of relief bench filters, not of relief bench tracers"});
    expectRefusal({"bench", "rows", height}, 2,
                  {"relief bench tracers, relief bench filters, not of relief bench rows"});
    expectRefusal({"bench", "rows", "--rays", "5"}, 2, {"--rays", "relief bench tracers"});
    expectRefusal({"bench", "filters", "--widths", "100"}, 2, {"--widths", "relief bench rows"});
    expectRefusal({"bench", "filters", height, "--scenes", "bricks"}, 2, {"--scenes", "--height"});
    expectRefusal({"bench", "filters", "--color", height}, 2, {"--color", "needs --height"});
    expectRefusal({"recommend", height, "--step-cost", "5"}, 2, {"--step-cost: needs --form scalar"});
    expectRefusal({"recommend", height, "--check", "--json"}, 2, {"--json", "--check"});
    expectRefusal({"recommend", height, "--no-filter", "--color", height}, 2, {"--no-filter", "--color"});
    expectRefusal({"trace", height, "--ray", "1,2,3,4", "--camera", "elevation=30"}, 2, {"--camera", "--ray"});
    const auto refuse = [&](const std::vector<std::string>& more, const std::vector<std::string>& parts) {
        std::vector<std::string> all{"render", height, "-o", path("x.png")};
        all.insert(all.end(), more.begin(), more.end());
        expectRefusal(all, 2, parts);
    };
    refuse({"--camera", "elevation=30,elevation=40"}, {"--camera elevation: is given more than once"});
    refuse({"--light", "ambient=0,ambient=0"}, {"--light ambient: is given more than once"});
    refuse({"--tracer", "layers", "--set", "layers=4", "--set", "layers=5"}, {"--set layers: is given more than once"});
    refuse({"--pixel-model", "gaussian"}, {"--pixel-model: needs --supersample"});
    refuse({"--map", write("m.tif", "x"), "--tracer", "exact"}, {"m.tif"});
    // Options that depend on each other are checked where they were given.
    refuse({"--tracer", "distance-refined:sectors=3"}, {"--tracer: sectors is 3"});
    refuse({"--tracer", "distance-refined", "--set", "sectors=3"}, {"--set: sectors is 3"});
    for (const char* const option : {"sectors=4", "horizons=8", "flattest=5"}) {
        refuse({"--tracer", std::string("distance-conservative:") + option}, {"--tracer: ", "needs map=refined"});
        refuse({"--tracer", std::string("hybrid:inner.") + option}, {"--tracer: ", "needs map=refined"});
    }
    runFine({"render", walls(), "--size", "8x8", "--tracer", "distance-conservative:map=refined:sectors=4:flattest=20",
             "-o", path("x.png")});
    expectRefusal({"bench", "tracers", "--relief", "city:16x16", "--tracers", "distance-conservative:sectors=4"}, 2,
                  {"--tracers: sectors: needs map=refined"});
}

// The message names the file and the line for every kind of error.
TEST_P(SpellingTest, ScenarioFaultsNameFileAndLine) {
    const std::string height = walls();
    runFine({"render", height, "--size", "24x16", "--filter", "elliptical:sigma=0.6", "-o", path("p.png"), "--report",
             path("r.json")});
    EXPECT_EQ(picture({path("r.json")}), picture({height, "--size", "24x16", "--filter", "elliptical:sigma=0.6"}));
    const auto scenario = nlohmann::ordered_json::parse(read("r.json"))["scenario"];
    // fault: the beginning of the value in the file.
    const auto refuse = [&](const std::string& key, const nlohmann::ordered_json& value, const std::string& fault,
                            const std::string& what) {
        auto changed = scenario;
        changed[nlohmann::ordered_json::json_pointer(key)] = value;
        const std::string text = changed.dump(1);
        const auto at = text.begin() + static_cast<std::ptrdiff_t>(text.find(fault));
        const std::string line = std::to_string(1 + std::count(text.begin(), at, '\n'));
        expectRefusal({"render", write("s.json", text), "-o", path("x.png")}, 2,
                      {path("s.json") + ": line " + line + ": " + what});
    };
    refuse("/method/name", "coen", "\"coen\"", "there is no tracer \"coen\"; did you mean \"cone\"?");
    refuse("/filter-options/sigma", 9, "\"sigma\": 9", "sigma is 9");
    refuse("/method/options", {{"base", "x"}}, "\"base\"", "\"base=x\" is not a number");
    auto empty = scenario;
    empty["pictures"] = nlohmann::ordered_json::object();
    expectRefusal({"render", write("s.json", empty.dump()), "-o", path("x.png")}, 2,
                  {path("s.json") + ": there is no height map"});
    expectRefusal({"render", write("n.json", "[1]"), "-o", path("x.png")}, 2,
                  {"n.json: line 1: a JSON object is expected"});
    expectRefusal({"render", write("n.json", "{\"a\": 1}"), "-o", path("x.png")}, 2,
                  {"n.json: is not a scenario: \"reliefscope\" is missing"});
    // A file whose content begins like a scenario is one, whatever its name.
    EXPECT_EQ(picture({write("scenario", "\n " + scenario.dump())}), picture({path("r.json")}));
}

TEST_P(SpellingTest, ComparisonsForPrograms) {
    const std::string a = makeRelief("bricks", "a.png", {"--size", "16"});
    const std::string b = makeRelief("hills", "b.png", {"--size", "16"});
    const auto same = nlohmann::json::parse(runFine({"compare", a, a, "--json", "--max-flip", "0"}));
    EXPECT_EQ(same["rmse"], 0);
    EXPECT_TRUE(same["psnr"].is_null()) << same;
    EXPECT_TRUE(same["passed"].get<bool>()) << same;
    const auto apart = nlohmann::json::parse(runFine({"compare", a, b, "--json"}));
    const double flip = apart["flip"];
    EXPECT_GT(flip, 0.1);
    EXPECT_FALSE(apart.contains("passed"));
    EXPECT_EQ(apart["width"], 16);
    const Result above = run({"compare", a, b, "--max-flip", "0.1", "--json"});
    EXPECT_EQ(above.status, 1);
    EXPECT_EQ(above.err.find("relief: " + b + ": FLIP 0."), 0U) << above.err;
    EXPECT_NE(above.err.find("more than 0.1\n"), std::string::npos) << above.err;
    EXPECT_FALSE(nlohmann::json::parse(above.out)["passed"].get<bool>()) << above.out;
    runFine({"compare", a, b, "--max-flip", "1"});
    expectRefusal({"compare", a, b, "--max-flip", "2"}, 2, {"--max-flip", "0 to 1"});
    // Channels that are not compared are mentioned.
    runFine({"render", a, "--size", "8", "--layers", "color,depth", "-o", path("l.exr")});
    const Result layers = run({"compare", path("l.exr"), path("l.exr")});
    EXPECT_EQ(layers.status, 0);
    EXPECT_NE(layers.err.find("l.exr: only R, G and B are compared; channels left out: depth.Z"), std::string::npos)
        << layers.err;
}

// As in `relief ... | head`: ends without a message, as other programs end by SIGPIPE.
TEST_P(SpellingTest, AClosedPipeEndsSilently) {
    RunSetup closed;
    closed.launcher = {"/bin/bash", "-c", "\"$0\" \"$@\" | true; exit ${PIPESTATUS[0]}"};
    const Result help = run({"--help"}, closed);
    // Output that fits into the pipe before the reader ends is written.
    EXPECT_TRUE(help.status == 141 || help.status == 0) << help.status;
    EXPECT_EQ(help.err, "");
    // The pipe is closed before the program starts.
    closed.launcher[2] = "(sleep 0.3; exec \"$0\" \"$@\") | true; exit ${PIPESTATUS[0]}";
    const Result gone = run({"list"}, closed);
    EXPECT_EQ(gone.status, 141);
    EXPECT_EQ(gone.err, "");
}

}  // namespace relief::test
