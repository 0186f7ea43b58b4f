#ifdef RELIEF_PLAIN_THREADS

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "relief/thread_team.h"

namespace relief {

namespace {

// Parts a thread gets of a loop whose grain allows them: uneven parts balance, and threads meet often.
constexpr std::int64_t kPartsPerThread = 16;

thread_local bool inLoop = false;

// Two at least, so that races are seen on any machine.
int processorThreads() {
    return std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
}

// One loop, shared by the threads that run it. Each thread has a part that it runs in any case: else the calling thread
// would be done with short loops before another has begun, and races would go unseen. Further parts are handed out by a
// relaxed counter: a stronger order would make what one part wrote visible to the next, and so hide races as well.
class Loop {
  public:
    Loop(std::int64_t count, std::int64_t part, std::int64_t threads, LoopPart body)
        : count_(count), part_(part), body_(body), next_(threads * part) {}

    // thread: 0, 1, ..., each once.
    void work(std::int64_t thread) {
        inLoop = true;
        for (std::int64_t first = thread * part_; first < count_ && !failed_.load(std::memory_order_relaxed);
             first = next_.fetch_add(part_, std::memory_order_relaxed)) {
            try {
                body_(first, std::min(first + part_, count_));
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!failed_.exchange(true)) failure_ = std::current_exception();
            }
        }
        inLoop = false;
    }

    // To be called when all threads are done.
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    const std::int64_t count_;
    const std::int64_t part_;
    const LoopPart body_;
    std::atomic<std::int64_t> next_;
    std::atomic<bool> failed_{false};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

void runOn(std::int64_t threads, std::int64_t count, std::int64_t grain, LoopPart body) {
    if (count <= 0) return;
    const std::int64_t part = std::max(grain, count / (kPartsPerThread * threads));
    const std::int64_t parts = (count + part - 1) / part;
    threads = std::min(threads, parts);
    if (threads == 1 || inLoop) return body(0, count);
    Loop loop(count, part, threads, body);
    {
        std::vector<std::jthread> helpers;
        for (std::int64_t n = 1; n < threads; ++n) helpers.emplace_back([&loop, n] { loop.work(n); });
        loop.work(0);
    }
    loop.rethrow();
}

}  // namespace

struct ThreadTeam::Implementation {
    int threads;
};

ThreadTeam::ThreadTeam(int threads)
    : implementation_(std::make_unique<Implementation>(
          Implementation{threads > 0 ? std::min(threads, processorThreads()) : processorThreads()})) {}

ThreadTeam::~ThreadTeam() = default;

int ThreadTeam::size() const {
    return implementation_->threads;
}

void ThreadTeam::run(std::int64_t count, std::int64_t grain, LoopPart body) {
    runOn(implementation_->threads, count, grain, body);
}

void ThreadTeam::runOnCurrent(std::int64_t count, std::int64_t grain, LoopPart body) {
    runOn(processorThreads(), count, grain, body);
}

}  // namespace relief

#endif
