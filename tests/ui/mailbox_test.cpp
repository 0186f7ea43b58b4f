// Calls between threads: mailbox.h and background_call.h.
#include "workspace/mailbox.h"

#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include <QThreadPool>

#include "window_fixture.h"
#include "workspace/background_call.h"

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
