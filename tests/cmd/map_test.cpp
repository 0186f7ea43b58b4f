// relief map, and --map on the commands that trace.
#include "command_test.h"

namespace relief::test {

class MapTest : public CommandTest {
  protected:
    // A relief small enough for every kind of map.
    std::string small() const { return makeRelief("bricks", "bricks.png", {"--size", "32"}); }
};
INSTANTIATE_TEST_SUITE_P(Places, MapTest, testing::ValuesIn(places()), placeName);

TEST_P(MapTest, StoredMapsGiveTheSameHits) {
    const std::string height = small();
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"euclidean", "distance"},
        {"euclidean-conservative", "distance-conservative"},
        {"cone", "cone"},
        {"refined-sampled", "distance-refined-sampled"},
        {"refined", "distance-refined"},
        {"cone-dummer", "cone-dummer"},
        {"cone-robust", "cone-robust"},
        {"relaxed-cone", "relaxed-cone"},
        {"relaxed-cone-robust", "relaxed-cone-robust"},
    };
    for (const auto& [kind, tracer] : kinds) {
        const std::string map = path(kind + ".tif");
        const std::string said = runFine({"map", kind, "--height", height, "--set", "precision=u8", "-o", map});
        EXPECT_TRUE(said.starts_with(kind + ": ")) << said;
        EXPECT_NE(said.find(" bytes, built in "), std::string::npos) << said;
        const std::vector<std::string> rays{"--ray", "3.25,4.5,7,-3", "--ray", "20,9,-2,11", "--ray", "1,1,0,0"};
        std::vector<std::string> stored{"trace", "--height", height, "--tracer", tracer, "--map", map};
        std::vector<std::string> built{"trace", "--height", height, "--tracer", tracer, "--set", "precision=u8"};
        stored.insert(stored.end(), rays.begin(), rays.end());
        built.insert(built.end(), rays.begin(), rays.end());
        EXPECT_EQ(runFine(stored), runFine(built)) << kind;
    }
}

TEST_P(MapTest, RenderUsesTheStoredMap) {
    const std::string height = small();
    runFine({"map", "refined", "--height", height, "-o", path("map.tif")});
    const std::vector<std::string> common{"--height", height, "--tracer", "distance-refined", "--size", "40x30"};
    std::vector<std::string> stored{"render", "--map", path("map.tif"), "--report", "-", "-o", path("a.png")};
    std::vector<std::string> built{"render", "--report", "-", "-o", path("b.png")};
    stored.insert(stored.end(), common.begin(), common.end());
    built.insert(built.end(), common.begin(), common.end());
    EXPECT_NE(runFine(stored).find("\"builds\": 0"), std::string::npos);
    EXPECT_NE(runFine(built).find("\"builds\": 1"), std::string::npos);
    EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_P(MapTest, TheRefinedMapIsTakenByTheUnchangedTracer) {
    const std::string height = small();
    runFine({"map", "refined-sampled", "--height", height, "--set", "layers=8", "-o", path("map.tif")});
    const std::vector<std::string> rest{"--height", height, "--map", path("map.tif"), "--ray", "3.25,4.5,7,-3"};
    std::vector<std::string> own{"trace", "--tracer", "distance-refined-sampled"};
    std::vector<std::string> unchanged{"trace", "--tracer", "distance"};
    own.insert(own.end(), rest.begin(), rest.end());
    unchanged.insert(unchanged.end(), rest.begin(), rest.end());
    EXPECT_EQ(runFine(unchanged), runFine(own));
}

TEST_P(MapTest, DistancesOfAPoint) {
    const std::vector<std::string> walls{"map",    "refined",   "--relief", "paper-walls", "--relief-depth",
                                         "1.1111", "--surface", "columns",  "--address",   "border",
                                         "--at"};
    const auto at = [&](const std::string& point) {
        std::vector<std::string> all = walls;
        all.push_back(point);
        return all;
    };
    const std::string said = runFine(at("4,4.5,0.6"));
    EXPECT_NE(said.find("3.000"), std::string::npos) << said;
    EXPECT_NE(said.find("4.000"), std::string::npos) << said;
    EXPECT_NE(said.find("4.000,4.500,0.000,0.000"), std::string::npos) << said;
    EXPECT_NE(said.find("(4.000, 4.500, 0.200)"), std::string::npos) << "the ray's hit, and its height: " << said;
    const std::string inside = runFine(at("0.5,4.5,0.2"));
    EXPECT_NE(inside.find("not above the surface"), std::string::npos) << inside;
    EXPECT_EQ(lines(inside).size(), 1U) << "inside the wall nothing is measured";
    expectRefusal({"map", "max-pyramid", "--relief", "bricks", "--at", "1,1,1"}, 2, {"--at", "max-pyramid"});
    expectRefusal(at("4,4.5"), 2, {"--at"});
    expectRefusal(at("4,4.5,1.5"), 2, {"--at", "1.5"});
}

TEST_P(MapTest, WhatDoesNotBelongIsRefused) {
    const std::string height = small();
    const std::string map = path("map.tif");
    runFine({"map", "refined", "--height", height, "-o", map});
    const auto refused = [&](std::vector<std::string> more, const std::string& part) {
        std::vector<std::string> all{"trace", "--map", map, "--ray", "1,1,1,1"};
        all.insert(all.end(), more.begin(), more.end());
        expectRefusal(all, 2, {map + ": ", part});
    };
    refused({"--height", height, "--tracer", "cone"}, "needs the map cone");
    refused({"--height", height, "--tracer", "distance-refined", "--set", "layers=8"}, "layers 16, not 8");
    refused({"--height", height, "--tracer", "distance-refined", "--surface", "columns"}, "surface");
    refused({"--height", height, "--tracer", "distance-refined", "--relief-depth", "0.2"}, "relief-depth");
    refused({"--height", makeRelief("pits", "pits.png", {"--size", "32"}), "--tracer", "distance-refined"},
            "another height map");
    const std::string bytes = read(map);
    write("map.tif", bytes.substr(0, bytes.size() / 2));
    refused({"--height", height, "--tracer", "distance-refined"}, "");
    expectRefusal({"trace", "--map", height, "--height", height, "--tracer", "distance-refined", "--ray", "1,1,1,1"}, 2,
                  {height + ": ", "not a stored map"});
}

TEST_P(MapTest, WrongUse) {
    const std::string height = small();
    const auto before = files();
    expectRefusal({"map", "refind", "--height", height, "-o", path("m.tif")}, 2, {"\"refind\"", "refined"});
    expectRefusal({"map", "refined", "--height", height}, 2, {"--output"});
    expectRefusal({"map", "refined", "--height", height, "-o", path("m.bmp")}, 2, {"m.bmp"});
    expectRefusal({"map", "cone", "--height", height, "--set", "layers=3", "-o", path("m.tif")}, 2, {"layers"});
    expectRefusal({"map", "refined", "--height", height, "--address", "clamp", "-o", path("m.tif")}, 2, {"clamp"});
    expectRefusal({"map", "euclidean", "--relief", "hills:8192x8192", "--set", "layers=1024", "-o", path("m.tif")}, 2,
                  {"MiB"});
    EXPECT_EQ(files(), before);
}

// The program's own reader of pictures reads the file: level 0 is the height map.
TEST_P(MapTest, PyramidsAreWrittenAsPictures) {
    const std::string height = makeRelief("paper8x8", "paper.png", {});
    for (const std::string kind : {"max-pyramid", "mean-pyramid"}) {
        const std::string map = path(kind + ".tif");
        const std::string said = runFine({"map", kind, "--height", height, "-o", map});
        EXPECT_TRUE(said.starts_with(kind + ": 8 x 8, 4 levels, 85 numbers, built in ")) << said;
        EXPECT_NE(runFine({"info", map}).find("8 x 8"), std::string::npos);
        expectRefusal({"trace", "--height", height, "--tracer", "cone", "--map", map, "--ray", "1,1,1,1"}, 2,
                      {map + ": ", "not a stored map"});
    }
    expectRefusal({"map", "max-pyramid", "--height", height, "--set", "base=1", "-o", path("b.tif")}, 2,
                  {"--set", "\"base\""});
    expectRefusal({"map", "max-pyramid", "--height", height, "-o", path("b.bmp")}, 2, {"b.bmp"});
}

}  // namespace relief::test
