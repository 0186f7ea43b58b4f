// relief trace: the files that it reads and writes, exactly as scripts rely on them.
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "command_test.h"
#include "images/tiled_writer.h"
#include "scenario/scenario.h"

namespace relief::test {

namespace {

double number(const std::string& text) {
    double value = std::nan("");
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_TRUE(error == std::errc() && end == text.data() + text.size()) << text;
    return value;
}

std::string seventeen(double value) {
    char buffer[64];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 17);
    EXPECT_TRUE(error == std::errc());
    return {buffer, end};
}

}  // namespace

class TraceTest : public CommandTest {
  protected:
    std::string height() const { return makeRelief("bricks", "height.png", {"--size", "64x48"}); }
};
INSTANTIATE_TEST_SUITE_P(Places, TraceTest, testing::ValuesIn(places()), placeName);

TEST_P(TraceTest, HitsAreAsPromised) {
    const std::string rays = write("rays.csv", "s0,t0,a,b\n3.25,4.5,0,0\n1,2,10.5,-7\n-1000.5,1e3,1e5,3e-1\n");
    const std::string field = height();
    for (const std::string tracer : {"exact", "max-pyramid", "max-pyramid-paper"}) {
        const auto out = lines(runFine({"trace", "--height", field, "--tracer", tracer, "--rays", rays}));
        ASSERT_EQ(out.size(), 4U);
        EXPECT_EQ(out[0], "outcome,lambda,s,t,steps");
        const double given[3][4] = {{3.25, 4.5, 0, 0}, {1, 2, 10.5, -7}, {-1000.5, 1e3, 1e5, 3e-1}};
        for (std::size_t r = 0; r < 3; ++r) {
            const auto f = fields(out[r + 1]);
            ASSERT_EQ(f.size(), 5U) << out[r + 1];
            EXPECT_EQ(f[0], "hit");
            const double lambda = number(f[1]);
            EXPECT_GE(lambda, 0);
            EXPECT_LE(lambda, 1);
            // Positions are unwrapped, and 17 digits read back to the same double.
            EXPECT_DOUBLE_EQ(number(f[2]), given[r][0] + lambda * given[r][2]);
            EXPECT_DOUBLE_EQ(number(f[3]), given[r][1] + lambda * given[r][3]);
            for (int c = 1; c <= 3; ++c) {
                EXPECT_EQ(f[static_cast<std::size_t>(c)], seventeen(number(f[static_cast<std::size_t>(c)])));
            }
            EXPECT_GE(number(f[4]), 1);
        }
    }
}

TEST_P(TraceTest, MissesLeaveTheirFieldsEmpty) {
    const std::string rays = write("rays.csv", "s0,t0,a,b\n-5,4,1,1\n32,24,0,0\n");
    const auto out = lines(runFine({"trace", "--height", height(), "--address", "border", "--rays", rays}));
    ASSERT_EQ(out.size(), 3U);
    EXPECT_EQ(out[1].substr(0, 8), "miss,,,,");
    EXPECT_EQ(out[2].substr(0, 4), "hit,");
}

TEST_P(TraceTest, LineEndsMarksAndStandardInput) {
    const std::string field = height();
    const std::string plain = "s0,t0,a,b\n1,2,3,4\n5,6,-7,8e0\n";
    const std::string expected = runFine({"trace", "--height", field, "--rays", write("a.csv", plain)});
    for (const std::string text :
         {"s0,t0,a,b\r\n1,2,3,4\r\n5,6,-7,8e0\r\n", "s0,t0,a,b\n1,2,3,4\n5,6,-7,8e0",
          "s0,t0,a,b\n1,2,3,4\n5,6,-7,8e0\n\n", "\xEF\xBB\xBFs0,t0,a,b\n1,2,3,4\n5,6,-7,8e0\n"}) {
        EXPECT_EQ(runFine({"trace", "--height", field, "--rays", write("b.csv", text)}), expected) << text;
        RunSetup setup;
        setup.input = text;
        EXPECT_EQ(runFine({"trace", "--height", field, "--rays", "-"}, setup), expected) << text;
    }
    EXPECT_EQ(runFine({"trace", "--height", field, "--rays", write("c.csv", "s0,t0,a,b\n")}),
              "outcome,lambda,s,t,steps\n");
    EXPECT_EQ(runFine({"trace", "--height", field, "--rays", path("a.csv"), "-o", path("hits.csv")}), "");
    EXPECT_EQ(read("hits.csv"), expected);
}

TEST_P(TraceTest, RaysOfTheCommandLine) {
    const std::string field = height();
    const std::string rays = write("rays.csv", "s0,t0,a,b\n-1000.5,1e3,1e5,3e-1\n5,5,1e-310,-0\n");
    const std::string expected = runFine({"trace", "--height", field, "--rays", rays});
    EXPECT_EQ(runFine({"trace", "--height", field, "--ray", "-1000.5,1e3,1e5,3e-1", "--ray", "5,5,1e-310,-0"}),
              expected);
    for (const std::string wrong : {"1,2,3", "1,2,3,4,5", "1,2,3,nan", "1,2,3,1e999", "1,2,3,x", ""}) {
        expectRefusal({"trace", "--height", field, "--ray", wrong}, 2, {"--ray", "S0,T0,A,B"});
    }
    expectRefusal({"trace", "--height", field, "--ray", "1,2,3,4", "--pixel", "1,1"}, 2, {"--ray", "--pixel"});
    expectRefusal({"trace", "--height", field, "--ray", "1,2,3,4", "--rays", rays}, 2, {"--ray", "--rays"});
}

TEST_P(TraceTest, BadRaysAreNamedByLine) {
    const std::string field = height();
    write("hits.csv", "old\n");
    const auto refuse = [&](const std::string& text, const std::vector<std::string>& parts) {
        std::vector<std::string> all = parts;
        const std::string rays = write("rays.csv", text);
        all.push_back(rays);
        expectRefusal({"trace", "--height", field, "--rays", rays, "-o", path("hits.csv")}, 2, all);
        EXPECT_EQ(read("hits.csv"), "old\n");
    };
    refuse("", {});
    refuse("1,2,3,4\n", {"line 1", "s0,t0,a,b"});
    refuse("s0;t0;a;b\n1;2;3;4\n", {"line 1"});
    refuse("s0,t0,a,b\n1,2,3,4\n1,2,3\n", {"line 3"});
    refuse("s0,t0,a,b\n1,2,3,4,5\n", {"line 2"});
    refuse("s0,t0,a,b\n1,2,3,4\n\n1,2,3,4\n", {"line 3"});
    refuse("s0,t0,a,b\r\n1,2,three,4\r\n", {"line 2", "three"});
    refuse("s0,t0,a,b\n1,2,3,nan\n", {"line 2", "nan"});
    refuse("s0,t0,a,b\n1,2,3,4\n1,2,inf,4\n", {"line 3", "inf"});
    refuse("s0,t0,a,b\n1,2,3,1e999\n", {"line 2", "1e999"});
    refuse("s0,t0,a,b\n1,5,2,5,3,5,4,5\n", {"line 2"});
    refuse("s0,t0,a,b\n,,,\n", {"line 2"});
    expectRefusal({"trace", "--height", field, "--rays", path("none.csv")}, 2, {path("none.csv")});
    expectRefusal({"trace", "--height", field}, 2, {"--rays"});
    expectRefusal({"trace", "--height", field, "--rays", "-", "--pixel", "1,1"}, 2, {"--rays", "--pixel"});
    expectRefusal({"trace", "--height", field, "--pixel", "1"}, 2, {"--pixel"});
    expectRefusal({"trace", "--height", field, "--pixel", "800,0"}, 2, {"800,0"});
    expectRefusal({"trace", "--height", field, "--pixel", "1,1", "--steps", path("s.txt")}, 2, {".csv"});
}

TEST_P(TraceTest, FlatRaysGiveAnAnswer) {
    const std::string rays =
        write("rays.csv", "s0,t0,a,b\n0,0,1e7,1e7\n1e300,-1e300,1e300,0\n5,5,1e-320,4e-400\n0,0,-1048576,1048576\n");
    const auto out = lines(runFine({"trace", "--height", height(), "--rays", rays}));
    ASSERT_EQ(out.size(), 5U);
    for (std::size_t r = 1; r < out.size(); ++r) {
        EXPECT_EQ(fields(out[r]).size(), 5U) << out[r];
        EXPECT_EQ(out[r].find("nan"), std::string::npos) << out[r];
    }
    EXPECT_EQ(fields(out[4])[0], "hit");
}

TEST_P(TraceTest, ThreadsDoNotMatter) {
    std::string rays = "s0,t0,a,b\n";
    for (int i = 0; i < 20000; ++i) {
        rays += std::to_string(i % 97) + "," + std::to_string(i % 89) + "," + std::to_string(i % 301 - 150) + ".5," +
                std::to_string(i % 211 - 105) + ".25\n";
    }
    write("rays.csv", rays);
    const std::string field = height();
    const std::string one = runFine({"trace", "--height", field, "--rays", path("rays.csv"), "--threads", "1"});
    EXPECT_EQ(lines(one).size(), 20001U);
    EXPECT_EQ(runFine({"trace", "--height", field, "--rays", path("rays.csv"), "--threads", "2"}), one);
    EXPECT_EQ(runFine({"trace", "--height", field, "--rays", path("rays.csv")}), one);
}

TEST_P(TraceTest, StepsTellEveryDecision) {
    const std::string field = height();
    write("rays.csv", "s0,t0,a,b\n1,2,10,-7\n3,4,0,0\n");
    const auto hits =
        lines(runFine({"trace", "--height", field, "--rays", path("rays.csv"), "--steps", path("steps.csv")}));
    const auto steps = lines(read("steps.csv"));
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps[0],
              "ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after,"
              "kind,s,t,z,width,height,index,count");
    std::size_t line = 1;
    for (std::size_t ray = 0; ray < 2; ++ray) {
        const auto count = static_cast<std::size_t>(number(fields(hits[ray + 1])[4]));
        for (std::size_t step = 1; step <= count; ++step, ++line) {
            ASSERT_LT(line, steps.size());
            const auto f = fields(steps[line]);
            ASSERT_EQ(f.size(), 22U);
            EXPECT_EQ(f[14], "texel");
            EXPECT_EQ(f[0], std::to_string(ray));
            EXPECT_EQ(f[1], std::to_string(step));
            EXPECT_DOUBLE_EQ(number(f[9]), 1 - number(f[7]));
            if (step == count) {
                EXPECT_EQ(f[12], "hit");
                EXPECT_EQ(f[13], fields(hits[ray + 1])[1]);
            }
        }
    }
    EXPECT_EQ(line, steps.size());

    runFine({"trace", "--height", field, "--rays", path("rays.csv"), "--steps", path("steps.json")});
    const auto json = nlohmann::json::parse(read("steps.json"));
    ASSERT_EQ(json.size(), steps.size() - 1);
    for (std::size_t s = 0; s < json.size(); ++s) {
        const auto f = fields(steps[s + 1]);
        EXPECT_EQ(json[s]["ray"].get<int>(), static_cast<int>(number(f[0])));
        EXPECT_EQ(json[s]["decision"].get<std::string>(), f[12]);
        EXPECT_EQ(json[s]["lambda_after"].get<double>(), number(f[13]));
    }
    runFine({"trace", "--height", field, "--rays", write("none.csv", "s0,t0,a,b\n"), "--steps", path("none.json")});
    EXPECT_TRUE(nlohmann::json::parse(read("none.json")).empty());
}

TEST_P(TraceTest, PixelsOfAView) {
    const std::string field = height();
    const std::vector<std::string> view{
        "trace", "--height", field, "--scene", "floor", "--camera", "elevation=20,azimuth=10", "--size", "80x60"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = view;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    };
    const auto out =
        lines(runFine(with({"--pixel", "40,30", "--pixel", "0,0", "--pixel", "41,30", "--steps", path("s.csv")})));
    ASSERT_EQ(out.size(), 4U);
    EXPECT_EQ(fields(out[1])[0], "hit");
    EXPECT_EQ(out[2], "miss,,,,0") << "the sky";
    EXPECT_EQ(fields(out[3])[0], "hit");
    EXPECT_EQ(lines(runFine(with({"--pixel", "41,30"})))[1], out[3]);
    for (const std::string& step : lines(read("s.csv"))) EXPECT_NE(step.substr(0, 2), "1,") << "a pixel without ray";
}

TEST_P(TraceTest, TheCopiedCommandTracesTheChosenPixel) {
    const std::string field = height();
    Scenario scenario;
    scenario.pictures.height = field;
    scenario.reliefDepth = 0.15;
    scenario.surface = Surface::Columns;
    scenario.scene = SceneKind::Wall;
    scenario.camera.elevation = 7.25;
    scenario.camera.azimuth = -12.5;
    scenario.width = 90;
    scenario.height = 70;
    scenario.pixel = PixelChoice{44, 31};
    for (const bool free : {false, true}) {
        if (free) scenario.camera.kind = Camera::Kind::Free;
        const std::string answer = runFine({"trace", write("вид.json", scenarioText(scenario, path("")))});
        const std::string command = traceCommand(scenario);
        ASSERT_EQ(command.substr(0, 7), "relief ");
        // The command as pasted into a shell.
        const std::string program = RELIEF_PROGRAM;
        const std::string line = "'" + program + "' " + command.substr(7) + " > '" + path("out.csv") + "'";
        EXPECT_EQ(std::system(line.c_str()), 0) << line;
        EXPECT_EQ(read("out.csv"), answer) << line;
        EXPECT_EQ(fields(lines(answer)[1])[0], "hit");
    }
    scenario.pictures.height.clear();
    scenario.pictures.recipe = "hills";
    const std::string line = "'" RELIEF_PROGRAM "' " + traceCommand(scenario).substr(7) + " > /dev/null";
    EXPECT_EQ(std::system(line.c_str()), 0) << line;
    // Heights drawn by hand are contained in the command itself.
    scenario.pictures = {};
    scenario.pictures.drawn = {3, 2, {0, 1, 0.25, 1.0 / 3, 0.5, 0.75}};
    const std::string answer = runFine({"trace", write("drawn.json", scenarioText(scenario, path("")))});
    const std::string drawn =
        "'" RELIEF_PROGRAM "' " + traceCommand(scenario).substr(7) + " > '" + path("out.csv") + "'";
    EXPECT_EQ(std::system(drawn.c_str()), 0) << drawn;
    EXPECT_EQ(read("out.csv"), answer) << drawn;
    EXPECT_EQ(fields(lines(answer)[1])[0], "hit");
}

TEST_P(TraceTest, OutputsThatCannotBeWritten) {
    const std::string field = height();
    const std::string rays = write("rays.csv", "s0,t0,a,b\n1,2,10,-7\n");
    expectRefusal({"trace", "--height", field, "--rays", rays, "-o", path("no/hits.csv")}, 1, {path("no/hits.csv")});
    expectRefusal({"trace", "--height", field, "--rays", rays, "--steps", path("no/s.csv")}, 1, {path("no/s.csv")});
    expectRefusal({"trace", "--height", field, "--rays", rays, "-o", path("")}, 1, {});
    RunSetup full;
    full.output = "/dev/full";
    expectRefusal({"trace", "--height", field, "--rays", rays}, 1, {"standard output"}, full);
    expectRefusal({"trace", "--help"}, 1, {"standard output"}, full);
    expectRefusal({"list"}, 1, {"standard output"}, full);
}

TEST_P(TraceTest, InterruptedWorkLeavesNothingBehind) {
    const std::string field = height();
    write("hits.csv", "old\n");
    const auto before = files();
    RunSetup setup;
    setup.interruptAfterMilliseconds = 300;
    const Result result = run({"trace", "--height", field, "--rays", "-", "-o", path("hits.csv")}, setup);
    EXPECT_EQ(result.status, 130);
    EXPECT_EQ(result.err, "relief: stopped by SIGINT before it was done\n");
    EXPECT_EQ(files(), before);
    EXPECT_EQ(read("hits.csv"), "old\n");
}

TEST_P(TraceTest, CoefficientsInsteadOfHits) {
    const std::string height = makeRelief("bricks", "h.png", {"--size", "32"});
    const std::vector<std::string> view{"trace", "--height", height, "--scene", "wall", "--size", "60x40"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = view;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const auto out = lines(runFine(with({"--pixel", "30,20", "--pixel", "0,0", "--coefficients"})));
    ASSERT_EQ(out.size(), 3U);
    EXPECT_TRUE(out[0].starts_with("A,B,C,D,E,F,G,H,I,q,ux,uy,vx,vy,M,N,O,P,")) << out[0];
    const auto names = fields(out[0]);
    const auto row = fields(out[1]);
    ASSERT_EQ(row.size(), names.size());
    const auto number = [&](const std::string& name) {
        const auto at = std::find(names.begin(), names.end(), name) - names.begin();
        double value = 0;
        const std::string& text = row[static_cast<std::size_t>(at)];
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    };
    const double q = number("G") * 30.5 + number("H") * 20.5 + number("I");
    EXPECT_NEAR(number("q"), q, 1e-12);
    EXPECT_NEAR(number("M"), number("A") * number("H") - number("B") * number("G"), 1e-12);
    EXPECT_NEAR(number("ux"), (number("M") * 20.5 + number("A") * number("I") - number("C") * number("G")) / (q * q),
                1e-9);
    EXPECT_NEAR(number("ellipse_C"), number("ux") * number("ux") + number("uy") * number("uy"), 1e-9);
    EXPECT_EQ(fields(out[2])[0], "") << "no polygon there";
    expectRefusal(with({"--coefficients", "--ray", "1,1,1,1"}), 2, {"--coefficients", "--ray"});
    expectRefusal(with({"--coefficients"}), 2, {"--pixel"});
    expectRefusal(with({"--coefficients", "--children", "--pixel", "1,1"}), 2, {"--coefficients", "--children"});
    expectRefusal(with({"--coefficients", "--pixel", "60,1"}), 2, {"--pixel", "60,1"});
}

TEST_P(TraceTest, ChildrenEnteredAtEachLevel) {
    const std::string height = makeRelief("bricks", "h.png", {"--size", "32"});
    const std::vector<std::string> view{"trace",   "--height", height,   "--tracer", "max-pyramid-paper",
                                        "--scene", "wall",     "--size", "60x40",    "--children"};
    const std::string text = runFine(view);
    EXPECT_NE(text.find("one "), std::string::npos) << text;
    EXPECT_NE(text.find("#"), std::string::npos);
    std::vector<std::string> table = view;
    table.insert(table.end(), {"-o", path("c.csv")});
    EXPECT_EQ(runFine(table), "");
    const auto csv = lines(read("c.csv"));
    ASSERT_EQ(csv.size(), 1 + 5 + 1U) << "levels 5 to 1 and all";
    EXPECT_EQ(csv[0], "level,one,two,three,mean,ended");
    EXPECT_TRUE(csv.back().starts_with("all,"));
}

TEST_P(TraceTest, BaseAutoIsOneLevelOfTheView) {
    const std::string height = makeRelief("hills", "h.png", {"--size", "256"});
    const std::vector<std::string> view{"trace",    "--height",    height,
                                        "--tracer", "max-pyramid", "--size",
                                        "60x40",    "--camera",    "distance=6,elevation=60",
                                        "--pixel",  "30,20"};
    const auto with = [&](const std::string& base) {
        std::vector<std::string> all = view;
        all.insert(all.end(), {"--set", "base=" + base});
        return all;
    };
    const Result automatic = run(with("auto"));
    EXPECT_EQ(automatic.status, 0);
    const std::size_t at = automatic.err.find("level ");
    ASSERT_NE(at, std::string::npos) << automatic.err;
    EXPECT_EQ(automatic.out, runFine(with(automatic.err.substr(at + 6, 1))));
    expectRefusal({"trace", "--height", height, "--tracer", "max-pyramid", "--set", "base=auto", "--ray", "1,1,1,1"}, 2,
                  {"base=auto"});
    const Result picture = run({"render", "--height", height, "--tracer", "max-pyramid", "--set", "base=auto", "--size",
                                "40x30", "--report", path("r.json"), "-o", path("p.png")});
    EXPECT_EQ(picture.status, 0) << picture.err;
    const std::string report = read("r.json");
    for (const char* name : {"\"pixel_texels\"", "\"error_mean\"", "\"level_0\""}) {
        EXPECT_NE(report.find(name), std::string::npos) << name;
    }
}

TEST_P(TraceTest, ReadsTilesWithinTheGivenMemory) {
    const std::string whole = height(), tiled = path("tiled.tif");
    {
        Work work;
        const auto rows = pictureHeightRows(whole, {});
        TiledWriter(*rows, tiled, {}).write(work);
    }
    const std::string rays = write("rays.csv", "s0,t0,a,b\n3.25,4.5,9,20\n1,2,10.5,-7\n-1000.5,1e3,1e5,3e-1\n");
    for (const std::string tracer : {"exact", "layers"}) {
        const auto trace = [&](const std::string& file, const std::vector<std::string>& more) {
            std::vector<std::string> arguments{"trace", file, "--tracer", tracer, "--rays", rays};
            arguments.insert(arguments.end(), more.begin(), more.end());
            return arguments;
        };
        const std::string expected = runFine(trace(whole, {}));
        EXPECT_EQ(runFine(trace(tiled, {})), expected) << "read as a whole";
        EXPECT_EQ(runFine(trace(tiled, {"--memory", "1"})), expected) << "read by tiles";
        const Result told = run(trace(tiled, {"--memory", "1", "--verbose"}));
        EXPECT_EQ(told.out, expected);
        EXPECT_NE(told.err.find("MB"), std::string::npos) << told.err;
    }
    const std::vector<std::string> cone{"trace", tiled, "--rays", rays, "--tracer", "cone"};
    runFine(cone);
    std::vector<std::string> byTiles = cone;
    byTiles.insert(byTiles.end(), {"--memory", "1"});
    expectRefusal(byTiles, 2, {"tiled.tif", "--memory", "cone", "max-pyramid"});
    expectRefusal({"trace", tiled, "--rays", rays, "--memory", "1", "--invert"}, 2, {"--invert", "--memory"});
    expectRefusal({"trace", tiled, "--rays", rays, "--memory", "0"}, 2, {"--memory"});
}

// The numbers are multiplied out here once more, from the JSON alone.
TEST_P(TraceTest, WhyAPixelHasItsColour) {
    const std::vector<std::string> view{"--height",  height(),  "--color", height(), "--scene", "wall", "--shadows",
                                        "--address", "border",  "--size",  "40",     "--pixel", "0,0",  "--pixel",
                                        "20,20",     "--pixel", "33,12",   "--why",  "--json"};
    for (const char* const filter : {"elliptical-visible", "trilinear", "supersample:samples=2"}) {
        std::vector<std::string> command{"trace", "--filter", filter};
        command.insert(command.end(), view.begin(), view.end());
        const auto pixels = nlohmann::json::parse(runFine(command));
        ASSERT_EQ(pixels.size(), 3U);
        int hits = 0;
        for (const auto& pixel : pixels) {
            const double bound = pixel["bound"];
            for (std::size_t c = 0; c < 3; ++c) {
                double product = 0;
                for (const auto& ray : pixel["rays"]) {
                    double color = ray["product"][c];
                    if (ray.contains("filter") && ray["filter"].contains("texels")) {
                        color = 0;
                        for (const auto& texel : ray["filter"]["texels"]) {
                            color += texel["weight"][c].get<double>() * texel["color"][c].get<double>();
                        }
                        const auto& light = pixel["light"];
                        const double facing = ray["light"]["shadowed"].get<bool>()
                                                  ? 0
                                                  : std::max(0.0, ray["light"]["cosine"].get<double>());
                        const double ambient = light["ambient"];
                        color *= light["intensity"].get<double>() * (ambient + (1 - ambient) * facing);
                        ++hits;
                    }
                    product += ray["share"][c].get<double>() * color;
                }
                EXPECT_NEAR(product, pixel["drawn"][c].get<double>(), bound) << filter;
            }
        }
        EXPECT_GT(hits, 0) << filter << ": nothing is tested";
    }
    const std::string text =
        runFine({"trace", "--height", height(), "--scene", "wall", "--size", "40", "--pixel", "20,20", "--why"});
    EXPECT_NE(text.find("It is the drawn pixel"), std::string::npos) << text;
    // Options of colours are refused where nothing depends on them.
    EXPECT_EQ(run({"trace", "--height", height(), "--pixel", "1,1", "--shadows"}).status, 2);
    EXPECT_EQ(run({"trace", "--height", height(), "--pixel", "1,1", "--json"}).status, 2);
    EXPECT_EQ(run({"trace", "--height", height(), "--ray", "1,1,1,1", "--why"}).status, 2);
}

}  // namespace relief::test
