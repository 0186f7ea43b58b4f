// What both lists of methods (tracers, any-hit queries) need: blocks of rays cut into pieces that run in parallel, and
// descriptions made once.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/parallel.h"
#include "relief/describe.h"
#include "relief/work.h"

namespace relief {

// Rays traced between two looks at the stop token.
inline constexpr std::size_t kRayGrain = 1024;

// body(first, last) over [0, count) on the work's threads; throws Cancelled.
template <class Body>
void overBlock(std::size_t count, Work& work, const Body& body) {
    if (count <= kRayGrain) {
        work.throwIfStopped();
        body(std::size_t{0}, count);
        work.throwIfStopped();
        return;
    }
    // Cut at multiples of the grain: lanes and packets keep the rays together that came together.
    parallelFor(work, (count + kRayGrain - 1) / kRayGrain,
                [&](std::size_t n) { body(n * kRayGrain, std::min((n + 1) * kRayGrain, count)); });
}

// The method's description with its options, made when first asked for.
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
