// Calls between threads: mailbox.h, latest_job.h and background_call.h.
#include "workspace/mailbox.h"

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <QThreadPool>

#include "window_fixture.h"
#include "workspace/background_call.h"
#include "workspace/latest_job.h"

namespace reliefui {

namespace {

TEST_F(WindowTest, PostedCallsRunHereInTheirOrder) {
    constexpr int kPosted = 200;
    const Mailbox mailbox(qApp);
    const auto here = std::this_thread::get_id();
    std::array<std::vector<int>, 3> got;
    {
        std::vector<std::jthread> posting;
        for (std::vector<int>& of : got) {
            posting.emplace_back([&of, here, to = mailbox.address()] {
                for (int n = 0; n < kPosted; ++n) {
                    to.post([&of, here, n] {
                        EXPECT_EQ(std::this_thread::get_id(), here);
                        of.push_back(n);
                    });
                }
            });
        }
    }
    for (const std::vector<int>& of : got) EXPECT_TRUE(of.empty()) << "no call runs before events are processed";
    QCoreApplication::processEvents();
    for (const std::vector<int>& of : got) {
        ASSERT_EQ(of.size(), std::size_t{kPosted});
        EXPECT_TRUE(std::is_sorted(of.begin(), of.end()));
    }
}

TEST_F(WindowTest, CallsToAMailboxThatIsGoneAreDropped) {
    const auto held = std::make_shared<int>(0);
    auto mailbox = std::make_unique<Mailbox>(qApp);
    const Mailbox::Address address = mailbox->address();
    const auto call = [held] { ++*held; };
    address.post(call);
    mailbox.reset();
    address.post(call);
    QCoreApplication::processEvents();
    EXPECT_EQ(*held, 0);
    EXPECT_EQ(held.use_count(), 2) << "held here and in call, not by a queue";
}

TEST_F(WindowTest, NoResultFollowsACancelledJob) {
    std::vector<std::string> told;
    const auto failed = [&](const QString& problem) { told.push_back("failed" + problem.toStdString()); };
    LatestJob job(qApp, {failed, [](const QString&, double) {}});
    EXPECT_FALSE(job.cancel());
    std::atomic<bool> ended = false;
    job.start({[&](relief::Work&) { ended = true; }, [&] { told.emplace_back("done"); }});
    while (!ended) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // its result is on its way
    EXPECT_TRUE(job.cancel());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, 5000));
    QCoreApplication::processEvents();
    EXPECT_EQ(told, std::vector<std::string>{"failed"});
    job.start({[](relief::Work&) {}, [&] { told.emplace_back("done"); }});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, 5000));
    EXPECT_EQ(told, (std::vector<std::string>{"failed", "done"}));
}

TEST_F(WindowTest, BackgroundWorkRunsOnceInAnotherThread) {
    const auto here = std::this_thread::get_id();
    std::array<std::atomic<int>, 50> times{};
    for (std::atomic<int>& of : times) {
        runInBackground([&of, here] { of += std::this_thread::get_id() == here ? 100 : 1; });
    }
    QThreadPool::globalInstance()->waitForDone();
    for (const std::atomic<int>& of : times) EXPECT_EQ(of, 1);
}

}  // namespace

}  // namespace reliefui
