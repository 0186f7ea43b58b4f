#include "workspace/aside.h"

#include <deque>
#include <mutex>
#include <utility>

#include <QThreadPool>

namespace reliefui {

namespace {

// Calls that no thread of the pool has taken. A queue of our own, for the reason that mailbox.h gives.
struct Waiting {
    std::mutex mutex;
    std::deque<std::function<void()>> calls;
};

Waiting& waiting() {
    // Never destroyed: a thread of the pool may end after this library's own objects.
    static auto* const calls = new Waiting;
    return *calls;
}

void runNext() {
    std::function<void()> call;
    {
        const std::lock_guard lock(waiting().mutex);
        call = std::move(waiting().calls.front());
        waiting().calls.pop_front();
    }
    call();
}

}  // namespace

void runAside(std::function<void()> call) {
    {
        const std::lock_guard lock(waiting().mutex);
        waiting().calls.push_back(std::move(call));
    }
    QThreadPool::globalInstance()->start(runNext);
}

}  // namespace reliefui
