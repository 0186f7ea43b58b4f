// What both lists of methods (tracers, any-hit queries) need: blocks of rays cut into pieces that run in parallel, and
// descriptions made once.
#pragma once

#include <algorithm>
#include <cstddef>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include "relief/describe.h"
#include "work.h"

namespace relief {

// Rays traced between two looks at the stop token.
inline constexpr std::size_t kRayGrain = 1024;

// body(first, last) over [0, count) in the work's arena; throws Cancelled.
template <class Body>
void overBlock(std::size_t count, Work& work, const Body& body) {
    const auto range = [&](const tbb::blocked_range<std::size_t>& r) {
        if (work.stopped()) return;
        body(r.begin(), r.end());
    };
    if (count <= kRayGrain) {
        range({0, count});
    } else {
        // Cut at multiples of the grain: lanes and packets keep the rays together that came together.
        const std::size_t grains = (count + kRayGrain - 1) / kRayGrain;
        work.arena().execute([&] {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grains), [&](const auto& r) {
                for (std::size_t n = r.begin(); n < r.end(); ++n) {
                    range({n * kRayGrain, std::min((n + 1) * kRayGrain, count)});
                }
            });
        });
    }
    work.throwIfStopped();
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
