// Sweeps that are killed and go on, and sweeps that several processes share: the rows are those of one quiet run.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <set>
#include <thread>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

namespace {

// Columns that differ from run to run: rate, spread, build_seconds.
const std::set<std::size_t> kTimings{11, 12, 24};
constexpr auto kPoll = std::chrono::milliseconds(2);
constexpr auto kPatience = std::chrono::seconds(60);  // of a test that would wait for ever otherwise

std::vector<std::vector<std::string>> withoutTimings(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : lines(csv)) {
        rows.emplace_back();
        const auto all = fields(line);
        for (std::size_t c = 0; c < all.size(); ++c) {
            if (kTimings.count(c) == 0) rows.back().push_back(all[c]);
        }
    }
    return rows;
}

bool waitFor(const std::function<bool()>& there) {
    const auto begun = std::chrono::steady_clock::now();
    while (!there()) {
        if (std::chrono::steady_clock::now() - begun > kPatience) return false;
        std::this_thread::sleep_for(kPoll);
    }
    return true;
}

int statusOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

using Variables = std::vector<std::pair<std::string, std::string>>;

}  // namespace

class SweepTest : public CommandTest {
  protected:
    static constexpr std::size_t kCells = 2 * 2 * 2 * 3;

    std::vector<std::string> sweep(const std::string& output, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"bench",        "tracers",
                                     "--relief",     "hills",
                                     "--relief",     "bricks",
                                     "--sizes",      "64,96",
                                     "--seed",       "1,2",
                                     "--rays",       "3000",
                                     "--elevations", "60,20,random",
                                     "--rounds",     "12",
                                     "--tracers",    "max-pyramid-paper,exact",
                                     "--threads",    "1",
                                     "-o",           path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    // Runs on its own; what it says goes to `errors`.
    pid_t start(const std::vector<std::string>& arguments, const Variables& variables = {},
                const std::string& errors = "/dev/null") const {
        std::vector<char*> pointers{const_cast<char*>(RELIEF_PROGRAM)};
        for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
        pointers.push_back(nullptr);
        const pid_t child = fork();
        if (child != 0) return child;
        const int nowhere = open("/dev/null", O_RDWR);
        for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO}) dup2(nowhere, descriptor);
        dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        signal(SIGINT, SIG_DFL);
        for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
        execv(RELIEF_PROGRAM, pointers.data());
        _exit(127);
    }
    pid_t startRank(int rank, int size, const std::string& job, const std::vector<std::string>& arguments) const {
        return start(arguments, {{"OMPI_COMM_WORLD_RANK", std::to_string(rank)},
                                 {"OMPI_COMM_WORLD_SIZE", std::to_string(size)},
                                 {"PMIX_NAMESPACE", job}});
    }
    // Parts that the journal holds, whole lines only.
    std::vector<nlohmann::json> done(const std::string& output) const {
        std::vector<nlohmann::json> parts;
        if (!std::filesystem::exists(path(output + ".part"))) return parts;
        for (const std::string& line : lines(read(output + ".part"))) {
            auto json = nlohmann::json::parse(line, nullptr, false);
            if (json.is_object() && json.contains("part")) parts.push_back(std::move(json));
        }
        return parts;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, SweepTest, testing::ValuesIn(places()), placeName);

TEST_P(SweepTest, KilledTenTimesGoesOnToTheSameTable) {
    runFine(sweep("whole.csv"));
    const auto whole = withoutTimings(read("whole.csv"));
    ASSERT_EQ(whole.size(), 1 + 2 * kCells);
    std::size_t before = 0;
    for (std::size_t kills = 1; kills <= 10; ++kills) {
        const pid_t child = start(sweep("b.csv", {"--resume"}));
        // Each time somewhere in the cell after another two.
        ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 2 * kills; })) << kills;
        std::this_thread::sleep_for(std::chrono::microseconds(700 * kills));
        kill(child, SIGKILL);
        ASSERT_EQ(statusOf(child), 128 + SIGKILL) << "it must not have come to its end";
        const std::size_t now = done("b.csv").size();
        EXPECT_GE(now, std::max(before, 2 * kills)) << "nothing that was done is lost";
        before = now;
    }
    EXPECT_FALSE(std::filesystem::exists(path("b.csv")));
    const Result last = run(sweep("b.csv", {"--resume"}));
    EXPECT_EQ(last.status, 0) << last.err;
    EXPECT_NE(last.err.find(std::to_string(before)), std::string::npos) << last.err;
    EXPECT_EQ(withoutTimings(read("b.csv")), whole);
    EXPECT_EQ(files(), (std::vector<std::string>{"b.csv", "whole.csv"}));
}

TEST_P(SweepTest, DoneCellsAreTakenAsTheyAreAndHalfLinesAreNot) {
    const pid_t child = start(sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 3; }));
    kill(child, SIGKILL);
    statusOf(child);
    // A mark that no measurement would give; and a crash in the middle of the last line.
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
    ASSERT_LT(marked + 1, kept.size()) << "the line that is cut is another";
    write("b.csv.part", text.substr(0, text.size() - 9));
    EXPECT_EQ(run(sweep("b.csv", {"--resume"})).status, 0);
    const std::string csv = read("b.csv");
    EXPECT_NE(csv.find(",987654,"), std::string::npos) << "measured again";
    EXPECT_EQ(lines(csv).size(), 1 + 2 * kCells);
    write("b.csv.part", text);
    runFine(sweep("b.csv", {"--anew"}));
    EXPECT_EQ(read("b.csv").find(",987654,"), std::string::npos);
}

TEST_P(SweepTest, StoppedItSaysHowToGoOnAndNothingIsThrownAwayUnasked) {
    for (const int number : {SIGINT, SIGTERM}) {
        std::filesystem::remove(path("b.csv.part"));  // else the first run's parts are taken for the second's
        const pid_t child = start(sweep("b.csv"), {}, path("said"));
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
                              {}, path("said"));
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(path("b.csv.part")); }));
    kill(child, SIGINT);
    EXPECT_EQ(statusOf(child), 128 + SIGINT);
    EXPECT_EQ(files(), std::vector<std::string>{"said"});
    EXPECT_NE(read("said").find("nothing is kept"), std::string::npos) << read("said");
}

TEST_P(SweepTest, WithoutFileLocksOneProcessWorksAndSeveralAreRefused) {
    const auto rows = [&](const std::string& output) {
        return std::vector<std::string>{"bench",    "rows", "--widths", "100,200", "--variants", "direct",
                                        "--pixels", "1000", "--rounds", "1",       "-o",         path(output)};
    };
    for (const int error : {ENOLCK, EINVAL}) {
        RunSetup setup;
        setup.lockError = error;
        const Result alone = run(rows("b.csv"), setup);
        if (alone.status == kNoFilter) GTEST_SKIP() << "no system call can be made to fail here";
        EXPECT_EQ(alone.status, 0) << alone.err;
        EXPECT_EQ(lines(alone.err).size(), 1U) << alone.err;
        EXPECT_NE(alone.err.find(path("b.csv.part")), std::string::npos) << alone.err;
        EXPECT_NE(alone.err.find(std::strerror(error)), std::string::npos) << alone.err;
        EXPECT_EQ(lines(read("b.csv")).size(), 1U + 2 * 3 * 2) << "widths, elevations, float and double";
        setup.variables = {{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "2"}, {"PMIX_NAMESPACE", "job"}};
        expectRefusal(rows("c.csv"), 1, {path("c.csv.part"), "locks"}, setup);
        EXPECT_EQ(files(), std::vector<std::string>{"b.csv"});
    }
}

TEST_P(SweepTest, AnotherSweepIsNotGoneOnWith) {
    const pid_t child = start(sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return !done("b.csv").empty(); }));
    kill(child, SIGKILL);
    statusOf(child);
    auto other = sweep("b.csv", {"--resume"});
    other[11] = "3001";  // rays
    expectRefusal(other, 2, {path("b.csv.part"), "--resume"});
    other = sweep("b.csv", {"--resume", "--lowest", "5"});
    expectRefusal(other, 2, {path("b.csv.part")});
    write("b.csv.part", "");
    expectRefusal(sweep("b.csv", {"--resume"}), 2, {path("b.csv.part")});
    write("b.csv.part", "height,size\nbricks,16\n");
    expectRefusal(sweep("b.csv", {"--resume"}), 2, {path("b.csv.part")});
}

TEST_P(SweepTest, ProcessesShareTheCellsAndOneMayDie) {
    runFine(sweep("whole.csv"));
    const auto whole = withoutTimings(read("whole.csv"));
    for (const int dying : {0, 2}) {
        const std::string job = "job" + std::to_string(dying);
        std::vector<pid_t> ranks{startRank(0, 4, job, sweep("b.csv"))};
        // Rank 0 alone makes the file; each of the others waits for it.
        for (int rank = 1; rank < 4; ++rank) ranks.push_back(startRank(rank, 4, job, sweep("b.csv")));
        const auto byDying = [&](const nlohmann::json& part) { return part["by"] == dying; };
        const auto some = [&] {
            const auto parts = done("b.csv");
            return std::any_of(parts.begin(), parts.end(), byDying);
        };
        // Stopped after its first cell: with luck in the middle of another, which is nobody else's then.
        if (!waitFor([&] { return some() || std::filesystem::exists(path("b.csv")); })) FAIL();
        kill(ranks[static_cast<std::size_t>(dying)], SIGKILL);
        for (int rank = 0; rank < 4; ++rank) {
            const int status = statusOf(ranks[static_cast<std::size_t>(rank)]);
            if (rank != dying) {
                EXPECT_EQ(status, 0) << "rank " << rank;
            }
        }
        EXPECT_EQ(withoutTimings(read("b.csv")), whole) << "rank " << dying << " killed";
        EXPECT_EQ(files(), (std::vector<std::string>{"b.csv", "whole.csv"}));
        std::filesystem::remove(path("b.csv"));
    }
}

TEST_P(SweepTest, ACellOfAProcessThatHangsIsDoneWhenItDies) {
    runFine(sweep("whole.csv"));
    const pid_t first = startRank(0, 2, "job", sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return !done("b.csv").empty(); }));
    // Well into its next cell, where it holds no lock but that cell's.
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
    // Not dead: what it holds stays its own, and the other does all the rest.
    kill(first, SIGSTOP);
    const pid_t second = startRank(1, 2, "job", sweep("b.csv"));
    ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= kCells - 1; }));
    std::size_t others = 0;
    for (const auto& part : done("b.csv")) others += part["by"] == 1 ? 1 : 0;
    EXPECT_GE(others, 1U);
    kill(first, SIGKILL);
    statusOf(first);
    EXPECT_EQ(statusOf(second), 0);
    EXPECT_EQ(withoutTimings(read("b.csv")), withoutTimings(read("whole.csv")));
    EXPECT_EQ(files(), (std::vector<std::string>{"b.csv", "whole.csv"}));
}

// The journal of version 1 holds the first two of four cells, see its folder's README.
TEST_P(SweepTest, ASweepOfAnOlderProgramIsGoneOnWith) {
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
            EXPECT_EQ(std::stod(fields(csv[row]).at(11)), kept["rate"].get<double>()) << "measured again";
            ++row;
        }
    }
}

TEST_P(SweepTest, RowsAndFiltersGoOnToo) {
    const std::vector<std::vector<std::string>> sweeps{
        {"bench", "rows", "--widths", "100,200,300,400", "--elevations", "60,25,8", "--variants", "direct,streams",
         "--pixels", "4000000", "--rounds", "5", "--threads", "1"},
        {"bench", "filters", "--scenes", "checker,bricks", "--filters", "bilinear,trilinear", "--elevations",
         "60,50,40,30,20,10", "--size", "32x24", "--samples", "4", "--rounds", "1", "--threads", "1"}};
    // rate and spread of each.
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
