// relief bench and relief stress: tables for scripts, exit status, files left behind.
#include <algorithm>
#include <cstdlib>
#include <set>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class MeasureTest : public CommandTest {
  protected:
    std::vector<std::string> bench(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"bench", "tracers", "--rays", "500", "--rounds", "2", "--elevations", "60,random"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, MeasureTest, testing::ValuesIn(places()), placeName);

TEST_P(MeasureTest, TablesInFilesAndOnStandardOutput) {
    const std::string field = makeRelief("bricks", "height.png", {"--size", "32x24"});
    const std::vector<std::string> what{"--height",      field,       "--relief",
                                        "hills:16x16:3", "--tracers", "exact,max-pyramid,layers:layers=12"};
    const auto with = [&](const std::string& output) {
        std::vector<std::string> all = bench(what);
        all.insert(all.end(), {"-o", output});
        return all;
    };
    const auto out = lines(runFine(bench(what)));
    ASSERT_EQ(out.size(), 1 + 2 * 2 * 3U);
    EXPECT_EQ(runFine(with(path("b.csv"))), "");
    const auto csv = lines(read("b.csv"));
    ASSERT_EQ(csv.size(), out.size());
    EXPECT_EQ(csv[0], out[0]);
    EXPECT_EQ(fields(csv[1])[0], field);
    EXPECT_EQ(fields(csv[7])[0], "hills:16x16:3");
    EXPECT_EQ(fields(csv[3])[7], "layers=12");
    for (std::size_t r = 1; r < csv.size(); ++r) {
        const auto row = fields(csv[r]);
        // Rates and build times differ from run to run; rays, errors and steps do not.
        const auto other = fields(out[r]);
        for (const std::size_t column : {5U, 6U, 8U, 13U, 16U, 17U, 19U})
            EXPECT_EQ(row[column], other[column]) << csv[r];
        if (row[5] == "max-pyramid") {
            EXPECT_EQ(row[16], "0") << csv[r];
        }
    }
    EXPECT_EQ(runFine(with(path("b.json"))), "");
    const auto json = nlohmann::json::parse(read("b.json"));
    ASSERT_EQ(json.size(), csv.size() - 1);
    EXPECT_EQ(json[2]["method"], "layers");
    EXPECT_EQ(files(), (std::vector<std::string>{"b.csv", "b.json", "height.png"})) << "no .part file remains";
}

TEST_P(MeasureTest, ReadsTilesWithinTheGivenMemory) {
    const std::string map = path("map.tif");
    runFine({"make", "hills", "--size", "90x70", "--tiled", "-o", map});
    const auto table = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = bench({map});
        all.insert(all.end(), more.begin(), more.end());
        return lines(runFine(all));
    };
    const auto whole = table({"--tracers", "exact,layers"});
    const auto byTiles = table({"--tracers", "exact,layers", "--memory", "1"});
    ASSERT_EQ(byTiles.size(), whole.size());
    for (std::size_t r = 1; r < whole.size(); ++r) {
        const auto one = fields(whole[r]), other = fields(byTiles[r]);
        for (const std::size_t column : {0U, 1U, 5U, 8U, 13U, 14U, 16U, 17U, 18U, 19U})
            EXPECT_EQ(one[column], other[column]) << whole[r];
    }
    const auto all = table({"--memory", "1"});
    EXPECT_TRUE(std::ranges::any_of(all, [](const std::string& row) { return fields(row)[5] == "max-pyramid"; }));
    EXPECT_TRUE(std::ranges::none_of(all, [](const std::string& row) { return fields(row)[5] == "cone"; }));
    expectRefusal(bench({map, "--memory", "1", "--tracers", "cone"}), 2, {"map.tif", "cone", "max-pyramid"});
    expectRefusal({"bench", "filters", map, "--memory", "1"}, 2, {"--memory", "relief bench tracers"});
}

TEST_P(MeasureTest, ScalarFormsAreMeasuredAlone) {
    const std::vector<std::string> what{"--relief", "hills:16x16", "--tracers", "exact,max-pyramid,cone,layers"};
    const auto scalarOnes = [&](const char* form) {
        auto all = what;
        all.insert(all.end(), {"--form", form});
        const auto out = lines(runFine(bench(all)));
        std::size_t scalar = 0;
        for (std::size_t r = 1; r < out.size(); ++r) scalar += fields(out[r])[6] == "scalar" ? 1 : 0;
        return scalar;
    };
    EXPECT_EQ(scalarOnes("scalar"), 8U);
    EXPECT_EQ(scalarOnes("simd"), 2U) << "exact has no other form";
    EXPECT_EQ(scalarOnes("lanes"), 2U) << "as earlier versions named it";
    auto wrong = what;
    wrong.insert(wrong.end(), {"--form", "wide"});
    expectRefusal(bench(wrong), 2, {"--form", "wide", "simd, scalar"});
}

TEST_P(MeasureTest, BrokenOffRunsKeepTheirRows) {
    const RunSetup setup = interruptedWhen([&] {  // after a result has been saved
        const std::string journal = read("b.csv.part");
        return std::count(journal.begin(), journal.end(), '\n') >= 2;
    });
    const Result result = run({"bench", "tracers", "--relief", "hills:16x16", "--tracers", "offset,exact", "--rays",
                               "2000", "--rounds", "1000", "--elevations",
                               "80,60,50,40,30,25,20,19,18,17,16,15,14,13,12,11,10,9,8,7,6,5,4,3,2,1,0.9,0.8,0.7,0.6,"
                               "0.5,0.4,0.3,0.2,0.1",
                               "-o", path("b.csv")},
                              setup);
    EXPECT_EQ(result.status, 130) << result.err;
    EXPECT_EQ(files(), (std::vector<std::string>{"b.csv.part"}));
    const auto kept = lines(read("b.csv.part"));
    ASSERT_GE(kept.size(), 2U);
    EXPECT_EQ(nlohmann::json::parse(kept[0])["work"]["options"]["kind"], "tracers");
    for (const std::string& line : kept) {
        const auto json = nlohmann::json::parse(line);
        if (!json.contains("part")) continue;
        ASSERT_EQ(json["result"].size(), 2U);
        EXPECT_EQ(json["result"][1]["method"], "exact");
        EXPECT_EQ(json["result"][1].size(), 30U);
    }
}

TEST_P(MeasureTest, RowsInFilesAndOnStandardOutput) {
    const std::vector<std::string> what{"bench",        "rows",  "--widths",   "640,100",
                                        "--elevations", "25",    "--variants", "direct,subspan:error=0.5,fill",
                                        "--precisions", "float", "--pixels",   "2000",
                                        "--rounds",     "2"};
    const auto with = [&](const std::string& output) {
        std::vector<std::string> all = what;
        all.insert(all.end(), {"-o", output});
        return all;
    };
    const auto out = lines(runFine(what));
    ASSERT_EQ(out.size(), 1 + 2 * 3U);
    EXPECT_EQ(out[0],
              "variant,width,elevation,precision,streams,span,anchor,threads,mul,add,div,rate,spread,error_max,rows,"
              "compiler,cpu,commit,host,concurrent");
    EXPECT_EQ(runFine(with(path("r.csv"))), "");
    const auto csv = lines(read("r.csv"));
    ASSERT_EQ(csv.size(), out.size());
    for (std::size_t r = 0; r < csv.size(); ++r) {
        const auto row = fields(csv[r]);
        const auto other = fields(out[r]);
        for (const std::size_t column : {0U, 1U, 2U, 3U, 5U, 8U, 9U, 10U, 13U}) EXPECT_EQ(row[column], other[column]);
    }
    EXPECT_EQ(fields(csv[1])[8], "8");
    EXPECT_EQ(fields(csv[3])[13], "") << "a fill has no error";
    EXPECT_EQ(runFine(with(path("r.json"))), "");
    EXPECT_EQ(nlohmann::json::parse(read("r.json")).size(), 6U);
    EXPECT_EQ(files(), (std::vector<std::string>{"r.csv", "r.json"})) << "no .part file remains";
    // Rows timed together, in blocks of this size.
    std::vector<std::string> blocks = what;
    blocks.insert(blocks.end(), {"--rows", "1,3"});
    const auto together = lines(runFine(blocks));
    ASSERT_EQ(together.size(), 1 + 2 * 2 * 3U);
    std::set<std::string> sizes;
    for (std::size_t r = 1; r < together.size(); ++r) sizes.insert(fields(together[r])[14]);
    EXPECT_EQ(sizes, (std::set<std::string>{"1", "3"}));
    blocks.back() = "0";
    expectRefusal(blocks, 2, {"--rows"});
}

TEST_P(MeasureTest, WrongRequestsAreRefused) {
    expectRefusal({"bench", "rows", "--variants", "direct,none"}, 2, {"\"none\"", "row-constant"});
    expectRefusal({"bench", "rows", "--variants", "subspan:span=0"}, 2, {"--variants: span", "65536"});
    expectRefusal({"bench", "rows", "--variants", "direct:span=2"}, 2, {"\"span\"", "direct"});
    expectRefusal({"bench", "rows", "--widths", "0"}, 2, {"--widths"});
    expectRefusal({"bench", "rows", "--precisions", "half"}, 2, {"\"half\"", "double"});
    expectRefusal({"bench", "rows", "--elevations", "random"}, 2, {"--elevations", "random"});
    expectRefusal({"bench", "rows", "-o", path("b.txt")}, 2, {".csv"});
    expectRefusal({"bench"}, 2, {"KIND"});
    expectRefusal({"bench", "cars"}, 2, {"\"cars\"", "tracers"});
    expectRefusal(bench({"--tracers", "exact,none"}), 2, {"\"none\"", "max-pyramid"});
    expectRefusal(bench({"--tracers", "layers:layers=0"}), 2, {"layers", "65536"});
    expectRefusal({"bench", "tracers", "--elevations", "60,0"}, 2, {"--elevations", "\"0\""});
    expectRefusal(bench({"-o", path("b.txt")}), 2, {".csv"});
    expectRefusal(bench({"--resume"}), 2, {"--resume", "--output"});
    expectRefusal(bench({"--relief", "paper8x8", "--sizes", "64"}), 2, {"8 x 8", "64"});
    expectRefusal(bench({"--sizes", "0"}), 2, {"--sizes"});
    expectRefusal(bench({"--seed", "1,x"}), 2, {"--seed"});
    expectRefusal(bench({"--thread-counts", "0"}), 2, {"--thread-counts"});
    expectRefusal(bench({"-o", path("no/b.csv")}), 1, {path("no/b.csv")});
    expectRefusal(bench({"--height", path("none.png")}), 2, {path("none.png")});
    expectRefusal(bench({"--relief", "none"}), 2, {"--relief"});
    expectRefusal({"stress", "--seconds", "-1"}, 2, {"--seconds"});
    expectRefusal({"stress", "--seed", "x"}, 2, {"--seed"});
    expectRefusal({"stress", "--tracers", "none"}, 2, {"\"none\""});
    expectRefusal({"stress", "--parts", "none"}, 2, {"--parts", "any-hit"});
    expectRefusal({"stress", "--case", "-1"}, 2, {"--case"});
    expectRefusal({"stress", "-o", path("no")}, 1, {path("no")});
}

TEST_P(MeasureTest, StressSaysWhatItCovered) {
    const std::string out = runFine({"stress", "--seconds", "0", "--seed", "5", "--tracers", "exact,layers:layers=3"});
    EXPECT_EQ(out.substr(0, 8), "seed 5: ");
    EXPECT_NE(out.find("violations: 0\n"), std::string::npos) << out;
    for (const std::string part :
         {"at-limit", "through-corners", "steps/bound", "maps (number of cases)", "\n  layers "}) {
        EXPECT_NE(out.find(part), std::string::npos) << part;
    }
    EXPECT_TRUE(files().empty());
}

TEST_P(MeasureTest, StressRunsOneCaseAndOnePart) {
    const std::string out = runFine({"stress", "--seconds", "0", "--parts", "rows,homographies", "--case", "9"});
    EXPECT_EQ(out.substr(0, 15), "seed 1: 1 cases");
    for (const std::string part : {"homographies (", "rows (", "in-plane", "streams"}) {
        EXPECT_NE(out.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(out.find("frames ("), std::string::npos) << out;
}

TEST_P(MeasureTest, FiltersAgainstTheReference) {
    const std::vector<std::string> what{"bench",        "filters",   "--scenes",
                                        "checker",      "--filters", "bilinear,elliptical,elliptical:source=map",
                                        "--elevations", "40",        "--size",
                                        "48x32",        "--samples", "4",
                                        "--rounds",     "1",         "--pixel-models",
                                        "gaussian,lcd", "-o",        path("f.csv")};
    const Result result = run(what);
    ASSERT_EQ(result.status, 0) << result.err;
    const auto rows = lines(read("f.csv"));
    ASSERT_EQ(rows.size(), 7U);
    EXPECT_EQ(rows[0],
              "filter,weights,levels,pixel_model,implementation,map_size,scene,elevation,threads,rate,spread,rmse,"
              "psnr,flip,texels_read,tested,hidden,skipped,compiler,cpu,commit,host,concurrent");
    const double bilinear = std::stod(fields(rows[1])[11]);
    const double elliptical = std::stod(fields(rows[3])[11]);
    EXPECT_LT(elliptical, 0.5 * bilinear);
    EXPECT_EQ(fields(rows[5])[4], "map");
    EXPECT_EQ(fields(rows[5])[5], "64");
    // The user's own pictures, with a given depth.
    runFine({"make", "bricks", "--size", "24", "-o", path("h.png")});
    runFine({"make", "checker", "--size", "24", "-o", path("c.png")});
    std::vector<std::string> errors;
    for (const char* depth : {"0.05", "0.4"}) {
        const auto own = lines(
            run({"bench", "filters", "--height", path("h.png"), "--color", path("c.png"), "--relief-depth", depth,
                 "--filters", "bilinear", "--elevations", "40", "--size", "24x16", "--samples", "3", "--rounds", "1"})
                .out);
        ASSERT_EQ(own.size(), 3U);
        EXPECT_NE(own[1].find("h.png"), std::string::npos) << own[1];
        errors.push_back(fields(own[1])[11]);
    }
    EXPECT_NE(errors[0], errors[1]);
    expectRefusal({"bench", "filters", "--filters", "supersample"}, 2, {"supersample"});
    expectRefusal({"bench", "filters", "--scenes", "moon"}, 2, {"\"moon\"", "checker"});
    expectRefusal({"bench", "filters", "--filters", "elliptical:sigma=9"}, 2, {"sigma", "9"});
    expectRefusal({"render", "--relief", "bricks", "--filter", "elliptical", "--filter-set", "radius", "-o", "x.png"},
                  2, {"--filter-set", "radius"});
    expectRefusal({"render", "--relief", "bricks", "--filter", "elliptical", "--filter-set", "sigma=99", "-o", "x.png"},
                  2, {"--filter-set: sigma is 99"});
    expectRefusal({"render", "--relief", "bricks", "--filter", "elliptical", "--filter-set", "sigma=x", "-o", "x.png"},
                  2, {"--filter-set: \"sigma=x\" is not a number"});
    expectRefusal({"render", "--relief", "bricks", "--mapping", "streams:streams=x", "-o", "x.png"}, 2,
                  {"--mapping: \"streams=x\" is not a number"});
}

}  // namespace relief::test
