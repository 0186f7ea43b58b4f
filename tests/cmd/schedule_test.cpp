// Scheduling of numbered parts over several ranks, simulated without processes.
#include "schedule.h"

#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

namespace relief::app {

namespace {

struct Player {
    Schedule schedule;
    std::vector<std::string> hosts;
    std::vector<std::optional<Task>> at = std::vector<std::optional<Task>>(hosts.size());
    std::map<std::size_t, int> counted = {}, finished = {};

    // Checks that no host times more parts than permitted, or times while it counts.
    void expectQuietTimes(int concurrent) const {
        std::map<std::string, int> counting, timing;
        for (std::size_t rank = 0; rank < at.size(); ++rank) {
            if (!at[rank]) continue;
            ++(at[rank]->pass == Pass::Times ? timing : counting)[hosts[rank]];
        }
        for (const auto& [host, times] : timing) {
            EXPECT_LE(times, concurrent) << host;
            EXPECT_EQ(counting[host], 0) << host << " counts while it times";
        }
    }
    void finish(std::size_t rank) {
        ++(at[rank]->pass == Pass::Counts ? counted : finished)[at[rank]->part];
        at[rank].reset();
        schedule.done(static_cast<int>(rank));
    }
};

TEST(Schedule, EveryPartIsDoneOnceAndTimesHaveTheirHostForThemselves) {
    constexpr std::size_t kParts = 37;
    constexpr std::uint64_t kSeed = 5;
    for (const int concurrent : {1, 2}) {
        for (const bool timed : {true, false}) {
            const std::vector<std::string> hosts{"a", "a", "a", "b", "b", "c"};
            Player play{Schedule(kParts, timed, hosts, concurrent), hosts};
            play.schedule.skip({3, Pass::Whole});
            if (timed) play.schedule.skip({4, Pass::Counts});
            std::mt19937_64 random(kSeed);
            int moves = 0;
            while (!play.schedule.over()) {
                ASSERT_LT(++moves, 10000) << "it does not end";
                const std::size_t rank = random() % hosts.size();
                if (play.at[rank]) {
                    play.finish(rank);
                } else {
                    play.at[rank] = play.schedule.next(static_cast<int>(rank));
                }
                play.expectQuietTimes(concurrent);
            }
            EXPECT_EQ(play.finished.size(), kParts - 1);
            EXPECT_EQ(play.finished.count(3), 0U);
            EXPECT_EQ(play.counted.size(), timed ? kParts - 2 : 0);
            for (const auto& done : {play.counted, play.finished}) {
                for (const auto& [part, times] : done) EXPECT_EQ(times, 1) << part;
            }
            EXPECT_FALSE(play.schedule.next(0));
        }
    }
}

TEST(Schedule, AHostTimesAsSoonAsItsOwnRanksHaveCounted) {
    Schedule schedule(2, true, {"a", "b"}, 1);
    EXPECT_EQ(schedule.next(0), (Task{0, Pass::Counts}));
    EXPECT_EQ(schedule.next(1), (Task{1, Pass::Counts}));
    schedule.done(0);
    EXPECT_EQ(schedule.next(0), (Task{0, Pass::Times})) << "counting on the other host does not disturb this one";
    schedule.done(1);
    EXPECT_EQ(schedule.next(1), (Task{1, Pass::Times}));
    EXPECT_FALSE(schedule.over());
    schedule.done(0);
    schedule.done(1);
    EXPECT_TRUE(schedule.over());
}

}  // namespace

}  // namespace relief::app
