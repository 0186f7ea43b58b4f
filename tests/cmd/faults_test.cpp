// Calls of the system that fail while commands run (tests/faults/faulty.cpp): full disks, broken devices, interrupted
// and partial transfers, memory that ends. Whatever happens, a command ends with its own status and one line, an
// existing output keeps its old or gets its new bytes, and no other file is left.
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>

#include "command_test.h"
#include "measuring/random_rays.h"

#ifdef RELIEF_FAULTS

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr int kPartial = -1;  // faulty.cpp: half of the bytes are transferred

struct FaultyCommand {
    std::string name;
    std::vector<std::string> arguments;
    std::vector<std::string> outputs;
};

class FaultsTest : public CommandTest {
  protected:
    // Number of calls of a kind that fail.
    static int most(int few, int many) { return std::getenv("RELIEF_LONG") != nullptr ? many : few; }

    void SetUp() override {
        CommandTest::SetUp();
        height_ = makeRelief("bricks", "h.png", {"--size", "48x40"});
        tiled_ = path("tiles.tif");
        runFine({"tile", height_, "-o", tiled_, "--quiet"});
        before_ = files();
    }

    std::vector<FaultyCommand> commands() const {
        const std::string png = path("o.png"), tif = path("o.tif"), csv = path("o.csv");
        const auto over = [this](std::vector<std::string> all) {
            all.insert(all.end(), {"--height", height_, "--quiet"});
            return all;
        };
        return {{"make", {"make", "bricks", "--size", "64x64", "-o", png, "--quiet"}, {"o.png"}},
                {"render", over({"render", "--size", "48x32", "-o", png}), {"o.png"}},
                {"render in tiles", over({"render", "--size", "64x48", "--tiled", "-o", tif}), {"o.tif"}},
                {"render from tiles",
                 {"render", "--height", tiled_, "--memory", "64", "--size", "48x32", "-o", png, "--quiet"},
                 {"o.png"}},
                {"tile", {"tile", height_, "-o", tif, "--quiet"}, {"o.tif"}},
                {"map", over({"map", "cone", "-o", tif}), {"o.tif"}},
                {"map for an engine", over({"map", "cone", "-o", png}), {"o.png", "o.png.json"}},
                {"trace", over({"trace", "--ray", "3,3,5,4", "-o", csv, "--steps", path("s.csv")}), {"o.csv", "s.csv"}},
                {"export rays", over({"export", "rays", "--size", "16x12", "-o", csv}), {"o.csv", "o.json"}}};
    }

    // Number of calls by kind in a run without faults; keeps its outputs.
    std::map<std::string, int> counted(const FaultyCommand& command) {
        RunSetup setup = preloaded("RELIEF_FAULT_COUNT", path("count"));
        const Result result = run(command.arguments, setup);
        EXPECT_EQ(result.status, 0) << command.name << ": " << result.err;
        std::map<std::string, int> counts;
        std::istringstream lines(read("count"));
        for (std::string kind; lines >> kind;) lines >> counts[kind];
        good_.clear();
        for (const std::string& output : command.outputs) good_[output] = read(output);
        return counts;
    }

    // Inputs that other faults cut are written again.
    void keepInputs() {
        for (const std::string& file : before_) inputs_[file] = read(file);
    }
    void restoreInputs() const {
        for (const auto& [file, bytes] : inputs_) write(file, bytes);
    }

    // Runs the command with one fault; outputs exist before.
    void tryFault(const FaultyCommand& command, const std::string& kind, int call, int error, bool stays = false) {
        SCOPED_TRACE(command.name + ": " + kind + " " + std::to_string(call) + " error " + std::to_string(error));
        cleanUp();
        for (const std::string& output : command.outputs) write(output, kOld);
        const std::string fault = kind + ":" + std::to_string(call) + ":" + std::to_string(error) + (stays ? "+" : "");
        const Result result = run(command.arguments, preloaded("RELIEF_FAULT", fault));
        ++tried_;
        const bool resumes = error == EINTR || error == kPartial;
        if (resumes) {
            ASSERT_EQ(result.status, 0) << result.err;
        }
        ASSERT_TRUE(result.status >= 0 && result.status <= 2) << result.status << "\n" << result.err;
        if (result.status != 0) {
            ++refused_;
            ASSERT_TRUE(result.err.starts_with("relief: ")) << result.err;
            ASSERT_EQ(lines(result.err).size(), 1U) << result.err;
        }
        for (const std::string& output : command.outputs) {
            const std::string now = read(output);
            ASSERT_TRUE(now == good_[output] || (result.status != 0 && now == kOld)) << output << " is lost";
        }
        for (const std::string& file : files()) {
            const bool known = std::count(before_.begin(), before_.end(), file) != 0 || good_.contains(file);
            // What is done of a long run is kept, and named in the error.
            ASSERT_TRUE(known || file.ends_with(".part") || file.ends_with(".rows")) << file << " is left";
        }
    }

    void report() const {
        std::cout << "seed " << kSeed << ": " << tried_ << " faults, " << refused_ << " of them refused\n";
    }
    int tried() const { return tried_; }

  private:
    RunSetup preloaded(const std::string& name, const std::string& value) const {
        RunSetup setup;
        setup.program = RELIEF_PROGRAM;
        setup.variables = {{"LD_PRELOAD", RELIEF_FAULTS},
                           {"SOURCE_DATE_EPOCH", "0"},
                           {"RELIEF_FAULT_FOLDER", path("")},
                           {name, value}};
        return setup;
    }
    void cleanUp() const {
        for (const std::string& file : files()) {
            if (std::count(before_.begin(), before_.end(), file) == 0) std::filesystem::remove(path(file));
        }
    }

    std::string height_, tiled_;
    std::vector<std::string> before_;
    std::map<std::string, std::string> good_, inputs_;
    int tried_ = 0, refused_ = 0;
};

TEST_P(FaultsTest, FailingCallsLoseNothing) {
    Random random(kSeed);
    for (const FaultyCommand& command : commands()) {
        const auto counts = counted(command);
        const std::vector<std::pair<std::string, std::vector<int>>> kinds{{"open", {EACCES, EMFILE}},
                                                                          {"read", {EIO, ESTALE, EINTR, kPartial}},
                                                                          {"write", {ENOSPC, EIO, EINTR, kPartial}},
                                                                          {"sync", {EIO}},
                                                                          {"rename", {EIO}},
                                                                          {"map", {ENOMEM}}};
        for (const auto& [kind, errors] : kinds) {
            const int calls = counts.at(kind);
            for (int n = 0; n < std::min(calls, most(1, 100)); ++n) {
                const int call = calls <= most(1, 100) ? n + 1 : 1 + random.below(calls);
                for (const int error : errors) ASSERT_NO_FATAL_FAILURE(tryFault(command, kind, call, error));
            }
        }
    }
    report();
    EXPECT_GT(tried(), 60);
}

// Another program shortens a map while it is read by tiles: no command ends by SIGBUS, or takes what is not there for
// heights.
TEST_P(FaultsTest, FilesThatAreCutWhileTheyAreReadEndInOneLine) {
    Random random(kSeed);
    keepInputs();
    for (const FaultyCommand& command : commands()) {
        const int calls = counted(command).at("cut");
        for (int n = 0; n < std::min(calls, most(6, 100)); ++n) {
            const int call = calls <= most(6, 100) ? n + 1 : 1 + random.below(calls);
            ASSERT_NO_FATAL_FAILURE(tryFault(command, "cut", call, random.below(2)));
            restoreInputs();
        }
    }
    report();
    EXPECT_GT(tried(), 3);
}

// Allocations of a whole run are sampled; with "stays" there is no memory from then on.
TEST_P(FaultsTest, FailingAllocationsEndInOneLine) {
    Random random(kSeed);
    // Rendered and written by our own code: libraries that read pictures end the process when they find no memory.
    const FaultyCommand command{
        "render",
        {"render", "--relief", "bricks:48x40", "--size", "64x48", "--tiled", "-o", path("o.tif"), "--quiet"},
        {"o.tif"}};
    const int calls = counted(command).at("memory");
    for (int n = 0; n < most(12, 200); ++n) {
        ASSERT_NO_FATAL_FAILURE(tryFault(command, "memory", 1 + random.below(calls), ENOMEM, n % 2 == 1));
    }
    report();
}

INSTANTIATE_TEST_SUITE_P(Places, FaultsTest, testing::ValuesIn(places()), placeName);

}  // namespace
}  // namespace relief::test

#endif
