// Parallel loops, the only ones of the project. Results must not depend on how a loop is divided: an index writes what
// is its own; what is summed up over all is put together in the order of the indexes (parallelReduce) or commutes.
//
// With a Work a loop runs on its threads, stops when its stop token says so and then throws Cancelled; without one it
// runs on the threads of the loop around it, or on all. An exception of a body ends the loop and is rethrown. Loops may
// be nested. Cost: a call through a pointer for each part; some microseconds a loop, so bodies should be a row's work.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "relief/thread_team.h"
#include "relief/work.h"

namespace relief {

// body(first, last) over parts of [0, count). Parts of no more than `grain` indexes are not divided.
template <class Index, class Body>
void parallelRanges(Work& work, Index count, Index grain, const Body& body) {
    work.threads().run(static_cast<std::int64_t>(count), static_cast<std::int64_t>(grain),
                       [&](std::int64_t first, std::int64_t last) {
                           if (!work.stopped()) body(static_cast<Index>(first), static_cast<Index>(last));
                       });
    work.throwIfStopped();
}

template <class Index, class Body>
void parallelRanges(Index count, Index grain, const Body& body) {
    ThreadTeam::runOnCurrent(
        static_cast<std::int64_t>(count), static_cast<std::int64_t>(grain),
        [&](std::int64_t first, std::int64_t last) { body(static_cast<Index>(first), static_cast<Index>(last)); });
}

// body(i) for each i of [0, count). grain: indexes that a thread takes at least, where one alone is little work.
template <class Index, class Body>
void parallelFor(Work& work, Index count, const Body& body, int grain = 1) {
    parallelRanges(work, count, static_cast<Index>(grain), [&](Index first, Index last) {
        for (Index i = first; i < last && !work.stopped(); ++i) body(i);
    });
}

template <class Index, class Body>
void parallelFor(Index count, const Body& body, int grain = 1) {
    parallelRanges(count, static_cast<Index>(grain), [&](Index first, Index last) {
        for (Index i = first; i < last; ++i) body(i);
    });
}

// join(... join(of(0, grain), of(grain, 2 grain)) ..., of(..., count)), count > 0: the same parts and order for any
// number of threads, so that also sums of floats are the same.
template <class Index, class Of, class Join>
auto parallelReduce(Work& work, Index count, Index grain, const Of& of, const Join& join) {
    std::vector<decltype(of(count, count))> parts(static_cast<std::size_t>((count + grain - 1) / grain));
    parallelFor(work, parts.size(), [&](std::size_t n) {
        const Index first = static_cast<Index>(n) * grain;
        parts[n] = of(first, std::min(static_cast<Index>(first + grain), count));
    });
    auto all = std::move(parts.front());
    for (std::size_t n = 1; n < parts.size(); ++n) all = join(all, parts[n]);
    return all;
}

}  // namespace relief
