// relief make, render, list, compare, info: the examples of README, and the files that they write.
#include <cmath>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

using Json = nlohmann::json;

class RenderTest : public CommandTest {};
INSTANTIATE_TEST_SUITE_P(Places, RenderTest, testing::ValuesIn(places()), placeName);

TEST_P(RenderTest, FromNothingToAWall) {
    const std::string height = makeRelief("bricks", "x.png");
    EXPECT_EQ(runFine({"render", "--height", height, "--scene", "wall", "-o", path("y.png")}), "");
    EXPECT_EQ(read("y.png").substr(1, 3), "PNG");
    const std::string info = runFine({"info", path("y.png")});
    EXPECT_NE(info.find("800 x 600"), std::string::npos) << info;
    EXPECT_EQ(files(), (std::vector<std::string>{"x.png", "y.png"}));
}

TEST_P(RenderTest, EveryReliefIsMadeTheSameTwice) {
    const Json list = Json::parse(runFine({"list", "--json"}));
    ASSERT_EQ(list["reliefs"].size(), 11U);
    for (const Json& relief : list["reliefs"]) {
        const std::string name = relief["name"];
        const std::vector<std::string> size =
            relief["any_size"] ? std::vector<std::string>{"--size", "33x17"} : std::vector<std::string>{};
        makeRelief(name, "a.png", size);
        makeRelief(name, "b.png", size);
        EXPECT_EQ(read("a.png"), read("b.png")) << name;
    }
    makeRelief("fractal", "a.exr", {"--seed", "18446744073709551615"});
    makeRelief("fractal", "b.exr", {"--seed", "2"});
    EXPECT_NE(read("a.exr"), read("b.exr"));
    const std::string info = runFine({"info", path("a.exr")});
    EXPECT_NE(info.find("float"), std::string::npos) << info;
    EXPECT_NE(runFine({"info", path("a.png")}).find("uint16"), std::string::npos);
    expectRefusal({"make", "bricks", "-o", path("a.jpg")}, 2, {path("a.jpg"), ".png"});
    expectRefusal({"make", "bricks", "-o", path("no/a.png")}, 1, {path("no/a.png")});
}

TEST_P(RenderTest, SameBytesForAnyNumberOfThreads) {
    const std::string height = makeRelief("city", "h.png", {"--size", "96"});
    for (const std::string scene : {"floor", "wall", "cube"}) {
        runFine({"render", "--height", height, "--scene", scene, "--size", "200x150", "--threads", "1", "-o",
                 path("one.exr")});
        runFine({"render", "--height", height, "--scene", scene, "--size", "200x150", "--threads", "2", "-o",
                 path("two.exr")});
        EXPECT_TRUE(withoutDate(read("one.exr")) == withoutDate(read("two.exr"))) << scene;
    }
}

TEST_P(RenderTest, TheReportContainsWorkDoneAndSkipped) {
    const std::string height = makeRelief("columns", "h.png", {"--size", "64"});
    runFine({"render", "--height", height, "--scene", "cube", "--size", "120x90", "-o", path("p.png"), "--report",
             path("r.json")});
    const Json report = Json::parse(read("r.json"));
    EXPECT_EQ(report["tool"], "relief");
    EXPECT_EQ(report["scenario"]["scene"], "cube");
    EXPECT_EQ(report["counters"]["polygons"], 6);
    EXPECT_GE(report["counters"]["polygons culled: facing away"].get<double>(), 3);
    EXPECT_EQ(report["counters"]["polygons culled: off screen"], 0);
    EXPECT_GT(report["counters"]["rays traced"].get<double>(), 0);
    EXPECT_GT(report["counters"]["steps"].get<double>(), 0);
    EXPECT_TRUE(report["counters"].contains("rays not needed: the start is the highest point"));
    // The max pyramid, and its depths for SIMD.
    EXPECT_EQ(report["maps"]["builds"], 2);
    EXPECT_GE(report["maps"]["build_seconds"].get<double>(), 0);
    EXPECT_GT(report["seconds"]["total"].get<double>(), 0);
    EXPECT_EQ(report["stages"].size(), 4U);
    for (const Json& stage : report["stages"]) EXPECT_EQ(stage["reused"], false);
    const Json again =
        Json::parse(runFine({"render", "--height", height, "--size", "40x30", "-o", path("p.png"), "--report", "-"}));
    EXPECT_EQ(again["scenario"]["size"], (Json{40, 30}));
    // Shadows need the packed cones; then the hits are found with them, too.
    EXPECT_EQ(again["walks"], (Json{{"hits", "max-pyramid"}, {"steps", "max-pyramid"}}));
    const Json lit = Json::parse(
        runFine({"render", "--height", height, "--size", "40x30", "--shadows", "-o", path("p.png"), "--report", "-"}));
    EXPECT_EQ(lit["walks"], (Json{{"hits", "cone"}, {"steps", "max-pyramid"}}));
    EXPECT_EQ(lit["mapping"], (Json{{"name", "direct"}, {"off_direct_texels", 0.0}}));
    const auto wall = [&](const std::string& tracer) {
        return Json::parse(
            runFine({"render", "--height", height, "--size", "40x30", "--scene", "wall", "--camera", "azimuth=55",
                     "--mapping", "affine", "--tracer", tracer, "-o", path("p.png"), "--report", "-"}));
    };
    const Json bent = wall("max-pyramid");
    EXPECT_EQ(bent["mapping"]["name"], "affine");
    EXPECT_GT(bent["mapping"]["off_direct_texels"], 1);
    EXPECT_FALSE(lit.contains("ellipse")) << "bilinear needs no ellipse";
    const Json rows = Json::parse(runFine({"render", "--height", height, "--size", "40x30", "--filter",
                                           "elliptical:ellipse=cached", "-o", path("p.png"), "--report", "-"}));
    EXPECT_EQ(rows["ellipse"]["name"], "cached");
    EXPECT_GT(rows["ellipse"]["off_direct"], 0);
    EXPECT_LT(rows["ellipse"]["off_direct"], 1e-4);
    EXPECT_FALSE(wall("displacement").contains("mapping")) << "triangles are not mapped row by row";
}

// For work skipped within an error bound the report contains the measured error.
TEST_P(RenderTest, TheReportContainsTheErrorOfBoundedWork) {
    const Json report =
        Json::parse(runFine({"render", "--relief", "hills", "--scene", "floor", "--size", "96x64", "--bounded", "0.5",
                             "--relief-depth", "0.02", "-o", path("p.png"), "--report", "-"}));
    double most = 0;
    for (const Json& row : report["skipped"]["bounded"]) {
        EXPECT_EQ(row["bound_texels"], 0.5) << row;
        ASSERT_TRUE(row.contains("error_texels") || row.contains("error_linear")) << row;
        if (!row.contains("error_texels")) continue;
        EXPECT_LE(row["error_texels"]["mean"].get<double>(), row["error_texels"]["max"].get<double>());
        EXPECT_GE(row["wrong_outcomes"].get<int>(), 0);
        if (row["count"].get<double>() > 0) most = row["error_texels"]["max"].get<double>();
    }
    EXPECT_GT(most, 0) << "nothing was skipped";
    EXPECT_LE(most, 0.5);
    expectRefusal({"render", "--relief", "hills", "--layers", "depth,depth", "-o", path("p.exr")}, 2, {"--layers"});
}

// If a method is named again, it is the scenario's own with its options.
TEST_P(RenderTest, AScenariosMethodKeepsItsOptions) {
    runFine({"render", "--relief", "bricks", "--tracer", "layers", "--set", "layers=7", "--size", "24x16", "-o",
             path("p.png"), "--report", path("r.json")});
    const std::string scenario = write("s.json", Json::parse(read("r.json"))["scenario"].dump());
    const auto method = [&](const char* name) {
        return Json::parse(runFine(
            {"render", scenario, "--tracer", name, "-o", path("p.png"), "--report", "-"}))["scenario"]["method"];
    };
    EXPECT_EQ(method("layers")["layers"], Json::parse(read("r.json"))["scenario"]["method"]["layers"]);
    EXPECT_EQ(method("layers"), Json::parse(read("r.json"))["scenario"]["method"]);
    EXPECT_EQ(method("offset")["name"], "offset");
}

TEST_P(RenderTest, AScenarioComesBack) {
    const std::string height = makeRelief("hills", "h.png", {"--size", "64"});
    runFine({"render",
             "--height",
             height,
             "--scene",
             "wall",
             "--camera",
             "elevation=12.5,azimuth=-30,distance=1.25",
             "--light",
             "azimuth=10,ambient=0.5",
             "--relief-depth",
             "0.2",
             "--address",
             "clamp",
             "--surface",
             "columns",
             "--size",
             "100x80",
             "-o",
             path("first.png"),
             "--report",
             path("r.json")});
    const std::string scenario = write("вид.json", Json::parse(read("r.json"))["scenario"].dump());
    runFine({"render", scenario, "-o", path("second.png")});
    EXPECT_EQ(read("first.png"), read("second.png"));
    // An option overrides the scenario, the rest of which is kept.
    const Json report =
        Json::parse(runFine({"render", scenario, "--scene", "floor", "-o", path("third.png"), "--report", "-"}));
    EXPECT_EQ(report["scenario"]["scene"], "floor");
    EXPECT_EQ(report["scenario"]["relief"]["depth"], 0.2);
    EXPECT_NE(read("first.png"), read("third.png"));
    const std::string info = runFine({"info", scenario});
    EXPECT_NE(info.find("max-pyramid"), std::string::npos) << info;
    EXPECT_NE(info.find("100 x 80"), std::string::npos) << info;
    expectRefusal({"render", path("none.json"), "-o", path("p.png")}, 2, {path("none.json"), "no such file"});
    expectRefusal({"render", write("bad.json", "{\n\"reliefscope\": 1,\n"), "-o", path("p.png")}, 2,
                  {path("bad.json"), "line"});
    expectRefusal({"render", write("odd.json", "{\"reliefscope\": 1,\n\"sceen\": \"wall\"}"), "-o", path("p.png")}, 2,
                  {path("odd.json"), "line 2", "sceen"});
}

TEST_P(RenderTest, TheTraceOfAPixelIsWhatTheLayersHold) {
    const std::string height = makeRelief("bricks", "h.png", {"--size", "64"});
    runFine({"render", "--height", height, "--size", "60x40", "-o", path("layers.exr"), "--layers",
             "color,depth,uv,normal,steps,outcome"});
    const std::string info = runFine({"info", path("layers.exr"), "--channel", "steps.Y", "--range", "0,999"});
    for (const std::string name : {"R, G, B", "depth.Z", "uv.u", "normal.X", "steps.Y", "outcome.Y"}) {
        EXPECT_NE(info.find(name), std::string::npos) << info;
    }
    expectRefusal({"render", "--height", height, "-o", path("x.exr"), "--layers", "colour"}, 2, {"colour", "color"});
    expectRefusal({"render", "--height", height, "-o", path("x.png"), "--layers", "color"}, 2, {path("x.png"), ".exr"});
}

TEST_P(RenderTest, AProceduralReliefNeedsNoFile) {
    const std::string height = makeRelief("pits", "h.exr", {"--size", "48x32", "--seed", "5"});
    runFine({"render", "--height", height, "--size", "60x40", "-o", path("a.png")});
    runFine({"render", "--relief", "pits:48x32:5", "--size", "60x40", "-o", path("b.png")});
    EXPECT_EQ(read("a.png"), read("b.png"));
    expectRefusal({"render", "--relief", "pits:48x", "-o", path("b.png")}, 2, {"--relief"});
    expectRefusal({"render", "--relief", "moon", "-o", path("b.png")}, 2, {"--relief", "moon"});
}

TEST_P(RenderTest, OldOutputsSurviveFailures) {
    const std::string height = makeRelief("fractal", "h.png");
    for (const std::string name : {"p.png", "p.jpg", "p.tif", "p.exr", "p.hdr"}) {
        write(name, "old");
        const auto before = files();
        RunSetup small;
        small.largestFile = 2048;
        expectRefusal({"render", "--height", height, "-o", path(name)}, 1, {path(name)}, small);
        EXPECT_EQ(read(name), "old");
        EXPECT_EQ(files(), before);
    }
    expectRefusal({"render", "--height", height, "-o", path("no/p.png")}, 1, {path("no/p.png")});
    expectRefusal({"render", "--height", height, "-o", path("p.gif7")}, 2, {path("p.gif7"), ".png"});
    expectRefusal({"render", "--height", height, "-o", path("p")}, 2, {".png"});
    std::filesystem::create_directory(path("d.png"));
    expectRefusal({"render", "--height", height, "-o", path("d.png")}, 1, {path("d.png"), "directory"});
}

TEST_P(RenderTest, ComparedPictures) {
    const std::string height = makeRelief("bricks", "h.png", {"--size", "64"});
    runFine({"render", "--height", height, "--size", "80x60", "-o", path("a.png")});
    runFine({"render", "--height", height, "--size", "80x60", "--tracer", "exact", "-o", path("b.png")});
    runFine({"render", "--height", height, "--size", "80x60", "--relief-depth", "0.3", "-o", path("c.png")});
    EXPECT_EQ(runFine({"compare", path("a.png"), path("a.png")}), "RMSE 0\nPSNR inf\nFLIP 0\n");
    EXPECT_EQ(runFine({"compare", path("a.png"), path("b.png")}), "RMSE 0\nPSNR inf\nFLIP 0\n");
    const auto out = lines(runFine({"compare", path("a.png"), path("c.png"), "-o", path("e.png")}));
    ASSERT_EQ(out.size(), 3U);
    EXPECT_EQ(out[0].substr(0, 7), "RMSE 0.");
    EXPECT_EQ(out[2].substr(0, 7), "FLIP 0.");
    EXPECT_EQ(read("e.png").substr(1, 3), "PNG");
    runFine({"compare", path("a.png"), path("c.png"), "-o", path("e.exr")});
    EXPECT_EQ(lines(runFine({"compare", path("e.exr"), path("e.exr")}))[0], "RMSE 0");
    // In the picture the errors are stored as the displayed grey.
    const auto meanOf = [&](const char* picture) {
        const std::string said = runFine({"info", path(picture), "--range", "full"});
        const std::size_t at = said.find("mean height");
        return std::stod(said.substr(said.find_first_of("0123456789", at)));
    };
    EXPECT_NEAR(meanOf("e.png"), meanOf("e.exr"), 0.004);
    EXPECT_GT(meanOf("e.exr"), 0.02);
    const std::string holes = write("nan.exr", exrBytes(2, 1, {0.5F, std::nanf("")}));
    expectRefusal({"compare", holes, holes}, 2, {"nan.exr", "1"});
    runFine({"render", "--height", height, "--size", "81x60", "-o", path("d.png")});
    expectRefusal({"compare", path("a.png"), path("d.png")}, 2, {path("d.png"), "81 x 60", "80 x 60"});
    expectRefusal({"compare", path("a.png"), path("none.png")}, 2, {path("none.png")});
    expectRefusal({"compare", path("a.png"), path("c.png"), "-o", path("no/e.png")}, 1, {path("no/e.png")});
}

TEST_P(RenderTest, TheListIsComplete) {
    const Json list = Json::parse(runFine({"list", "--json"}));
    std::vector<std::string> tracers;
    for (const Json& tracer : list["tracers"]) {
        tracers.push_back(tracer["name"]);
        for (const char* key : {"help", "guarantee", "surfaces", "rays", "maps", "options"}) {
            EXPECT_TRUE(tracer.contains(key)) << key;
        }
    }
    const std::string text = runFine({"list"});
    for (const std::string name : {"exact", "max-pyramid", "max-pyramid-paper"}) {
        EXPECT_NE(std::find(tracers.begin(), tracers.end(), name), tracers.end()) << name;
        EXPECT_NE(text.find("\n  " + name + "\n"), std::string::npos) << name;
    }
    EXPECT_NE(text.find("paper8x8"), std::string::npos);
    EXPECT_NE(text.find("relief-depth"), std::string::npos);
    EXPECT_FALSE(list["numbers"].empty());
}

}  // namespace relief::test
