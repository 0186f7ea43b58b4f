// Loops of base/parallel.h; the same tests run with oneTBB and with the plain threads of the thread sanitizer's build.
#include "base/parallel.h"

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "base/scratch_pool.h"

namespace relief::test {
namespace {

constexpr int kThreads = 4;

TEST(Parallel, EveryIndexOnce) {
    Work work(kThreads);
    for (const int count : {0, 1, 2, 63, 64, 1000}) {
        for (const int grain : {1, 16, 2000}) {
            std::vector<std::atomic<int>> seen(static_cast<std::size_t>(count));
            parallelFor(
                work, seen.size(), [&](std::size_t i) { ++seen[i]; }, grain);
            parallelFor(
                seen.size(), [&](std::size_t i) { ++seen[i]; }, grain);
            parallelRanges(work, count, grain, [&](int first, int last) {
                EXPECT_LT(first, last);
                for (int i = first; i < last; ++i) ++seen[static_cast<std::size_t>(i)];
            });
            for (const auto& times : seen) EXPECT_EQ(times, 3) << count << ", " << grain;
        }
    }
}

TEST(Parallel, OneThreadIsTheCallingOne) {
    Work work(1);
    EXPECT_EQ(work.threads().size(), 1);
    const auto caller = std::this_thread::get_id();
    std::atomic<int> elsewhere{0};
    parallelFor(work, 1000, [&](int) { elsewhere += std::this_thread::get_id() == caller ? 0 : 1; });
    EXPECT_EQ(elsewhere, 0);
}

TEST(Parallel, LoopsMayBeNested) {
    Work work(kThreads);
    std::vector<int> sums(50);
    parallelFor(work, sums.size(), [&](std::size_t i) {
        std::vector<int> parts(20);
        parallelFor(work, parts.size(), [&](std::size_t j) { parts[j] = static_cast<int>(i * j); });
        sums[i] = std::accumulate(parts.begin(), parts.end(), 0);
    });
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], static_cast<int>(190 * i));
}

TEST(Parallel, AnExceptionComesOut) {
    Work work(kThreads);
    const auto body = [](int i) {
        if (i % 100 == 57) throw std::runtime_error("57");
    };
    EXPECT_THROW(parallelFor(work, 1000, body), std::runtime_error);
    EXPECT_THROW(parallelFor(1000, body), std::runtime_error);
    // The threads can be used for the next loop.
    std::atomic<int> done{0};
    parallelFor(work, 1000, [&](int) { ++done; });
    EXPECT_EQ(done, 1000);
}

TEST(Parallel, AStoppedLoopIsCancelled) {
    std::stop_source stop;
    Work work(kThreads, stop.get_token());
    std::atomic<int> done{0};
    const auto body = [&](int) {
        if (++done == 10) stop.request_stop();
    };
    EXPECT_THROW(parallelFor(work, 100000, body), Cancelled);
    // Each thread may have begun one more index.
    EXPECT_LT(done, 10 + kThreads);
    EXPECT_THROW(parallelFor(work, 0, body), Cancelled);
}

TEST(Parallel, SumsOfFloatsAreTheSameForAnyNumberOfThreads) {
    const auto sum = [](int threads) {
        Work work(threads);
        return parallelReduce(
            work, 100000, 64,
            [](int first, int last) {
                float part = 0;
                for (int i = first; i < last; ++i) part += 1 / (1 + static_cast<float>(i));
                return part;
            },
            [](float a, float b) { return a + b; });
    };
    const float one = sum(1);
    for (int n = 0; n < 20; ++n) EXPECT_EQ(sum(kThreads), one);
}

TEST(Parallel, ScratchIsNobodyElses) {
    Work work(kThreads);
    std::atomic<int> made{0};
    ScratchPool<std::atomic<int>> pool([&] {
        ++made;
        return std::make_unique<std::atomic<int>>(0);
    });
    parallelFor(work, 1000, [&](int) {
        const auto users = pool.borrow();
        EXPECT_EQ(++*users, 1);
        const auto others = pool.borrow();
        EXPECT_NE(&*users, &*others);
        --*users;
    });
    EXPECT_LE(made, 2 * work.threads().size());
}

#ifdef __SANITIZE_THREAD__
// Shows that the thread sanitizer detects races in these loops, so that a run without reports means something.
TEST(ParallelDeathTest, ARaceInALoopIsReported) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto race = [] {
        Work work;
        std::int64_t sum = 0;
        parallelFor(work, 100000, [&](int i) { sum += i; });
        std::exit(sum == 0 ? 1 : 0);
    };
    EXPECT_EXIT(race(), ::testing::ExitedWithCode(66), "data race.*\n.*parallel_test");
}
#endif

}  // namespace
}  // namespace relief::test
