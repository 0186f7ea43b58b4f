#include "sweep_fixture.h"

#include <iostream>

namespace relief::test {

pid_t SweepTest::start(const std::vector<std::string>& arguments, const std::string& errors,
                       const std::vector<std::string>& launcher, int output) const {
    std::vector<char*> pointers;
    for (const std::string& word : launcher) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(const_cast<char*>(RELIEF_PROGRAM));
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDIN_FILENO);
    dup2(output >= 0 ? output : nowhere, STDOUT_FILENO);
    dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    signal(SIGINT, SIG_DFL);
    execvp(pointers.front(), pointers.data());
    _exit(127);
}

void SweepTest::killAtRandom(int kills, const std::vector<std::string>& launcher,
                             const std::function<void(pid_t, Random&)>& end) const {
    using Clock = std::chrono::steady_clock;
    constexpr std::uint64_t kSeed = 11;
    Random random(kSeed);
    const auto begin = Clock::now();
    ASSERT_EQ(statusOf(start(sweep("whole.csv"), path("said"), launcher)), 0) << read("said");
    const auto took = Clock::now() - begin;
    const auto whole = withoutTimings(read("whole.csv"));
    ASSERT_EQ(whole.size(), 1 + 2 * kCells);
    int finished = 0, resumed = 0;
    const auto checkFinished = [&] {
        ++finished;
        ASSERT_EQ(withoutTimings(read("b.csv")), whole);
        ASSERT_EQ(files(), (std::vector<std::string>{"b.csv", "said", "whole.csv"}));
        std::filesystem::remove(path("b.csv"));
    };
    for (int killed = 0; killed < kills;) {
        const auto after = std::chrono::duration_cast<std::chrono::microseconds>(took * random.unit());
        SCOPED_TRACE("kill " + std::to_string(killed) + " after " + std::to_string(after.count()) + " us");
        const std::size_t before = done("b.csv").size();
        resumed += before > 0 ? 1 : 0;
        const pid_t child = start(sweep("b.csv", {"--resume"}), path("said"), launcher);
        std::this_thread::sleep_for(after);
        end(child, random);
        if (statusOf(child) == 0) {
            ASSERT_NO_FATAL_FAILURE(checkFinished()) << read("said");
            continue;
        }
        ++killed;
        // The program writes a table beside and renames it as its last deed: one that is there is whole.
        if (std::filesystem::exists(path("b.csv"))) {
            ASSERT_EQ(withoutTimings(read("b.csv")), whole);
            for (const std::string& file : files()) {
                if (file.starts_with("b.csv")) std::filesystem::remove(path(file));
            }
        } else {
            ASSERT_GE(done("b.csv").size(), before) << "finished work is lost";
        }
        for (const std::string& file : files()) {
            if (file.starts_with(".relief-")) std::filesystem::remove(path(file));
        }
    }
    ASSERT_EQ(statusOf(start(sweep("b.csv", {"--resume"}), path("said"), launcher)), 0) << read("said");
    ASSERT_NO_FATAL_FAILURE(checkFinished());
    std::cout << "seed " << kSeed << ": killed " << kills << " times, " << resumed << " starts resumed, " << finished
              << " sweeps ended with the same table\n";
}

}  // namespace relief::test
