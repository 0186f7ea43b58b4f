#include "workspace/background_call.h"

#include <deque>
#include <mutex>
#include <utility>

#include <QThreadPool>

namespace reliefui {

namespace {

// Calls not yet taken by a thread of the pool. Qt's own queue is not used, for the reason given in mailbox.h.
struct Waiting {
    std::mutex mutex;
    std::deque<std::function<void()>> calls;
};

Waiting& waiting() {
    // Never destroyed: a thread of the pool may outlive this library's static objects.
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

void runInBackground(std::function<void()> call) {
    {
        const std::lock_guard lock(waiting().mutex);
        waiting().calls.push_back(std::move(call));
    }
    QThreadPool::globalInstance()->start(runNext);
}

}  // namespace reliefui
