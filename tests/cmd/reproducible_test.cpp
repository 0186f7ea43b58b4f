// The same bytes on every instruction set, with one thread and several, in each run: the hashes of forty outputs are
// kept in tests/files/output_hashes.txt. After an intended change, RELIEF_GOLDEN=write stores them again.
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>

#include "command_test.h"
#include "mapping/rows/row_lanes.h"
#include "part.h"

namespace relief::test {
namespace {

struct Output {
    std::string file;
    std::vector<std::string> arguments;  // without -o FILE
};

std::vector<Output> outputs(const std::string& height) {
    std::vector<Output> all;
    for (const char* relief : {"bricks", "spikes", "pits", "columns", "city", "fractal", "hills", "checker"}) {
        all.push_back({std::string(relief) + ".png", {"make", relief, "--size", "40x32"}});
    }
    const auto over = [&](const std::string& file, std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--height", height});
        all.push_back({file, std::move(arguments)});
    };
    const std::string size = "64x48";
    for (const char* tracer :
         {"exact", "max-pyramid", "offset", "layers", "layers-secant", "layers-bisection", "cone", "cone-dummer",
          "relaxed-cone", "distance", "distance-conservative", "distance-refined", "hybrid", "bump", "displacement"}) {
        over(std::string(tracer) + ".exr",
             {"render", "--tracer", tracer, "--size", size, "--layers", "color,depth,normal,steps"});
    }
    for (const char* filter : {"trilinear", "elliptical", "elliptical-visible", "supersample"}) {
        over(std::string(filter) + ".exr", {"render", "--filter", filter, "--shadows", "--size", size});
    }
    for (const char* map : {"euclidean", "euclidean-conservative", "refined", "cone", "cone-dummer", "relaxed-cone"}) {
        over(std::string(map) + ".tif", {"map", map});
    }
    for (const char* map : {"cone", "relaxed-cone-robust", "normals"}) {
        over("engine-" + std::string(map) + ".png", {"map", map});
    }
    all.push_back({"tiled.tif", {"tile", height}});
    over("rays.csv", {"export", "rays", "--size", "16x12"});
    over("trace.csv", {"trace", "--ray", "3.25,7.5,11,-6"});
    all.push_back({"cone.frag", {"export", "shader", "--tracer", "cone"}});
    return all;
}

class ReproducibleTest : public CommandTest {
  protected:
    // Hashes of all outputs. target: one instruction set; 0: the best of this machine.
    std::map<std::string, std::string> hashes(std::int64_t target, const char* threads) {
        RunSetup setup;
        setup.variables = {{"SOURCE_DATE_EPOCH", "0"}};
        if (target != 0) setup.variables.emplace_back("RELIEF_TEST_TARGET", std::to_string(target));
        std::map<std::string, std::string> out;
        for (const Output& output : outputs(height_)) {
            std::vector<std::string> arguments = output.arguments;
            arguments.insert(arguments.end(), {"-o", path(output.file), "--quiet"});
            const bool threaded = arguments[0] == "render" || arguments[0] == "map";
            if (threaded) arguments.insert(arguments.end(), {"--threads", threads});
            runFine(arguments, setup);
            const std::string bytes = read(output.file);
            out[output.file] = app::hashText(std::as_bytes(std::span(bytes)));
        }
        return out;
    }

    void SetUp() override {
        CommandTest::SetUp();
        height_ = makeRelief("bricks", "height.png", {"--size", "32x32"});
    }

    std::string height_;
};

std::map<std::string, std::string> keptHashes() {
    std::map<std::string, std::string> kept;
    std::ifstream file(RELIEF_FILES "/output_hashes.txt");
    for (std::string name, hash; file >> name >> hash;) kept[name] = hash;
    return kept;
}

TEST_P(ReproducibleTest, FortyOutputsHaveTheirKeptBytes) {
    const auto now = hashes(0, "2");
    const char* const wish = std::getenv("RELIEF_GOLDEN");
    if (wish != nullptr && std::strcmp(wish, "write") == 0) {
        std::ofstream file(RELIEF_FILES "/output_hashes.txt");
        for (const auto& [name, hash] : now) file << name << ' ' << hash << '\n';
    }
    EXPECT_GE(now.size(), 40U);
    EXPECT_EQ(now, keptHashes());
}

TEST_P(ReproducibleTest, OnEveryInstructionSetAndWithOneThread) {
    const auto kept = keptHashes();
    for (const std::int64_t target : laneTargets()) {
        SCOPED_TRACE(laneTargetName(target));
        EXPECT_EQ(hashes(target, "1"), kept);
    }
}

INSTANTIATE_TEST_SUITE_P(Places, ReproducibleTest, testing::ValuesIn(places()), placeName);

}  // namespace
}  // namespace relief::test
