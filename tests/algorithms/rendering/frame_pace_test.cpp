// Adaptive quality of moving pictures on simulated machines: how soon it keeps the budget, and that it does not
// oscillate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "measuring/random_rays.h"
#include "rendering/frame_pace.h"

namespace relief::test {
namespace {

constexpr double kBudget = 0.02;
constexpr double kTolerated = FramePace::kTolerated * kBudget;
// Seconds per frame of the levels, for a picture of 800 x 600: the selected filter, with fewer samples, without regard
// to the relief; then at 1/2, 1/3, 1/4, 1/6, 1/8 of the size.
const std::vector<double> kNominal{0.365, 0.27, 0.19, 0.048, 0.021, 0.012, 0.0053, 0.003};
const int kLast = static_cast<int>(kNominal.size()) - 1;

// Returns the seconds that a frame takes on a level.
using Machine = std::function<double(int level)>;

Machine timesNominal(double times) {
    return [times](int level) { return times * kNominal[static_cast<std::size_t>(level)]; };
}

std::vector<int> run(FramePace& pace, const Machine& machine, int frames) {
    std::vector<int> levels;
    for (int n = 0; n < frames; ++n) {
        levels.push_back(pace.level());
        pace.took(machine(pace.level()));
    }
    return levels;
}

int finestWithin(const Machine& machine, double seconds) {
    int level = 0;
    while (level < kLast && machine(level) > seconds) ++level;
    return level;
}

FramePace started() {
    FramePace pace(kBudget);
    pace.setLevels(kNominal);
    return pace;
}

// For machines of every speed, the level is found within a few frames, and kept.
TEST(FramePace, findsTheLevelAndKeepsIt) {
    for (double speed = 1e-3; speed < 1e3; speed *= 1.7) {
        FramePace pace = started();
        const Machine machine = timesNominal(speed);
        const std::string what = "times " + std::to_string(speed);
        run(pace, machine, 8);
        EXPECT_GE(pace.level(), finestWithin(machine, kTolerated)) << what;
        EXPECT_LE(pace.level(), finestWithin(machine, FramePace::kWellWithin * kBudget)) << what;
        // A level that just fits may be found a little later.
        run(pace, machine, 60);
        const int level = pace.level();
        // Except for rare trials of a finer level, two frames each.
        const std::vector<int> levels = run(pace, machine, 500);
        EXPECT_GE(std::count(levels.begin(), levels.end(), level), 490) << what;
    }
}

// The level is also found if costs differ from the nominal ones (a filter that is slower or faster, or a part of each
// frame that does not depend on the picture's size); levels that are too slow are tried more and more rarely.
TEST(FramePace, findsTheLevelIfCostsAreNotNominal) {
    Random random(11);
    for (int n = 0; n < 300; ++n) {
        std::vector<double> costs = kNominal;
        const double speed = std::pow(10.0, random.between(-2, 1)), constant = random.between(0, 0.008);
        for (double& cost : costs) cost *= speed * std::pow(4.0, random.between(-1, 1));
        for (std::size_t k = costs.size() - 1; k-- > 0;) costs[k] = std::max(costs[k], 1.1 * costs[k + 1]);
        const Machine machine = [&](int level) { return constant + costs[static_cast<std::size_t>(level)]; };
        FramePace pace = started();
        run(pace, machine, 200);
        const std::vector<int> levels = run(pace, machine, 1000);
        const std::string what = "machine " + std::to_string(n);
        const auto slow = std::count_if(levels.begin(), levels.end(),
                                        [&](int level) { return machine(level) > kTolerated && level < kLast; });
        if (machine(kLast) <= kTolerated) {
            EXPECT_LE(slow, 60) << what;
        }
        // At most one level, or one that is much cheaper, lies between the result and the finest level that fits.
        const int fits = finestWithin(machine, 0.4 * kBudget);
        EXPECT_LE(*std::min_element(levels.begin(), levels.end()), fits) << what;
        const auto coarse = std::count_if(levels.begin(), levels.end(), [&](int level) { return level > fits; });
        EXPECT_LE(coarse, 60) << what;
    }
}

// A single slow frame, however slow and at whatever time, changes nothing.
TEST(FramePace, oneSlowFrameChangesNothing) {
    for (const double speed : {0.04, 0.1, 0.3, 1.0}) {
        for (const double slow : {2.0, 20.0, 1000.0}) {
            for (int at = 0; at < 80; ++at) {
                const std::string what =
                    std::to_string(speed) + ", " + std::to_string(slow) + ", at " + std::to_string(at);
                FramePace calm = started(), disturbed = started();
                const Machine machine = timesNominal(speed);
                run(calm, machine, 100);
                run(disturbed, machine, at);
                const int level = disturbed.level();
                disturbed.took(slow * machine(level));
                // By then it has found its level.
                if (at >= 60) {
                    for (const int after : run(disturbed, machine, 6)) EXPECT_EQ(after, level) << what;
                }
                run(disturbed, machine, 100 - at);
                EXPECT_EQ(disturbed.level(), calm.level()) << what;
            }
        }
    }
}

// After a temporary load, the former level is reached again within a few frames.
TEST(FramePace, recoversWithinAFewFrames) {
    for (const double speed : {0.04, 0.1, 0.3, 1.0}) {
        for (const double slow : {2.0, 5.0, 20.0, 1000.0}) {
            for (int length = 1; length < 40; ++length) {
                FramePace pace = started();
                const Machine machine = timesNominal(speed);
                run(pace, machine, 60);
                const int level = pace.level();
                run(pace, timesNominal(slow * speed), length);
                // Four frames for the median, and one level more; a level that just fits may take some trials.
                run(pace, machine, 6);
                EXPECT_LE(pace.level(), finestWithin(machine, FramePace::kWellWithin * kBudget))
                    << speed << " " << slow << " " << length;
                run(pace, machine, 120);
                EXPECT_EQ(pace.level(), level) << speed << " " << slow << " " << length;
            }
        }
    }
}

// If a view becomes permanently slower, the budget is kept after two frames, provided that any level keeps it, except
// for rare trials of a finer level, two frames each.
TEST(FramePace, keepsTheBudgetAfterTwoFrames) {
    for (const double speed : {0.04, 0.1, 0.3, 1.0}) {
        for (const double slow : {2.0, 5.0, 20.0}) {
            FramePace pace = started();
            run(pace, timesNominal(speed), 60);
            const Machine machine = timesNominal(slow * speed);
            run(pace, machine, 2);
            int above = 0, inARow = 0, longest = 0;
            for (const int level : run(pace, machine, 200)) {
                const bool kept = machine(level) <= kTolerated || level == kLast;
                above += kept ? 0 : 1;
                inARow = kept ? 0 : inARow + 1;
                longest = std::max(longest, inARow);
            }
            EXPECT_LE(above, 6) << speed << " " << slow;
            EXPECT_LE(longest, 2) << speed << " " << slow;
        }
    }
}

// Frame times vary by a third, but the level hardly ever changes.
TEST(FramePace, doesNotOscillate) {
    Random random(7);
    for (double speed = 0.02; speed < 4; speed *= 1.3) {
        FramePace pace = started();
        const Machine machine = [&](int level) { return timesNominal(speed)(level) * random.between(0.85, 1.15); };
        run(pace, machine, 50);
        const std::vector<int> levels = run(pace, machine, 1000);
        int changes = 0;
        for (std::size_t n = 1; n < levels.size(); ++n) changes += levels[n] != levels[n - 1];
        EXPECT_LE(changes, 16) << speed;
    }
}

// An abandoned frame takes effect at once; faster frames bring the finer level back.
TEST(FramePace, whatWasGivenUpIsCoarserAtOnce) {
    FramePace pace = started();
    const Machine fast = timesNominal(0.04);
    run(pace, fast, 30);
    ASSERT_EQ(pace.level(), 0);
    pace.gaveUp(1);
    EXPECT_GT(pace.level(), 2);
    EXPECT_LE(pace.expected(pace.level()), kBudget);
    run(pace, fast, 12);
    EXPECT_EQ(pace.level(), 0);
    // Abandoned before it could have been finished, which implies nothing about its time.
    pace.gaveUp(0.5 * kBudget);
    EXPECT_EQ(pace.level(), 0);
}

// The time of a full picture at rest is used if it is fast, and if it is far too slow.
TEST(FramePace, theTimeOfAFullPictureIsUsed) {
    FramePace pace = started();
    EXPECT_GT(pace.level(), 0);
    pace.rested(0.5 * kBudget);
    EXPECT_EQ(pace.level(), 0);
    pace.rested(2 * kBudget);
    EXPECT_EQ(pace.level(), 0);
    pace.rested(100 * kBudget);
    EXPECT_GT(pace.level(), 2);
    run(pace, timesNominal(0.02), 12);
    EXPECT_EQ(pace.level(), 0);
}

}  // namespace
}  // namespace relief::test
