// The log of a walk in double that continues where one in float stopped.
#pragma once

#include <algorithm>
#include <cstdint>

#include "relief/step_log.h"

namespace relief {

// Passes steps on with their lambdas clamped to [from, to]; a hit is raised to `from` but not lowered to `to`.
template <class Sink>
struct StepsWithin {
    Sink& sink;
    double from, to;

    template <class Make>
    void step(const Make& make) {
        sink.step([&] {
            Step step = make();
            for (double* lambda : {&step.lambdaIn, &step.lambdaOut, &step.lambdaAfter}) {
                *lambda = std::max(*lambda, from);
            }
            if (step.decision != Decision::Hit) {
                step.lambdaOut = std::min(step.lambdaOut, to);
                step.lambdaAfter = std::min(step.lambdaAfter, to);
            }
            return step;
        });
    }
    void read(std::uint32_t values) { sink.read(values); }
};

}  // namespace relief
