// The threads that parallel loops run on. Everything else uses it through base/parallel.h.
//
// Two implementations: oneTBB (thread_team.cpp), and plain threads (plain_thread_team.cpp) where RELIEF_PLAIN_THREADS
// is defined, as in the build for the thread sanitizer: it cannot see how an uninstrumented oneTBB synchronizes, and
// suppressing its false reports by name would also hide the races in our own loop bodies.
#pragma once

#include <cstdint>
#include <memory>

#include "relief/function_ref.h"

namespace relief {

// A range of loop indexes, [first, last).
using LoopPart = FunctionRef<void(std::int64_t first, std::int64_t last)>;

class ThreadTeam {
  public:
    // threads: how many may run a loop at once, the calling thread included; 0: as many as the processor runs, which is
    // also the most that are taken.
    explicit ThreadTeam(int threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    int size() const;

    // Calls body(first, last) for parts that together are [0, count), in any order, and returns when all are done.
    // Only parts of more than `grain` indexes are divided further. The first exception that a body throws is rethrown
    // here; parts not begun by then are left out. May be called from several threads and from within a body: there a
    // loop runs on this team, or (plain threads) on the calling thread alone.
    void run(std::int64_t count, std::int64_t grain, LoopPart body);

    // The same on the team whose loop the calling thread is running, or else on all threads of the processor.
    static void runOnCurrent(std::int64_t count, std::int64_t grain, LoopPart body);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace relief
