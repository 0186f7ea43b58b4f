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

// Parts per thread, where the grain allows them: enough for load balancing, and for threads to interleave often.
constexpr std::int64_t kPartsPerThread = 16;

thread_local bool inLoop = false;

// At least two, so that the thread sanitizer sees races on any machine.
int processorThreads() {
    return std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
}

// One loop, shared by the threads that run it. Each thread first runs a part of its own; otherwise the calling thread
// would finish short loops before the others have started, and races would go undetected. Further parts are handed out
// by a relaxed counter: a stronger memory order would synchronise the parts with each other and so hide races as well.
class Loop {
  public:
    Loop(std::int64_t count, std::int64_t part, std::int64_t threads, LoopPart body)
        : count_(count), part_(part), body_(body), next_(threads * part) {}

    // To be called once for each thread number 0, 1, ...
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

    // Rethrows the first exception of a body. To be called when all threads have finished.
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
