// Signals at random moments of commands that write files. Whatever is signalled when: the command ends with the status
// of its signal and one line, an output keeps its old or gets its new bytes, no other file is left, and what can be
// resumed resumes to the same bytes. After SIGKILL, which no process sees, temporary files may be left.
#include <iostream>
#include <map>

#include "measuring/random_rays.h"
#include "sweep_fixture.h"

namespace relief::test {
namespace {

using Clock = std::chrono::steady_clock;

struct SignalledCommand {
    std::string name;
    std::vector<std::string> arguments;
    std::vector<std::string> outputs;
    bool resumes = false;
};

// How a process ended.
struct Ended {
    int status = 0;       // as a shell reports it
    bool killed = false;  // by the signal itself, not by the program's answer to it
};

Ended endOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), WIFSIGNALED(status)};
}

class SignalsTest : public SweepTest {
  protected:
    void SetUp() override {
        SweepTest::SetUp();
        setenv("SOURCE_DATE_EPOCH", "0", 1);
        const char* const seed = std::getenv("RELIEF_SEED");
        seed_ = seed != nullptr ? std::strtoull(seed, nullptr, 10) : 7;
        random_ = Random(seed_);
        height_ = makeRelief("bricks", "h.png", {"--size", "256x192"});
        picture_ = makeRelief("hills", "p.tif", {"--size", "512x1024"});
        std::string rays = "s0,t0,a,b\n";
        for (int n = 0; n < 4000; ++n) rays += std::to_string(n % 256) + ".25," + std::to_string(n % 192) + ",7,5\n";
        rays_ = write("rays.csv", rays);
        before_ = files();
    }
    void TearDown() override {
        unsetenv("SOURCE_DATE_EPOCH");
        SweepTest::TearDown();
    }

    std::vector<SignalledCommand> commands() const {
        const std::string png = path("o.png"), tif = path("o.tif"), csv = path("o.csv"), folder = path("frames");
        return {{"make", {"make", "fractal", "--size", "700x600", "-o", png}, {"o.png"}},
                {"make in tiles", {"make", "fractal:512x1024", "--tiled", "-o", tif}, {"o.tif"}, true},
                {"render",
                 {"render", height_, "--size", "640x480", "--shadows", "-o", path("o.exr"), "--layers", "color,steps"},
                 {"o.exr"}},
                {"render in tiles",
                 {"render", height_, "--size", "300x640", "--shadows", "--tiled", "-o", tif},
                 {"o.tif"},
                 true},
                {"render of many",
                 {"render", height_, "--size", "160x120", "--camera", "elevation=60", "--to", "elevation=20",
                  "--frames", "3", "-o", folder},
                 {"frames/h_00000.png", "frames/h_00001.png", "frames/h_00002.png"},
                 true},
                {"tile", {"tile", picture_, "-o", tif}, {"o.tif"}, true},
                {"map", {"map", "cone", height_, "-o", tif}, {"o.tif"}},
                {"map for an engine", {"map", "cone", height_, "-o", png}, {"o.png", "o.png.json"}},
                {"trace",
                 {"trace", "--height", height_, "--rays", rays_, "-o", csv, "--steps", path("s.csv")},
                 {"o.csv", "s.csv"}},
                {"export", {"export", "rays", height_, "--size", "240x200", "-o", csv}, {"o.csv", "o.json"}},
                {"stress",
                 {"stress", "--cases", "12", "--tracers", "layers", "--parts", "tracers", "--record", path("r.jsonl")},
                 {"r.jsonl"}},
                {"bench", sweep("b.csv"), {"b.csv"}, true}};
    }

    // What two runs of the command have in common: all bytes, of a table all but its times.
    std::string comparable(const SignalledCommand& command, const std::string& output) const {
        if (command.name != "bench" || !std::filesystem::exists(path(output))) return read(output);
        std::string text;
        for (const auto& row : withoutTimings(read(output))) {
            for (const std::string& field : row) text += field + ",";
        }
        return text;
    }

    // Runs the command undisturbed: keeps its outputs, and the time it takes.
    void learn(const SignalledCommand& command) {
        cleanUp();
        const auto begin = Clock::now();
        ASSERT_EQ(endOf(start(command.arguments, path("said"))).status, 0) << read("said");
        took_ = Clock::now() - begin;
        good_.clear();
        for (const std::string& output : command.outputs) {
            good_[output] = comparable(command, output);
            ASSERT_FALSE(good_[output].empty()) << output;
        }
    }

    // there: whether the outputs exist before.
    void trySignal(const SignalledCommand& command, int number, bool there) {
        const auto after = std::chrono::duration_cast<std::chrono::microseconds>(took_ * random_.between(0, 1.1));
        SCOPED_TRACE(command.name + ": signal " + std::to_string(number) + " after " + std::to_string(after.count()) +
                     " us, seed " + std::to_string(seed_));
        cleanUp();
        std::map<std::string, std::string> old;
        for (const std::string& output : command.outputs) {
            old[output] = there && output.find('/') == std::string::npos ? kOld : "";
            if (!old[output].empty()) write(output, old[output]);
        }
        const pid_t child = start(command.arguments, path("said"));
        std::this_thread::sleep_for(after);
        kill(child, number);
        const Ended ended = endOf(child);
        ++tried_;
        const std::string said = read("said");
        ASSERT_TRUE(ended.status == 0 || ended.status == 128 + number) << ended.status << "\n" << said;
        if (ended.status != 0) ++stopped_;
        const bool answered = ended.status != 0 && !ended.killed;
        if (answered) ++answered_;
        // A process that is not yet, or no longer, ready to answer is ended by the signal, without a word.
        ASSERT_EQ(lines(said).size(), answered ? 1U : 0U) << said;
        if (answered) {
            ASSERT_TRUE(said.starts_with("relief: ")) << said;
        }
        for (const std::string& output : command.outputs) {
            const std::string now = comparable(command, output);
            ASSERT_TRUE(now == good_[output] || (ended.status != 0 && read(output) == old[output]))
                << output << " is lost";
        }
        expectNoOtherFiles(command, number == SIGKILL);
        if (command.resumes) {
            ASSERT_NO_FATAL_FAILURE(resume(command));
        }
    }

    void report() const {
        std::cout << "seed " << seed_ << ": " << tried_ << " signals, " << stopped_ << " before the end, " << answered_
                  << " answered\n";
    }
    int answered() const { return answered_; }

    // Runs the command with a closed reader of its standard output, after the reader has taken some bytes.
    Ended piped(const std::vector<std::string>& arguments, std::size_t bytes) const {
        int ends[2] = {-1, -1};
        EXPECT_EQ(pipe(ends), 0);
        // The program must not hold the reader's end.
        for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
        const pid_t child = start(arguments, path("said"), {}, ends[1]);
        close(ends[1]);
        std::vector<char> taken(bytes);
        for (std::size_t got = 0; got < bytes;) {
            const ssize_t some = ::read(ends[0], taken.data() + got, bytes - got);
            if (some <= 0) break;
            got += static_cast<std::size_t>(some);
        }
        close(ends[0]);
        return endOf(child);
    }

    const std::string& height() const { return height_; }
    const std::string& rays() const { return rays_; }
    Random& random() { return random_; }
    void cleanUp() const {
        for (const std::string& file : files()) {
            if (std::count(before_.begin(), before_.end(), file) == 0) std::filesystem::remove_all(path(file));
        }
    }

    static int most(int few, int many) { return std::getenv("RELIEF_LONG") != nullptr ? many : few; }

  private:
    void resume(const SignalledCommand& command) {
        std::vector<std::string> again = command.arguments;
        again.emplace_back("--resume");
        const Result result = run(again);
        ASSERT_EQ(result.status, 0) << result.err;
        for (const std::string& output : command.outputs) {
            ASSERT_TRUE(comparable(command, output) == good_[output]) << output << " differs after --resume";
        }
    }

    void expectNoOtherFiles(const SignalledCommand& command, bool temporary) const {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path(""))) {
            const std::string file = std::filesystem::relative(entry.path(), path("")).string();
            const bool known = std::count(before_.begin(), before_.end(), file) != 0 || good_.contains(file) ||
                               file == "said" || entry.is_directory();
            const bool kept = command.resumes && (file.ends_with(".part") || file.ends_with(".rows"));
            const bool left = temporary && entry.path().filename().string().starts_with(".relief-");
            ASSERT_TRUE(known || kept || left) << file << " is left";
        }
    }

    std::uint64_t seed_ = 0;
    Random random_{0};
    std::string height_, picture_, rays_;
    std::vector<std::string> before_;
    std::map<std::string, std::string> good_;
    Clock::duration took_{};
    int tried_ = 0, stopped_ = 0, answered_ = 0;
};

TEST_P(SignalsTest, AtRandomMomentsLoseNothing) {
    const std::vector<int> kinds{SIGINT, SIGTERM, SIGHUP, SIGKILL};
    std::size_t turn = 0;
    for (const SignalledCommand& command : commands()) {
        SCOPED_TRACE(command.name);
        ASSERT_NO_FATAL_FAILURE(learn(command));
        for (int n = 0; n < most(2, 40); ++n) {
            const int number = kinds[turn++ % kinds.size()];
            ASSERT_NO_FATAL_FAILURE(trySignal(command, number, random().below(2) == 0));
        }
    }
    report();
    EXPECT_GT(answered(), 3);
}

// Ends as other programs do whose reader ends: by SIGPIPE, without a message. Files beside standard output are whole.
TEST_P(SignalsTest, AReaderThatEndsLeavesNothing) {
    const std::vector<std::string> trace{"trace", "--height", height(), "--rays", rays(), "--steps", path("s.csv")};
    ASSERT_EQ(run(trace).status, 0);
    const std::string steps = read("s.csv");
    for (int n = 0; n < most(4, 100); ++n) {
        cleanUp();
        write("s.csv", "old");
        // The output is longer than this and a pipe's buffer together.
        const Ended ended = piped(trace, static_cast<std::size_t>(random().below(40'000)));
        EXPECT_EQ(ended.status, 128 + SIGPIPE);
        EXPECT_TRUE(ended.killed);
        EXPECT_EQ(read("said"), "");
        const std::string now = read("s.csv");
        EXPECT_TRUE(now == "old" || now == steps);
        for (const std::string& file : files()) EXPECT_FALSE(file.starts_with(".relief-")) << file;
    }
}

INSTANTIATE_TEST_SUITE_P(Places, SignalsTest, testing::ValuesIn(places()), placeName);

}  // namespace
}  // namespace relief::test
