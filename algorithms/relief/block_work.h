// What the lists of tracers and of any-hit queries share: splitting blocks of rays into pieces that run in parallel,
// and descriptions that are created once.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>

#include "base/parallel.h"
#include "relief/describe.h"
#include "relief/tracer.h"
#include "relief/work.h"

namespace relief {

// Rays between two checks of the stop token.
inline constexpr std::size_t kRayGrain = 1024;

// Calls body(first, last) for pieces of [0, count) on the work's threads. Throws Cancelled.
template <class Body>
void overBlock(std::size_t count, Work& work, const Body& body) {
    if (count <= kRayGrain) {
        work.throwIfStopped();
        body(std::size_t{0}, count);
        work.throwIfStopped();
        return;
    }
    // Pieces begin at multiples of the grain, so that SIMD versions and packets get the same groups of neighbouring
    // rays for any number of threads.
    parallelFor(work, (count + kRayGrain - 1) / kRayGrain,
                [&](std::size_t n) { body(n * kRayGrain, std::min((n + 1) * kRayGrain, count)); });
}

// Calls one(i, sink) for every ray with a counting sink. Stores the counts of each ray in answers.steps and
// answers.reads and adds their sums to `counts`.
template <class Answers, class One>
void countBlock(std::size_t count, Answers& answers, BlockCounts& counts, Work& work, const One& one) {
    std::atomic<std::uint64_t> highest{0};
    overBlock(count, work, [&](std::size_t first, std::size_t last) {
        std::uint64_t here = 0;
        for (std::size_t i = first; i < last; ++i) {
            CountSink sink;
            one(i, sink);
            answers.steps[i] = sink.steps;
            answers.reads[i] = sink.reads;
            here += sink.highest ? 1 : 0;
        }
        highest += here;
    });
    counts.startHighest += highest;
    for (std::size_t i = 0; i < count; ++i) {
        counts.steps += answers.steps[i];
        counts.reads += answers.reads[i];
    }
}

// Calls one(i, sink) for every ray in turn with a logging sink, and appends the steps to the log. Counts as
// countBlock() does per ray.
template <class Answers, class One>
void logBlock(std::size_t count, Answers& answers, StepLog& log, Work& work, const One& one) {
    LogSink sink;
    sink.steps = std::move(log.steps);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % kRayGrain == 0) work.throwIfStopped();
        sink.reads = 0;
        const std::size_t before = sink.steps.size();
        one(i, sink);
        answers.steps[i] = static_cast<std::uint32_t>(sink.steps.size() - before);
        answers.reads[i] = sink.reads;
        log.begin.push_back(sink.steps.size());
        log.reads.push_back(sink.reads);
    }
    log.steps = std::move(sink.steps);
}

// The method's description with its options, created at the first call (thread-safe).
template <class T>
const MethodDescription& descriptionOf() {
    static const MethodDescription description = [] {
        MethodDescription d = T::describe();
        describeOptions<typename T::Options>(d);
        return d;
    }();
    return description;
}

}  // namespace relief
