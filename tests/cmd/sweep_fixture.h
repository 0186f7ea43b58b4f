// A sweep of 24 cells that is started, killed and resumed; its rows are compared without the columns that vary.
#pragma once

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
#include "measuring/random_rays.h"

namespace relief::test {

// Columns that differ from run to run: rate, spread, build_seconds.
inline const std::set<std::size_t> kTimings{11, 12, 24};
inline constexpr auto kPoll = std::chrono::milliseconds(2);
inline constexpr auto kPatience = std::chrono::seconds(60);  // after which a waiting test fails

inline std::vector<std::vector<std::string>> withoutTimings(const std::string& csv) {
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

inline bool waitFor(const std::function<bool()>& there) {
    const auto begun = std::chrono::steady_clock::now();
    while (!there()) {
        if (std::chrono::steady_clock::now() - begun > kPatience) return false;
        std::this_thread::sleep_for(kPoll);
    }
    return true;
}

inline int statusOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

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
    // Starts the program in the background; its standard error goes to the file `errors`. launcher: as in RunSetup.
    // output: descriptor of its standard output; -1: none.
    pid_t start(const std::vector<std::string>& arguments, const std::string& errors = "/dev/null",
                const std::vector<std::string>& launcher = {}, int output = -1) const;
    // Starts the sweep, with --resume, and has it killed at a random moment of the time that it takes undisturbed,
    // until that has happened `kills` times: the table of each sweep that ends is that of the undisturbed one, without
    // its times. end: kills the process and all that it has started.
    void killAtRandom(int kills, const std::vector<std::string>& launcher,
                      const std::function<void(pid_t, Random&)>& end) const;
    // Returns the parts that the journal contains, complete lines only.
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

}  // namespace relief::test
