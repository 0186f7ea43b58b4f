// Sweeps and pictures shared by the ranks of an MPI run have the results of one process.
#include <fstream>
#include <iterator>

#include "sweep_fixture.h"

namespace relief::test {

namespace {

std::vector<std::string> mpirun(int ranks) {
    return {"mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-n", std::to_string(ranks)};
}

// Open MPI leaks memory in plug-ins that it has unloaded, so the address sanitizer has no symbol by which to suppress
// it.
class LeaksOfMpi {
  public:
    LeaksOfMpi() {
        const char* const options = std::getenv(kVariable);
        if (options != nullptr) before_ = options;
        setenv(kVariable, (before_ + ":detect_leaks=0").c_str(), 1);
    }
    ~LeaksOfMpi() { setenv(kVariable, before_.c_str(), 1); }
    LeaksOfMpi(const LeaksOfMpi&) = delete;
    LeaksOfMpi& operator=(const LeaksOfMpi&) = delete;

  private:
    static constexpr const char* kVariable = "ASAN_OPTIONS";
    std::string before_;
};

// Returns the descendants of the process that run the program.
std::vector<pid_t> ranksOf(pid_t parent) {
    std::vector<pid_t> ranks;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "stat");
        std::string text;
        std::getline(file, text);
        const std::size_t name = text.find('('), end = text.rfind(')');
        if (name == std::string::npos || text.substr(name, end - name + 1) != "(relief)") continue;
        char state = 0;
        pid_t above = 0;
        std::istringstream(text.substr(end + 1)) >> state >> above;
        if (above == parent) ranks.push_back(static_cast<pid_t>(std::stoi(text)));
    }
    std::sort(ranks.begin(), ranks.end());
    return ranks;
}

// Returns the processes whose command line contains the text.
std::vector<pid_t> naming(const std::string& text) {
    std::vector<pid_t> all;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "cmdline", std::ios::binary);
        const std::string words{std::istreambuf_iterator<char>(file), {}};
        if (words.find(text) != std::string::npos)
            all.push_back(static_cast<pid_t>(std::stoi(entry.path().filename())));
    }
    return all;
}

}  // namespace

class MpiTest : public SweepTest {
  protected:
    void SetUp() override {
        SweepTest::SetUp();
        if (!std::filesystem::exists(RELIEF_PLUGIN)) GTEST_SKIP() << "built without MPI";
    }
    Result runRanks(int ranks, const std::vector<std::string>& arguments) const {
        RunSetup setup;
        setup.launcher = mpirun(ranks);
        return run(arguments, setup);
    }

  private:
    LeaksOfMpi leaks_;
};
INSTANTIATE_TEST_SUITE_P(Places, MpiTest, testing::ValuesIn(places()), placeName);

TEST_P(MpiTest, RanksShareASweepAndOneFails) {
    runFine(sweep("whole.csv"));
    const auto whole = withoutTimings(read("whole.csv"));
    const Result shared = runRanks(4, sweep("b.csv", {"--quiet"}));
    ASSERT_EQ(shared.status, 0) << shared.err;
    EXPECT_EQ(withoutTimings(read("b.csv")), whole);
    const auto said = lines(shared.err);
    ASSERT_EQ(said.size(), 1U) << shared.err;
    for (const char* const rank : {"rank 0 ", "rank 1 ", "rank 2 ", "rank 3 "})
        EXPECT_NE(said[0].find(rank), std::string::npos) << said[0];
    // Rates were measured: not all are those of one rank.
    for (std::size_t row = 1; row <= 2 * kCells; ++row) {
        EXPECT_GT(std::stod(fields(lines(read("b.csv"))[row]).at(11)), 0) << row;
    }
    EXPECT_EQ(files(), (std::vector<std::string>{"b.csv", "whole.csv"}));

    const pid_t launcher = start(sweep("c.csv"), path("said"), mpirun(3));
    ASSERT_TRUE(waitFor([&] { return done("c.csv").size() >= 3; }));
    const std::vector<pid_t> ranks = ranksOf(launcher);
    ASSERT_EQ(ranks.size(), 3U);
    kill(ranks.back(), SIGKILL);
    EXPECT_NE(statusOf(launcher), 0);
    EXPECT_FALSE(std::filesystem::exists(path("c.csv")));
    const std::size_t before = done("c.csv").size();
    ASSERT_GE(before, 3U);
    EXPECT_NE(read("c.csv.part").find("{\"counted\":"), std::string::npos) << "the counts are lost";
    const Result last = runRanks(2, sweep("c.csv", {"--resume"}));
    EXPECT_EQ(last.status, 0) << last.err;
    EXPECT_NE(last.err.find(std::to_string(before) + " "), std::string::npos) << last.err;
    EXPECT_EQ(withoutTimings(read("c.csv")), whole);
    EXPECT_FALSE(std::filesystem::exists(path("c.csv.part")));
}

// One process resumes what an MPI run left, and vice versa.
TEST_P(MpiTest, AnotherNumberOfProcessesResumes) {
    runFine(sweep("whole.csv"));
    for (const bool shared : {true, false}) {
        const pid_t child = start(sweep("b.csv"), "/dev/null", shared ? mpirun(2) : std::vector<std::string>{});
        ASSERT_TRUE(waitFor([&] { return done("b.csv").size() >= 2; }));
        for (const pid_t rank : shared ? ranksOf(child) : std::vector<pid_t>{child}) kill(rank, SIGKILL);
        EXPECT_NE(statusOf(child), 0);
        const auto again = sweep("b.csv", {"--resume"});
        const Result last = shared ? run(again) : runRanks(2, again);
        EXPECT_EQ(last.status, 0) << last.err;
        EXPECT_EQ(withoutTimings(read("b.csv")), withoutTimings(read("whole.csv")));
    }
}

// One rank or all of them are killed; before there are ranks, their launcher.
TEST_P(MpiTest, KilledAtRandomMomentsTheySweepToTheSameTable) {
    const auto end = [&](pid_t launcher, Random& random) {
        std::vector<pid_t> ranks = ranksOf(launcher);
        if (ranks.empty()) {
            kill(launcher, SIGKILL);
            // Ranks that it had just started are nobody's now.
            for (const pid_t rank : naming(path("b.csv"))) kill(rank, SIGKILL);
            return;
        }
        if (random.below(2) == 0)
            ranks = {ranks[static_cast<std::size_t>(random.below(static_cast<int>(ranks.size())))]};
        for (const pid_t rank : ranks) kill(rank, SIGKILL);
        // Open MPI's launcher may wait for ever for a rank that was killed while it joined.
        constexpr auto kSlowEnd = std::chrono::seconds(10);
        const auto begun = std::chrono::steady_clock::now();
        siginfo_t info{};
        while (std::chrono::steady_clock::now() - begun < kSlowEnd) {
            if (waitid(P_PID, static_cast<id_t>(launcher), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return;
            if (info.si_pid == launcher) return;
            std::this_thread::sleep_for(kPoll);
        }
        kill(launcher, SIGKILL);
        for (const pid_t rank : naming(path("b.csv"))) kill(rank, SIGKILL);
    };
    killAtRandom(std::getenv("RELIEF_LONG") != nullptr ? 100 : 2, mpirun(2), end);
}

TEST_P(MpiTest, RefusalsAreOneLineOfRankZeroWithItsStatus) {
    write("b.csv.part", "somebody's own");
    const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& word) {
        const Result refused = runRanks(3, arguments);
        EXPECT_EQ(refused.status, 2) << refused.err;
        std::size_t ours = 0;
        for (const std::string& line : lines(refused.err)) ours += line.starts_with("relief: ") ? 1 : 0;
        EXPECT_EQ(ours, 1U) << refused.err;
        EXPECT_NE(refused.err.find(word), std::string::npos) << refused.err;
    };
    refuse(sweep("b.csv"), "--anew");
    EXPECT_EQ(read("b.csv.part"), "somebody's own");
    refuse(sweep("b.csv", {"--lowest", "much"}), "much");
    refuse(sweep("b.csv", {"--nothing-known"}), "--nothing-known");
}

// A copy of the program without the plug-in.
TEST_P(MpiTest, WithoutMpiSeveralProcessesAreRefused) {
    RunSetup setup;
    setup.variables = {{"OMPI_COMM_WORLD_SIZE", "4"}, {"OMPI_COMM_WORLD_RANK", "0"}};
    setup.program = path("relief");
    std::filesystem::copy_file(RELIEF_PROGRAM, setup.program);
    const std::vector<std::string> rows{"bench", "rows", "--widths", "100", "--rounds", "1", "-o", path("b.csv")};
    expectRefusal(rows, 2, {"4 processes", "MPI", "--part"}, setup);
    EXPECT_EQ(files(), std::vector<std::string>{"relief"});
    // Variables of another MPI's launcher: the plug-in finds that it is alone.
    setup.program.clear();
    setup.variables = {{"PMI_SIZE", "4"}, {"PMI_RANK", "0"}};
    expectRefusal(rows, 2, {"4", "joined 1"}, setup);
    setup.variables.emplace_back("OMPI_COMM_WORLD_SIZE", "0");
    expectRefusal(rows, 2, {"4", "joined 1"}, setup);
}

TEST_P(MpiTest, RowsFiltersAndPicturesAreSharedToo) {
    const std::vector<std::pair<std::vector<std::string>, std::size_t>> sweeps{
        {{"bench", "rows", "--widths", "100,200", "--elevations", "60,25", "--variants", "direct,streams", "--pixels",
          "40000", "--rounds", "2", "--threads", "1"},
         11},
        {{"bench", "filters", "--scenes", "checker", "--filters", "bilinear,trilinear", "--elevations", "60,30,10",
          "--size", "32x24", "--samples", "4", "--rounds", "1", "--threads", "1"},
         9}};
    for (const auto& [command, timed] : sweeps) {
        auto one = command, shared = command;
        one.insert(one.end(), {"-o", path("one.csv")});
        shared.insert(shared.end(), {"-o", path("shared.csv")});
        runFine(one);
        const Result result = runRanks(3, shared);
        ASSERT_EQ(result.status, 0) << result.err;
        const auto a = lines(read("one.csv")), b = lines(read("shared.csv"));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t r = 0; r < a.size(); ++r) {
            auto x = fields(a[r]), y = fields(b[r]);
            for (auto* row : {&x, &y}) (*row)[timed] = (*row)[timed + 1] = "";
            EXPECT_EQ(x, y);
        }
    }
    const std::vector<std::string> path{"render",       "--relief", "hills:32x32",  "--size",   "40x30", "--camera",
                                        "elevation=60", "--to",     "elevation=20", "--frames", "5",     "-o"};
    auto one = path, shared = path;
    one.push_back(this->path("one"));
    shared.push_back(this->path("shared"));
    runFine(one);
    const Result result = runRanks(3, shared);
    ASSERT_EQ(result.status, 0) << result.err;
    for (const auto& entry : std::filesystem::directory_iterator(this->path("one"))) {
        const std::string name = entry.path().filename().string();
        EXPECT_EQ(read("shared/" + name), read("one/" + name)) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(this->path("shared/pictures.part")));
}

TEST_P(MpiTest, OnePictureAndAStressTestAreSharedToo) {
    for (const std::string ending : {"png", "exr"}) {
        std::vector<std::string> one{"render", "--relief", "city:48x48", "--size", "61x47", "--shadows", "-o"};
        auto shared = one;
        one.push_back(path("one." + ending));
        shared.push_back(path("shared." + ending));
        if (ending == "exr") {
            for (auto* command : {&one, &shared}) command->insert(command->end(), {"--layers", "color,depth,steps"});
        }
        runFine(one);
        const Result result = runRanks(3, shared);
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(withoutDate(read("shared." + ending)) == withoutDate(read("one." + ending))) << ending;
    }
    // In tiles: every rank makes rows, rank 0 writes them.
    const std::vector<std::string> tiles{"render", "--relief", "city:48x48", "--size", "61x300", "--tiled", "-o"};
    for (const std::string ending : {"tif", "exr"}) {
        auto one = tiles, shared = tiles;
        one.push_back(path("one." + ending));
        shared.push_back(path("shared." + ending));
        runFine(one);
        const Result result = runRanks(3, shared);
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(read("shared." + ending) == read("one." + ending)) << ending;
        EXPECT_FALSE(std::filesystem::exists(path("shared." + ending + ".part")));
        EXPECT_FALSE(std::filesystem::exists(path("shared." + ending + ".rows")));
    }
    const std::vector<std::string> stress{"stress", "--cases", "70", "--tracers", "layers", "--parts", "tracers"};
    auto one = stress, shared = stress;
    one.insert(one.end(), {"--record", path("one.jsonl")});
    shared.insert(shared.end(), {"--record", path("shared.jsonl")});
    run(one);
    const Result result = runRanks(2, shared);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(read("shared.jsonl"), read("one.jsonl"));
    const Result refused = runRanks(2, {"stress", "--seconds", "1"});
    EXPECT_NE(refused.err.find("--cases"), std::string::npos) << refused.err;
}

}  // namespace relief::test
