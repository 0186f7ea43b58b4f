// External methods as a user of the command line meets them.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "filtering/filters/filter_choice.h"
#include "relief/files.h"
#include "relief/tracers.h"

namespace relief::test {
namespace {

// Rounding in float of two ways to weight four texels; smallest difference that many more texels must make.
constexpr double kRounding = 1e-6, kSeen = 1e-3;

// Returns what the program prints; fails the test if the program fails.
std::string printed(const std::string& arguments) {
    const std::string command = std::string(RELIEF_PROGRAM) + " " + arguments + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    std::string out;
    for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
    EXPECT_TRUE(pipe != nullptr && pclose(pipe) == 0) << command << "\n" << out;
    return out;
}

class Guests : public testing::Test {
  protected:
    void SetUp() override {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = std::filesystem::temp_directory_path() / ("relief-guests-" + std::to_string(getpid()) + name);
        std::filesystem::create_directory(folder_);
        printed("make bricks --quiet --size 64 -o " + path("bricks.png"));
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

  private:
    std::filesystem::path folder_;
};

TEST(GuestLists, EndWithTheGuests) {
    EXPECT_EQ(tracerList().back().name, "halving");
    EXPECT_EQ(filterList().back().name, "tent");
}

TEST_F(Guests, AreListedWithTheirOptions) {
    const std::string list = printed("list");
    for (const char* const part : {"halving", "halvings", "tent", "reach"}) {
        EXPECT_NE(list.find(part), std::string::npos) << part;
    }
}

TEST_F(Guests, TraceAndLogInWords) {
    const std::string out =
        printed("trace --quiet --height " + path("bricks.png") + " --tracer halving --pixel 400,300 --set halvings=20");
    EXPECT_NE(out.find("hit"), std::string::npos) << out;
    printed("trace --quiet --height " + path("bricks.png") +
            " --tracer halving --set halvings=9 --pixel 400,300 --steps " + path("steps.csv"));
    const std::string steps = readTextFile(path("steps.csv"));
    EXPECT_EQ(std::count(steps.begin(), steps.end(), '\n'), 1 + 9 + 1) << steps;
    EXPECT_NE(steps.find("refine"), std::string::npos);
}

TEST_F(Guests, AreMeasured) {
    printed("bench tracers --quiet --relief bricks:64x64 --tracers halving --elevations 60 -o " + path("rates.csv"));
    EXPECT_NE(readTextFile(path("rates.csv")).find("halving"), std::string::npos);
    printed(
        "bench filters --quiet --relief bricks:32x32 --elevations 60 --pixel-models box --size 40x30 --samples 3 "
        "--rounds 1 -o " +
        path("filters.csv"));
    EXPECT_NE(readTextFile(path("filters.csv")).find("\ntent,"), std::string::npos);
    const std::string advice = printed("recommend --quiet --relief bricks:32x32 --form scalar --seconds 1 --json");
    EXPECT_NE(advice.find("\"tent\""), std::string::npos) << advice;
}

// Reach 1 is bilinear interpolation in other words: the same picture except for rounding; a larger reach gives another
// one.
TEST_F(Guests, DrawPictures) {
    const auto picture = [&](const std::string& filter, const std::string& name) {
        printed("render --quiet --height " + path("bricks.png") + " --color " + path("bricks.png") +
                " --tracer halving --size 80x60 " + filter + " -o " + path(name));
    };
    picture("--filter bilinear", "bilinear.exr");
    picture("--filter tent --filter-set reach=1", "one.exr");
    picture("--filter tent --filter-set reach=4", "four.exr");
    const auto difference = [&](const std::string& name) {
        const std::string text = printed("compare " + path("bilinear.exr") + " " + path(name));
        return parseNumber(text.substr(5, text.find('\n') - 5), text);
    };
    EXPECT_LT(difference("one.exr"), kRounding);
    EXPECT_GT(difference("four.exr"), kSeen);
}

}  // namespace
}  // namespace relief::test
