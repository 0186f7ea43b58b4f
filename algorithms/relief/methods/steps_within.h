// The log of a walk in double that goes on where one in float stopped.
#pragma once

#include <algorithm>
#include <cstdint>

#include "relief/step_log.h"

namespace relief {

// Steps that begin a little before lambda `from` and lead beyond `to`, cut to [from, to]; a hit keeps its lambda.
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
