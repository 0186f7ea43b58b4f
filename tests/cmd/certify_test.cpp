// relief certify: maps are proved safe, refuted with a scenario that shows the error, and damaged ones detected.
#include <cmath>

#include "command_test.h"
#include "relief/files.h"
#include "relief/tracers/map_choice.h"
#include "scenario/scenario.h"

namespace relief::test {

class CertifyTest : public CommandTest {
  protected:
    std::string walls() const { return makeRelief("bricks", "bricks.png", {"--size", "48x40"}); }
    static void expectPart(const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, CertifyTest, testing::ValuesIn(places()), placeName);

TEST_P(CertifyTest, SafeMapsAreProven) {
    const std::string height = walls();
    for (const char* tracer : {"distance-conservative", "distance-refined", "cone"}) {
        const std::string said =
            runFine({"certify", "--height", height, "--tracer", tracer, "--rays", "20000", "--seed", "7"});
        expectPart(said, "violated bounds: none");
        expectPart(said, "rays: 20000 compared with exact, seed 7");
        expectPart(said, "safe: proven by the values");
    }
}

// Rays can refute safety but not prove it; a check that could not be carried out decides nothing either.
TEST_P(CertifyTest, WhatIsNeitherProvenNorRefutedIsUndecided) {
    const std::string height = walls();
    for (const char* tracer : {"exact", "flat"}) {
        const Result result = run({"certify", height, "--tracer", tracer, "--rays", "2000"});
        EXPECT_EQ(result.status, 3) << result.err;
        EXPECT_EQ(result.err, "");
        expectPart(result.out, "none checked");
        expectPart(result.out, "not decided: no ray contradicts safety, but rays are evidence, not a proof");
    }
    expectRefusal({"certify", height, "--tracer", "cone-dummer", "-o", path("no/w.json")}, 3, {path("no/w.json")});
    RunSetup full;
    full.output = "/dev/full";
    expectRefusal({"certify", height, "--tracer", "cone", "--rays", "100"}, 3, {"standard output"}, full);
}

// Status 1, and the error is reproduced by both the scenario's pixel and the printed ray.
TEST_P(CertifyTest, UnsafeOnesAreRefuted) {
    const std::string height = walls();
    for (const char* tracer : {"cone-dummer", "distance", "distance-refined-sampled"}) {
        const std::string file = path("witness.json");
        const Result result = run({"certify", "--height", height, "--tracer", tracer, "--rays", "50000", "-o", file});
        EXPECT_EQ(result.status, 1) << result.err;
        EXPECT_EQ(result.err, "");
        for (const char* part :
             {"NOT SAFE", "  first ray: ", "  surface: lambda ", "  again: relief trace ", "  scenario: "}) {
            expectPart(result.out, part);
        }
        const auto lambdaOf = [&](std::vector<std::string> more) {
            std::vector<std::string> all{"trace"};
            all.insert(all.end(), more.begin(), more.end());
            const auto row = fields(lines(runFine(all))[1]);
            return row[0] == "hit" ? std::stod(row[1]) : INFINITY;
        };
        EXPECT_EQ(loadScenario(file).method.name, tracer);
        EXPECT_EQ(result.out.find("no longer shows"), std::string::npos) << "the pixel shows it, see below";
        EXPECT_GT(lambdaOf({file}), lambdaOf({file, "--tracer", "exact"}));
        const std::size_t at = result.out.find("  ray: ") + 7;
        const std::string ray = result.out.substr(at, result.out.find('\n', at) - at);
        EXPECT_GT(lambdaOf({"--height", height, "--tracer", tracer, "--ray", ray}),
                  lambdaOf({"--height", height, "--tracer", "exact", "--ray", ray}));
    }
}

TEST_P(CertifyTest, DamagedMapsAreFound) {
    // Other than bricks, hills have not only surface voxels.
    const std::string height = makeRelief("hills", "hills.png", {"--size", "48"});
    Work work;
    const HeightField field(std::make_shared<FloatImage>(readHeight(height, {}, work).heights));
    const std::vector<std::string> kinds{"euclidean-conservative", "refined", "cone"};
    for (const std::string& kind : kinds) {
        const std::string map = path("map.tif");
        runFine({"map", kind, "--height", height, "--set", "precision=u8", "-o", map});
        expectPart(runFine({"certify", "--height", height, "--map", map, "--rays", "2000"}), "safe: proven");
        const StoredMap whole = loadMap(map, field, std::size_t{1} << 28, work);
        // Changes one value in the middle of free space. The certificate's bound for refined maps is tighter than the
        // builder's, so that one code more may still be safe there.
        const auto alter = [](const StoredValues& values, int by, double share) {
            auto codes = values.codes();
            auto& all = std::get<UnfilledVector<std::uint8_t>>(codes);
            std::size_t at = all.size() / 2;
            const auto fits = [&](int code) { return code > 3 && code * share + by < 256; };
            for (std::size_t n = 0; n < all.size() && !fits(all[at]); ++n) at = (at + 1) % all.size();
            all[at] = static_cast<std::uint8_t>(all[at] * share + by);
            return StoredValues(values.width(), values.height(), values.layers(), codes, values.unit());
        };
        if (const auto* distances = std::get_if<0>(&whole)) {
            auto damaged = std::make_shared<DistanceMap>(**distances);
            damaged->values = alter(damaged->values, 1, kind == "refined" ? 1.5 : 1.0);
            saveMap(map, std::shared_ptr<const DistanceMap>(damaged), field.heights());
        } else {
            auto damaged = std::make_shared<ConeMap>(*std::get<1>(whole));
            damaged->apex = alter(damaged->apex, -1, 1);
            saveMap(map, std::shared_ptr<const ConeMap>(damaged), field.heights());
        }
        const Result result = run({"certify", "--height", height, "--map", map, "--rays", "2000"});
        EXPECT_EQ(result.status, 1) << result.err;
        expectPart(result.out, "violated bounds: 1");
        expectPart(result.out, "NOT SAFE\n  first value: ");
    }
}

TEST_P(CertifyTest, WrongUse) {
    const std::string height = walls();
    const auto before = files();
    expectRefusal({"certify", "--height", height, "--tracer", "cones"}, 2, {"\"cones\"", "cone-dummer"});
    expectRefusal({"certify", "--height", height, "--rays", "-1"}, 2, {"--rays"});
    expectRefusal({"certify", "--height", height, "--seed", "x"}, 2, {"--seed"});
    expectRefusal({"certify", "--height", height, "-o", path("w.png")}, 2, {"w.png"});
    expectRefusal({"certify", "--height", path("none.png")}, 2, {"none.png"});
    expectRefusal({"certify", "--height", height, "--map", height}, 2, {"not a stored map"});
    expectRefusal({"certify", "--height", height, "--tracer", "distance-refined", "--address", "clamp"}, 2, {"clamp"});
    EXPECT_EQ(files(), before);
}

TEST_P(CertifyTest, InterruptedLeavesNothing) {
    RunSetup setup;
    setup.interruptAfterMilliseconds = 300;
    const Result result =
        run({"certify", "--relief", "hills", "--tracer", "layers", "--rays", "1000000000", "-o", path("witness.json")},
            setup);
    EXPECT_EQ(result.status, 130) << result.err;
    EXPECT_TRUE(files().empty());
}

}  // namespace relief::test
