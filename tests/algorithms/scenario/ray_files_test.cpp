#include "scenario/ray_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "algorithms/images/temporary_folder.h"
#include "scenario/rays_view.h"

namespace relief {
namespace {

// Returns the message of the refusal; empty if the text is accepted.
std::string refusal(const std::string& text) {
    try {
        parseRays(text, "r.csv");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(RayFiles, NumbersAreReadExactly) {
    const RayBlock rays = parseRays("s0,t0,a,b\n0.1,-2.5e-3,1e300,-0\r\n5,1e-400,3,4", "r.csv");
    ASSERT_EQ(rays.size(), 2U);
    EXPECT_EQ(rays[0], (ViewRay{0.1, -2.5e-3, 1e300, -0.0}));
    EXPECT_EQ(rays[1], (ViewRay{5, 0, 3, 4})) << "a number that underflows becomes zero";
    EXPECT_EQ(parseRays("s0,t0,a,b", "r.csv").size(), 0U);
    EXPECT_EQ(parseRays("\xEF\xBB\xBFs0,t0,a,b\r\n1,2,3,4\r\n\r\n", "r.csv").size(), 1U);
}

// A named pipe is not opened, which could wait for its writer for ever.
TEST(RayFiles, OnlyAnOrdinaryFileIsAView) {
    const testing::TemporaryFolder folder;
    const std::string text = R"({"format": "reliefscope rays"})" + std::string(100, ' ');
    EXPECT_TRUE(isRaysView(folder.with("view.json", text)));
    const std::string pipe = folder / "pipe.json";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int descriptor = ::open(pipe.c_str(), O_RDWR);
    ASSERT_EQ(::write(descriptor, text.data(), text.size()), static_cast<::ssize_t>(text.size()));
    EXPECT_FALSE(isRaysView(pipe));
    ::close(descriptor);
}

TEST(RayFiles, FaultsNameTheLine) {
    EXPECT_EQ(refusal(""), "r.csv: line 1: the header must be \"s0,t0,a,b\", not \"\"");
    EXPECT_EQ(refusal("s0,t0,a,b\n1,2,3\n"),
              "r.csv: line 2: four numbers separated by commas are needed, not \"1,2,3\"");
    EXPECT_EQ(refusal("s0,t0,a,b\n1,2,3,4\n1,2,x\x01,4\n"), "r.csv: line 3: \"x?\" is not a number");
    EXPECT_EQ(refusal("s0,t0,a,b\n1,2,-inf,4\n"), "r.csv: line 2: \"-inf\" is not finite");
    EXPECT_EQ(refusal("s0,t0,a,b\n1,2,1e309,4\n"), "r.csv: line 2: \"1e309\" is not finite");
    EXPECT_NE(refusal("s0,t0,a,b\n1, 2,3,4\n"), "");
    EXPECT_NE(refusal("s0,t0,a,b\n1,2,3,4 \n"), "");
    EXPECT_NE(refusal("s0,t0,a,b\n\n1,2,3,4\n"), "");
    // Any line is quoted in the message as one short line, truncated between characters.
    std::string words;
    for (int i = 0; i < 200; ++i) words += "щ";
    const std::string message = refusal("s0,t0,a,b\n" + words);
    EXPECT_LT(message.size(), 200U);
    EXPECT_NE(message.find("щ...\""), std::string::npos) << message;
}

TEST(RayFiles, HitsHaveSeventeenDigits) {
    HitBlock hits(4);
    hits.set(0, {Outcome::Hit, 0.1, 1.0 / 3.0, -1e-5});
    hits.steps[0] = 12;
    hits.set(1, Hit::none(Outcome::Miss));
    hits.steps[1] = 3;
    hits.set(2, Hit::none(Outcome::Limit));
    Work work(2);
    EXPECT_EQ(
        hitLines(hits, work),
        "hit,0.10000000000000001,0.33333333333333331,-1.0000000000000001e-05,12\nmiss,,,,3\nlimit,,,,0\nmiss,,,,0\n");
}

TEST(RayFiles, PiecesJoinInOrder) {
    HitBlock hits(30000);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits.set(i, {Outcome::Hit, 0.5, static_cast<double>(i), 0});
    }
    Work work(2);
    std::string expected;
    appendHitLines(expected, hits, 0, hits.size());
    EXPECT_EQ(hitLines(hits, work), expected);
}

TEST(RayFiles, StepsAsTableAndAsJson) {
    StepLog log;
    log.steps.resize(3);
    log.steps[1].decision = Decision::Skip;
    log.steps[1].level = 2;
    log.steps[1].i = -1;
    log.steps[1].lambdaIn = 0.25;
    log.steps[2].value = std::numeric_limits<double>::infinity();
    log.begin = {0, 1, 3};
    std::string table;
    appendStepLines(table, log, 1, 7);
    EXPECT_EQ(table,
              "7,1,search,2,-1,0,0,0.25,0,0.75,1,0,skip,0,texel,,,,,,,\n"
              "7,2,search,0,0,0,0,0,0,1,1,inf,test,0,texel,,,,,,,\n");
    log.steps[1].subject = subject::Cone{1.5, 2, 0.25, 0.125, 3, 8, true};
    log.steps[2].subject = subject::Voxel{0, 0, 0, 4, 16, 0.5};
    table.clear();
    appendStepLines(table, log, 1, 7);
    EXPECT_EQ(table,
              "7,1,search,2,-1,0,0,0.25,0,0.75,1,0,skip,0,cone,1.5,2,0.25,1,1,3,8\n"
              "7,2,search,0,0,0,0,0,0,1,1,inf,test,0,voxel,,,,4,4,,16\n");
    std::string objects = "[";
    bool empty = true;
    appendStepObjects(objects, log, 0, 6, empty);
    appendStepObjects(objects, log, 1, 7, empty);
    const auto json = nlohmann::json::parse(objects + "]");
    ASSERT_EQ(json.size(), 3U);
    EXPECT_EQ(json[0]["ray"], 6);
    EXPECT_EQ(json[1]["decision"], "skip");
    EXPECT_EQ(json[1]["z_in"], 0.75);
    EXPECT_EQ(json[2]["number"], 2);
    EXPECT_TRUE(json[2]["value"].is_null());
    EXPECT_EQ(json[0]["kind"], "texel");
    EXPECT_FALSE(json[0].contains("s"));
    EXPECT_EQ(json[1]["z"], 0.25);
    EXPECT_EQ(json[1]["count"], 8);
    EXPECT_EQ(json[2]["width"], 4);
}

}  // namespace
}  // namespace relief
