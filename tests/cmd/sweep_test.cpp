// Sweeps that are killed and resumed have the rows of one undisturbed run.
#include <algorithm>

#include "sweep_fixture.h"

namespace relief::test {

INSTANTIATE_TEST_SUITE_P(Places, SweepTest, testing::ValuesIn(places()), placeName);

TEST_P(SweepTest, KilledTenTimesItResumesToTheSameTable) {
    runFine(sweep("whole.csv"));
    const auto whole = withoutTimings(read("whole.csv"));
    ASSERT_EQ(whole.size(), 1 + 2 * kCells);
    std::size_t before = 0;
    for (std::size_t kills = 1; kills <= 10; ++kills) {
        const pid_t child = start(sweep("b.csv", {"--resume"}));
        // Killed each time within a cell, after two more cells.
        ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 2 * kills; })) << kills;
        std::this_thread::sleep_for(std::chrono::microseconds(700 * kills));
        kill(child, SIGKILL);
        ASSERT_EQ(statusOf(child), 128 + SIGKILL) << "it must not have finished";
        const std::size_t now = done("b.csv").size();
        EXPECT_GE(now, std::max(before, 2 * kills)) << "no finished work is lost";
        before = now;
    }
    EXPECT_FALSE(std::filesystem::exists(path("b.csv")));
    const Result last = run(sweep("b.csv", {"--resume"}));
    EXPECT_EQ(last.status, 0) << last.err;
    EXPECT_NE(last.err.find(std::to_string(before)), std::string::npos) << last.err;
    EXPECT_EQ(withoutTimings(read("b.csv")), whole);
    EXPECT_EQ(files(), (std::vector<std::string>{"b.csv", "whole.csv"}));
}

TEST_P(SweepTest, KilledAtRandomMomentsItResumesToTheSameTable) {
    killAtRandom(std::getenv("RELIEF_LONG") != nullptr ? 100 : 5, {},
                 [](pid_t child, Random&) { kill(child, SIGKILL); });
}

TEST_P(SweepTest, FinishedCellsAreKeptAndTruncatedLinesAreNot) {
    const pid_t child = start(sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 3; }));
    kill(child, SIGKILL);
    statusOf(child);
    // Marks a row with a value that no measurement gives, and truncates the last line as a crash would.
    auto kept = lines(read("b.csv.part"));
    std::size_t marked = 0;
    std::string text;
    for (std::size_t l = 0; l < kept.size(); ++l) {
        auto json = nlohmann::ordered_json::parse(kept[l], nullptr, false);
        if (marked == 0 && json.is_object() && json.contains("part")) {
            json["result"][0]["steps_max"] = 987654;
            kept[l] = json.dump();
            marked = l;
        }
        text += kept[l] + "\n";
    }
    ASSERT_GT(marked, 0U);
    ASSERT_LT(marked + 1, kept.size()) << "another line must be truncated";
    // A line without its result, one of a part that does not exist, and one without rows are ignored.
    write("b.csv.part", text.substr(0, text.size() - 9) +
                            "\n{\"part\": 23}\n{\"part\": 99, \"result\": []}\n{\"part\": 22, \"result\": 7}\n");
    EXPECT_EQ(run(sweep("b.csv", {"--resume"})).status, 0);
    const std::string csv = read("b.csv");
    EXPECT_NE(csv.find(",987654,"), std::string::npos) << "the cell was measured again";
    EXPECT_EQ(lines(csv).size(), 1 + 2 * kCells);
    write("b.csv.part", text);
    runFine(sweep("b.csv", {"--anew"}));
    EXPECT_EQ(read("b.csv").find(",987654,"), std::string::npos);
}

TEST_P(SweepTest, StoppedItPrintsHowToResumeAndDiscardsNothingUnasked) {
    for (const int number : {SIGINT, SIGTERM}) {
        std::filesystem::remove(path("b.csv.part"));  // else the first run's parts are taken for the second's
        const pid_t child = start(sweep("b.csv"), path("said"));
        ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 2; }));
        kill(child, number);
        ASSERT_EQ(statusOf(child), 128 + number);
        const std::string said = read("said");
        EXPECT_EQ(lines(said).size(), 1U) << said;
        const std::string count = std::to_string(done("b.csv").size()) + " of " + std::to_string(kCells);
        for (const std::string& part : {path("b.csv.part"), count, std::string("--resume")}) {
            EXPECT_NE(said.find(part), std::string::npos) << said << "lacks " << part;
        }
    }
    const std::string kept = read("b.csv.part");
    auto other = sweep("b.csv");
    other[11] = "3001";  // rays
    for (const auto& again : {sweep("b.csv"), other}) {
        expectRefusal(again, 2, {path("b.csv.part"), "--resume", "--anew"});
    }
    expectRefusal(sweep("b.csv", {"--resume", "--anew"}), 2, {"--resume", "--anew"});
    expectRefusal({"bench", "rows", "--anew"}, 2, {"--anew", "--output"});
    EXPECT_EQ(read("b.csv.part"), kept);
    write("b.csv.part", "somebody's own");
    expectRefusal(sweep("b.csv"), 2, {path("b.csv.part")});
    EXPECT_EQ(read("b.csv.part"), "somebody's own");
}

TEST_P(SweepTest, StoppedBeforeTheFirstPartItLeavesNothing) {
    const pid_t child = start({"bench", "tracers", "--relief", "hills", "--elevations", "60", "--rounds", "1000",
                               "--tracers", "exact", "-o", path("b.csv")},
                              path("said"));
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(path("b.csv.part")); }));
    kill(child, SIGINT);
    EXPECT_EQ(statusOf(child), 128 + SIGINT);
    EXPECT_EQ(files(), std::vector<std::string>{"said"});
    EXPECT_NE(read("said").find("nothing was saved"), std::string::npos) << read("said");
}

TEST_P(SweepTest, ASecondRunWithTheSameOutputIsRefusedWhileTheFirstLives) {
    const pid_t first = start(sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return !done("b.csv").empty(); }));
    kill(first, SIGSTOP);  // it is alive but writes nothing
    const std::string kept = read("b.csv.part");
    for (const auto& second : {sweep("b.csv"), sweep("b.csv", {"--resume"}), sweep("b.csv", {"--anew"})}) {
        expectRefusal(second, 2, {path("b.csv.part"), std::to_string(first)});
    }
    EXPECT_EQ(read("b.csv.part"), kept);
    kill(first, SIGKILL);
    statusOf(first);
    EXPECT_EQ(run(sweep("b.csv", {"--resume"})).status, 0);
    EXPECT_EQ(files(), std::vector<std::string>{"b.csv"});
}

// Both read the journal before either has replaced it: many lines without meaning make reading slow. The sweep takes
// hours, so that neither process ends.
TEST_P(SweepTest, OfTwoThatResumeAtTheSameTimeOneIsRefused) {
    constexpr int kIdleLines = 300'000;
    const auto hours = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = sweep("b.csv", more);
        *(std::find(all.begin(), all.end(), "--rounds") + 1) = "1000";
        return all;
    };
    const pid_t killed = start(hours({}));
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(path("b.csv.part")) && !read("b.csv.part").empty(); }));
    kill(killed, SIGKILL);
    statusOf(killed);
    std::string text = read("b.csv.part");
    for (int line = 0; line < kIdleLines; ++line) text += "{}\n";
    write("b.csv.part", text);
    const pid_t first = start(hours({"--resume"}), path("first"));
    const pid_t second = start(hours({"--resume"}), path("second"));
    int status = 0;
    const pid_t ended = waitpid(-1, &status, 0);
    ASSERT_TRUE(ended == first || ended == second);
    EXPECT_EQ(WEXITSTATUS(status), 2);
    const std::string said = read(ended == first ? "first" : "second");
    EXPECT_EQ(lines(said).size(), 1U) << said;
    EXPECT_NE(said.find(path("b.csv.part")), std::string::npos) << said;
    const pid_t other = ended == first ? second : first;
    EXPECT_NE(said.find(std::to_string(other)), std::string::npos) << said;
    EXPECT_EQ(waitpid(other, &status, WNOHANG), 0) << "it goes on";
    EXPECT_EQ(lines(read("b.csv.part")).front().find(std::to_string(other)) != std::string::npos, true);
    kill(other, SIGKILL);
    statusOf(other);
}

// Neither a process on another host can be checked, nor does another process with the same id count.
TEST_P(SweepTest, AJournalOfAnotherHostOrOfAnEndedProcessIsResumed) {
    const pid_t child = start(sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 2; }));
    kill(child, SIGKILL);
    statusOf(child);
    const std::string kept = read("b.csv.part");
    const std::size_t end = kept.find('\n');
    auto head = nlohmann::ordered_json::parse(kept.substr(0, end));
    head["process"] = getpid();
    auto other = head;
    other["host"] = "farther-away";
    write("b.csv.part", other.dump() + kept.substr(end));
    const Result result = run(sweep("b.csv", {"--resume"}));
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("farther-away"), std::string::npos) << result.err;
    // This process has another start time than the journal states.
    write("b.csv.part", head.dump() + kept.substr(end));
    EXPECT_EQ(run(sweep("b.csv", {"--resume"})).status, 0);
}

TEST_P(SweepTest, AnotherSweepIsNotResumed) {
    const pid_t child = start(sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return !done("b.csv").empty(); }));
    kill(child, SIGKILL);
    statusOf(child);
    auto other = sweep("b.csv", {"--resume"});
    other[11] = "3001";  // rays
    expectRefusal(other, 2, {path("b.csv.part"), "--resume"});
    for (const auto& [option, value] : {std::pair("--lowest", "5"), std::pair("--memory", "512")}) {
        expectRefusal(sweep("b.csv", {"--resume", option, value}), 2, {path("b.csv.part")});
    }
    write("b.csv.part", "");
    expectRefusal(sweep("b.csv", {"--resume"}), 2, {path("b.csv.part")});
    write("b.csv.part", "height,size\nbricks,16\n");
    expectRefusal(sweep("b.csv", {"--resume"}), 2, {path("b.csv.part")});
    for (const char* const first : {"{\"host\": 5, \"process\": \"x\"}\n", "[1, 2]\n", "{\"part\": 0}\n"}) {
        write("b.csv.part", first);
        expectRefusal(sweep("b.csv"), 2, {path("b.csv.part"), "--anew"});
        expectRefusal(sweep("b.csv", {"--resume"}), 2, {path("b.csv.part")});
    }
}

// The journal of version 1 contains the first two of four cells; see the README in its folder.
TEST_P(SweepTest, ASweepOfAnOlderProgramIsResumed) {
    std::filesystem::copy_file(RELIEF_FILES "/v1/tables/sweep.journal", path("b.csv.part"));
    const auto parts = done("b.csv");
    ASSERT_EQ(parts.size(), 2U);
    const Result result = run({"bench", "tracers", "--relief", "bricks:16x16", "--relief", "spikes:16x16", "--rays",
                               "200", "--rounds", "500", "--threads", "1", "--elevations", "60,random", "--tracers",
                               "exact,layers:layers=12,distance-refined:layers=8", "-o", path("b.csv"), "--resume"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("2 of 4"), std::string::npos) << result.err;
    const auto csv = lines(read("b.csv"));
    ASSERT_EQ(csv.size(), 1U + 4 * 3);
    std::size_t row = 1;
    for (const auto& part : parts) {
        for (const auto& kept : part["result"]) {
            EXPECT_EQ(fields(csv[row]).size(), fields(csv[0]).size());
            EXPECT_EQ(fields(csv[row]).at(6), fields(csv[row]).at(5) == "exact" ? "scalar" : "simd");
            EXPECT_EQ(std::stod(fields(csv[row]).at(11)), kept["rate"].get<double>()) << "the cell was measured again";
            ++row;
        }
    }
}

TEST_P(SweepTest, RowsAndFiltersAreResumedToo) {
    const std::vector<std::vector<std::string>> sweeps{
        {"bench", "rows", "--widths", "100,200,300,400", "--elevations", "60,25,8", "--variants", "direct,streams",
         "--pixels", "4000000", "--rounds", "5", "--threads", "1"},
        {"bench", "filters", "--scenes", "checker,bricks", "--filters", "bilinear,trilinear", "--elevations",
         "60,50,40,30,20,10", "--size", "32x24", "--samples", "4", "--rounds", "1", "--threads", "1"}};
    // The columns rate and spread of each table.
    const std::size_t timed[] = {11, 9};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto to = [&](const std::string& output, bool resume) {
            auto all = sweeps[k];
            all.insert(all.end(), {"-o", path(output)});
            if (resume) all.push_back("--resume");
            return all;
        };
        runFine(to("whole.csv", false));
        const pid_t child = start(to("b.csv", false));
        ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 3; }));
        kill(child, SIGKILL);
        ASSERT_EQ(statusOf(child), 128 + SIGKILL);
        const Result last = run(to("b.csv", true));
        EXPECT_EQ(last.status, 0) << last.err;
        const auto whole = lines(read("whole.csv"));
        const auto got = lines(read("b.csv"));
        ASSERT_EQ(got.size(), whole.size());
        for (std::size_t r = 0; r < got.size(); ++r) {
            auto a = fields(got[r]);
            auto b = fields(whole[r]);
            for (auto* row : {&a, &b}) (*row)[timed[k]] = (*row)[timed[k] + 1] = "";
            EXPECT_EQ(a, b);
        }
    }
}

}  // namespace relief::test
