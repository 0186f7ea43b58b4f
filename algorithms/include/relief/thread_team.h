// The threads that run parallel loops. All other code uses them through base/parallel.h.
//
// There are two implementations: oneTBB (thread_team.cpp), and plain threads (plain_thread_team.cpp) if
// RELIEF_PLAIN_THREADS is defined, as in builds for the thread sanitizer. The sanitizer cannot see how an
// uninstrumented oneTBB synchronises, and suppressing its false reports by name would also hide data races in our own
// loop bodies.
#pragma once

#include <cstdint>
#include <memory>

#include "relief/function_ref.h"

namespace relief {

// A range of loop indexes, [first, last).
using LoopPart = FunctionRef<void(std::int64_t first, std::int64_t last)>;

class ThreadTeam {
  public:
    // threads: number of threads that may run a loop at once, including the calling thread; it is limited to the number
    // of hardware threads, which is also the meaning of 0.
    explicit ThreadTeam(int threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    // Returns the number of threads that may run a loop at once, at least 1.
    int size() const;

    // Calls body(first, last) for parts that together make up [0, count), in any order, and returns when all are done.
    // Only parts of more than `grain` indexes are divided further. The first exception thrown by a body is rethrown
    // here, and parts that have not begun by then are skipped. May be called from several threads and from within a
    // body; a nested loop runs on this team or (plain threads) on the calling thread alone.
    void run(std::int64_t count, std::int64_t grain, LoopPart body);

    // Runs the loop on the team whose loop the calling thread is running, or else on all hardware threads.
    static void runOnCurrent(std::int64_t count, std::int64_t grain, LoopPart body);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace relief
