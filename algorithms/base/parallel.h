// Parallel loops; all parallel loops of the project use these. Results must not depend on how a loop is divided: each
// index writes only its own data, and reductions either combine in index order (parallelReduce) or commute.
//
// With a Work, a loop runs on its threads, stops when its stop token is set, and then throws Cancelled. Without one it
// runs on the threads of the enclosing loop, or on all. An exception in a body ends the loop and is rethrown to the
// caller. Loops may be nested. Cost: one call through a pointer per part and some microseconds per loop, so an index
// should be about as much work as an image row.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "relief/thread_team.h"
#include "relief/work.h"

namespace relief {

// Calls body(first, last) on parts of [0, count). Parts of no more than `grain` indices are not divided further.
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

// Calls body(i) for each i of [0, count). grain: smallest number of indices per task, for bodies that do little work.
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

// Returns join(... join(of(0, grain), of(grain, 2 grain)) ..., of(..., count)); count > 0. Parts and order do not
// depend on the number of threads, so floating-point sums have the same bits for any.
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

// Returns the smallest and the largest value, in parallel. values: not empty.
template <class Value>
std::pair<Value, Value> minMax(Work& work, std::span<const Value> values) {
    using Pair = std::pair<Value, Value>;
    const auto of = [&](std::size_t first, std::size_t last) -> Pair {
        const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(first),
                                                     values.begin() + static_cast<std::ptrdiff_t>(last));
        return {*low, *high};
    };
    const auto join = [](const Pair& a, const Pair& b) -> Pair {
        return {std::min(a.first, b.first), std::max(a.second, b.second)};
    };
    return parallelReduce(work, values.size(), std::size_t{1} << 16U, of, join);
}

}  // namespace relief
