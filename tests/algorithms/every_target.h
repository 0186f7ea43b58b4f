// Selects the instruction sets of this machine in turn (mapping/rows/row_lanes.h): all SIMD versions must agree with
// their references.
#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "mapping/rows/row_lanes.h"

namespace relief::test {

// SIMD versions use this instruction set during the object's lifetime, and afterwards the best one again.
class ForcedTarget {
  public:
    explicit ForcedTarget(std::int64_t target) { forceLaneTarget(target); }
    ~ForcedTarget() { forceLaneTarget(0); }
    ForcedTarget(const ForcedTarget&) = delete;
    ForcedTarget& operator=(const ForcedTarget&) = delete;
};

template <class Body>
void onEveryTarget(const Body& body) {
    for (const std::int64_t target : laneTargets()) {
        SCOPED_TRACE(laneTargetName(target));
        const ForcedTarget forced(target);
        body();
    }
}

}  // namespace relief::test
