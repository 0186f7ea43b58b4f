// relief map for engines, and relief certify of what an engine reads: every kind and format, conventions of other
// programs, rounding that is not safe.
#include <cmath>

#include "command_test.h"
#include "relief/files.h"
#include "relief/maps/engine_builders.h"
#include "relief/messages.h"

namespace relief::test {

class MapEngineTest : public CommandTest {
  protected:
    std::string small() const { return makeRelief("bricks", "bricks.png", {"--size", "32"}); }
    static void expectPart(const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
    }
    Result certified(const std::vector<std::string>& more, const char* rays = "500") const {
        std::vector<std::string> all{"certify", "--rays", rays};
        all.insert(all.end(), more.begin(), more.end());
        Result result = run(all);
        EXPECT_EQ(result.err, "");
        return result;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, MapEngineTest, testing::ValuesIn(places()), placeName);

TEST_P(MapEngineTest, ConesAreProvenInEveryFormat) {
    const std::string height = small();
    const std::vector<std::vector<std::string>> forms{
        {"a.png", "--bits", "8", "--unit", "sqrt-ratio"},
        {"b.png"},
        {"c.exr", "--unit", "sqrt-ratio", "--length", "width"},
        {"d.tif", "--bits", "8", "--unit", "slope"},
        {"e.tif", "--bits", "float", "--pack", "R=depth,A=cone"},
        {"f.png", "--convention", "dummer", "--bits", "8", "--address", "clamp", "--pack",
         "R=height,G=cone,B=normal-x,A=normal-y"},
        {"g.png", "--bits", "8", "--unit", "sqrt-ratio", "--pack", "R=apex,G=cone"},
    };
    for (const std::vector<std::string>& form : forms) {
        std::vector<std::string> all{"map", "cone", height, "-o", path(form[0])};
        all.insert(all.end(), form.begin() + 1, form.end());
        const std::string said = runFine(all);
        EXPECT_TRUE(said.starts_with("cone: 32 x 32, 1 level, ")) << said;
        expectPart(said, "conventions in " + path(form[0]) + ".json");
        if (form[0] == "d.tif") {
            const std::string json = read("d.tif.json"), key = "\"scale\":";
            ASSERT_NE(json.find(key), std::string::npos) << json;
            const double scale = std::stod(json.substr(json.find(key) + key.size()));
            expectPart(said, "export shader: --unit slope --length uv --cone-scale " + numberText(scale) + ";");
        }
        const bool cells = form[0] == "g.png";
        const Result proven = cells ? certified({height, "--map", path(form[0])}) : certified({"--map", path(form[0])});
        EXPECT_EQ(proven.status, 0) << proven.out;
        expectPart(proven.out, "safe: proven");
        if (cells) continue;
        const Result nearest = certified({height, "--map", path(form[0]), "--fetch", "nearest"});
        EXPECT_EQ(nearest.status, 0) << nearest.out;
        expectPart(nearest.out, "which differ from the height map by at most ");
    }
}

TEST_P(MapEngineTest, OtherKindsAreChecked) {
    const std::string height = makeRelief("hills", "hills.png", {"--size", "24x16"});
    const std::vector<std::pair<std::string, int>> kinds{
        {"max-pyramid", 0}, {"refined", 0},     {"euclidean-conservative", 0},
        {"euclidean", 3},   {"cone-dummer", 1}, {"relaxed-cone", 1}};
    for (const auto& [kind, status] : kinds) {
        const std::string map = path(kind + ".png");
        runFine({"map", kind, height, "--bits", "8", "--unit", "sqrt-ratio", "-o", map});
        const std::string first = kind == "max-pyramid" ? path(kind + ".0.png") : map;
        EXPECT_NE(runFine({"info", first}).find(" x "), std::string::npos);
        const Result result = certified({height, "--map", map}, "5000");
        if (kind == "euclidean") {
            EXPECT_NE(result.status, 0) << "interpolated distances are not proven";
        } else if (kind == "relaxed-cone") {
            EXPECT_TRUE(result.status == 1 || result.status == 3) << result.out;
        } else {
            EXPECT_EQ(result.status, status) << kind << "\n" << result.out;
        }
    }
    const std::string robust = path("robust.png");
    runFine({"map", "relaxed-cone-robust:radius=16", height, "-o", robust});
    const Result undecided = certified({"--map", robust});
    EXPECT_EQ(undecided.status, 3) << undecided.out;
    expectPart(undecided.out, "relaxed-cone-robust, R=height,G=cone, 16 bits");
    expectPart(undecided.out, "relaxed, fetched bilinear");
    expectRefusal({"map", "relaxed-cone-robust:directions=8", height, "-o", path("x.png")}, 2, {"directions"});
    expectRefusal({"map", "normals", height, "-o", path("x.tif"), "--at", "1,1,1"}, 2, {"--at"});
    const std::string corrected = path("corrected.png");
    runFine({"map", "cone-robust", height, "--bits", "8", "--unit", "slope", "-o", corrected});
    EXPECT_EQ(certified({"--map", corrected}).status, 0);
    expectRefusal({"map", "cone-robust", height, "--surface", "columns", "-o", path("x.tif")}, 2, {"bilinear"});
    expectRefusal({"map", "cone-robust", height, "--surface", "columns", "-o", path("x.png")}, 2, {"--surface"});
    EXPECT_EQ(certified({"--map", path("max-pyramid.png")}).status, 0) << "against its own heights";
    // Level 0, rounded to the nearest, lies below the height map in places; the levels above it bound level 0 only.
    runFine({"map", "max-pyramid", height, "--bits", "8", "--rounding", "nearest", "-o", path("nearest.png")});
    EXPECT_EQ(certified({"--map", path("nearest.png")}).status, 0) << "against its own heights";
    EXPECT_EQ(certified({height, "--map", path("nearest.png")}).status, 1) << "against the height map that is given";
    runFine({"map", "normals", height, "--green", "down", "-o", path("normals.png")});
    expectRefusal({"certify", height, "--map", path("normals.png")}, 2, {"normals.png", "normals"});
}

TEST_P(MapEngineTest, MipLevelsAreFilesOfTheirOwn) {
    const std::string map = path("cone.png");
    const std::string said =
        runFine({"map", "cone", small(), "--bits", "8", "--unit", "sqrt-ratio", "--mips", "all", "-o", map});
    expectPart(said, "6 levels");
    for (int l = 0; l < 6; ++l) EXPECT_EQ(readImageInfo(path("cone." + std::to_string(l) + ".png")).width, 32 >> l);
    const Result all = certified({"--map", map});
    EXPECT_EQ(all.status, 0) << all.out;
    expectPart(all.out, "level 5, 1x1");
    const Result one = certified({"--map", path("cone.2.png")});
    EXPECT_EQ(one.status, 0) << one.out;
    EXPECT_EQ(one.out.find("level 5"), std::string::npos);
}

// A map of another program: no sidecar, 8 bits rounded to the nearest, cones as published.
TEST_P(MapEngineTest, MapsOfOthersAreReadByTheirConventions) {
    const std::string height = small();
    Work work(2);
    const HeightField field(std::make_shared<FloatImage>(readHeight(height, {}, work).heights));
    for (const NamedConvention& named : namedConventions()) {
        EngineConventions c = named.conventions;
        c.bits = 8;
        c.rounding = EngineRounding::Nearest;
        const EngineMap map = buildEngineCones(c.relaxed ? ConeKind::Relaxed : ConeKind::Dummer, {}, field, c, 1, work);
        const std::string theirs = path("theirs.exr");
        std::vector<NamedPlane> planes;
        for (std::size_t n = 0; n < map.levels[0].channels.size(); ++n) {
            planes.push_back({std::string(1, kEngineLetters[n]), map.levels[0].channels[n]});
        }
        writePlanes(theirs, planes);
        expectRefusal({"certify", height, "--map", theirs}, 2, {theirs});
        const Result refuted = certified({height, "--map", theirs, "--convention", named.name}, "4000");
        EXPECT_EQ(refuted.status, 1) << named.name << "\n" << refuted.out;
        expectPart(refuted.out, "NOT SAFE\n  first ray: step ");
        // The same by single flags.
        const Result flags = certified({"--map", theirs, "--pack", enginePackText(named.conventions.channels), "--unit",
                                        std::string(coneUnitName(named.conventions.cone.unit)),
                                        named.conventions.relaxed ? "--relaxed" : "--quiet"},
                                       "4000");
        EXPECT_EQ(flags.out.substr(flags.out.find("rays: ")), refuted.out.substr(refuted.out.find("rays: ")));
    }
}

TEST_P(MapEngineTest, RoundingToTheNearestIsRefuted) {
    FloatImage spike(4096, 3);
    spike(2048, 1) = 1;
    writeHeight(path("spike.png"), spike);
    const std::vector<std::string> common{"map",    "cone",  path("spike.png"), "--bits", "8",
                                          "--unit", "ratio", "--address",       "clamp",  "-o"};
    const auto mapped = [&](const char* rounding, const std::string& file) {
        std::vector<std::string> all = common;
        for (const std::string& more : {file, std::string("--rounding"), std::string(rounding)}) all.push_back(more);
        return run(all);
    };
    const Result said = mapped("outward", path("safe.png"));
    expectPart(said.err, "cones are stored as 0");
    mapped("nearest", path("unsafe.png"));
    EXPECT_EQ(certified({"--map", path("safe.png")}).status, 0);
    const Result refuted = certified({"--map", path("unsafe.png")});
    EXPECT_EQ(refuted.status, 1) << refuted.out;
    expectPart(refuted.out, "NOT SAFE");
}

TEST_P(MapEngineTest, WrongUse) {
    const std::string height = small();
    const auto before = files();
    const auto refused = [&](std::vector<std::string> more, const std::vector<std::string>& parts) {
        std::vector<std::string> all{"map"};
        all.insert(all.end(), more.begin(), more.end());
        expectRefusal(all, 2, parts);
    };
    refused({"cone", height, "-o", path("x.png"), "--pack", "R=heigth"}, {"--pack", "heigth", "height"});
    refused({"cone", height, "-o", path("x.png"), "--pack", "R=height"}, {"--pack", "cone"});
    refused({"cone", height, "-o", path("x.png"), "--pack", "R=cone,G=distance"}, {"--pack", "distance"});
    refused({"cone", height, "-o", path("x.png"), "--pack", "R=apex,G=cone,B=height"}, {"--pack", "apex"});
    refused({"cone-dummer", height, "-o", path("x.png"), "--pack", "R=apex,G=cone"}, {"apex"});
    refused({"cone", height, "-o", path("x.png"), "--bits", "float"}, {"--bits", ".png"});
    refused({"cone", height, "-o", path("x.exr"), "--bits", "8"}, {"--bits", ".exr"});
    refused({"cone", height, "-o", path("x.png"), "--unit", "ration"}, {"--unit", "ration", "ratio"});
    refused({"cone", height, "-o", path("x.png"), "--unit", "slope", "--cone-scale", "8"},
            {"--cone-scale", "--unit slope --bits 16"});
    refused({"cone", height, "-o", path("x.png"), "--surface", "columns"}, {"--surface", "apex"});
    refused({"cone", height, "-o", path("x.png"), "--set", "sectors=4"}, {"--set sectors"});
    refused({"cone", height, "-o", path("x.png"), "--mips", "7"}, {"--mips", "32x32", "6"});
    refused({"refined", height, "-o", path("x.png"), "--mips", "2"}, {"--mips", "refined"});
    refused({"normals", height, "-o", path("x.png"), "--set", "layers=2"}, {"--set"});
    refused({"normals", height, "--at", "1,1,1"}, {"--at"});
    refused({"cone", height, "-o", path("x.bmp"), "--bits", "8"}, {"x.bmp"});
    expectRefusal({"certify", height, "--fetch", "nearest"}, 2, {"--fetch", "--map"});
    expectRefusal({"certify", height, "--map", height, "--convention", "dumer"}, 2,
                  {"--convention", "dumer", "dummer"});
    expectRefusal({"certify", height, "--map", height, "--convention", "dummer"}, 2, {"bricks.png", "channel G"});
    EXPECT_EQ(files(), before);
    runFine({"map", "cone", height, "-o", path("x.png")});
    expectRefusal({"certify", height, "--map", path("x.png"), "--tracer", "cone"}, 2, {"--tracer"});
    expectRefusal({"certify", height, "--map", path("x.png"), "-o", path("w.json")}, 2, {"--output"});
    const std::string other = makeRelief("bricks", "other.png", {"--size", "16"});
    expectRefusal({"certify", other, "--map", path("x.png")}, 2, {"x.png", "32x32", "16x16"});
    write("x.png.json", "{\"format\": \"reliefscope engine map\", \"version\": 9}");
    expectRefusal({"certify", "--map", path("x.png")}, 2, {"x.png", "9"});
}

}  // namespace relief::test
