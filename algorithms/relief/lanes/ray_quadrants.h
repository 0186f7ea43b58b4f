// Rays of a chunk by the quadrant of their direction.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "relief/lanes/lane_rays.h"

namespace relief {

// Bit 0: the run in x is negative, bit 1: that in y.
inline constexpr std::size_t kQuadrants = 4;

// Whole vectors of doubles are written behind a part's last ray: no other ray is there.
inline constexpr std::size_t kQuadrantGap = 8;

// The rays [begin[q], end[q]) are of quadrant q.
struct QuadrantParts {
    std::array<std::size_t, kQuadrants> begin{}, end{};
};

static_assert(kLaneSlots >= kLaneChunk + kQuadrants * (kQuadrantGap + 16) + 16);

// A chunk whose rays are not of one quadrant, put in order.
struct QuadrantOrder {
    QuadrantParts parts;
    alignas(64) std::array<std::array<double, kLaneSlots>, 4> columns;  // s0, t0, a, b
    alignas(64) std::array<std::int32_t, kLaneSlots> from;              // which ray of the chunk it was
};

}  // namespace relief
