#ifndef RELIEF_PLAIN_THREADS

#include "relief/thread_team.h"

#include <algorithm>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace relief {

struct ThreadTeam::Implementation {
    explicit Implementation(int threads)
        : arena(threads > 0 ? std::min(threads, tbb::info::default_concurrency()) : tbb::task_arena::automatic) {}
    tbb::task_arena arena;
};

ThreadTeam::ThreadTeam(int threads) : implementation_(std::make_unique<Implementation>(threads)) {}

ThreadTeam::~ThreadTeam() = default;

int ThreadTeam::size() const {
    return implementation_->arena.max_concurrency();
}

void ThreadTeam::run(std::int64_t count, std::int64_t grain, LoopPart body) {
    implementation_->arena.execute([&] { runOnCurrent(count, grain, body); });
}

void ThreadTeam::runOnCurrent(std::int64_t count, std::int64_t grain, LoopPart body) {
    using Range = tbb::blocked_range<std::int64_t>;
    tbb::parallel_for(Range(0, count, static_cast<std::size_t>(grain)),
                      [body](const Range& part) { body(part.begin(), part.end()); });
}

}  // namespace relief

#endif
