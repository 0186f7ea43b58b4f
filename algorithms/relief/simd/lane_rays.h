// A chunk of rays as the lanes walk it. The lanes only exclude cells, in float with margins that cover its rounding;
// where a ray meets its cell is decided by the one leaf, in double; whatever the margins cannot decide is left to the
// reference. So hits have the bits of the reference for any instruction set.
//
// Frame: methods/float_scene.h.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "relief/methods/float_scene.h"
#include "relief/ray.h"

namespace relief {

inline constexpr std::size_t kLaneChunk = 1024;
// Columns of a chunk: a whole vector may be loaded from any of its rays on, and parts of it begin a vector.
inline constexpr std::size_t kLaneSlots = kLaneChunk + 112;

// The numbers of the bits that are set, in front, for all bytes: to pack lanes where vectors are of eight at most.
inline constexpr auto kPackedLanes = [] {
    std::array<std::array<std::uint8_t, 8>, 256> all{};
    for (std::size_t bits = 0; bits < all.size(); ++bits) {
        std::size_t count = 0;
        for (std::uint8_t k = 0; k < 8; ++k) {
            if ((bits >> k & 1U) != 0) all[bits][count++] = k;
        }
    }
    return all;
}();

// What becomes of a ray in lanes. Refused: the candidate is no hit, it goes on behind its cell. Unclear: near a corner
// or an end of the map, float does not tell where it goes.
enum class LaneEnd : std::int32_t { Candidate, Miss, Scalar, FalseCandidate, Ambiguous };

struct LaneAxisRays {
    // Set up from the rays.
    alignas(64) std::array<std::int32_t, kLaneSlots> first;  // cell of the start, mirrored, before any addressing
    alignas(64) std::array<std::int32_t, kLaneSlots> cell;   // that cell, addressed
    alignas(64) std::array<float, kLaneSlots> inverse, base;
    alignas(64) std::array<float, kLaneSlots> run;  // with its sign: negative is mirrored
    alignas(64) std::array<float, kLaneSlots> rim;  // border: lambda at which the ray leaves the map
    // Of the candidate: its cell within the period, the first cell of its period where the map repeats, and its
    // distance from `first` (cones: in cells of the map).
    alignas(64) std::array<std::int32_t, kLaneSlots> hitCell, hitPeriod, hitPlace;
};

// Numbers of a line of the cache.
inline constexpr std::size_t kLineOfDoubles = 8;
// Rays that begin their walks together.
inline constexpr std::size_t kLaneGroup = 16;

struct LaneRays {
    LaneAxisRays x, y;
    std::array<double, kLaneSlots / kLaneGroup + 1> start;  // lambda at which a group begins: nothing is hit before
    alignas(64) std::array<float, kLaneSlots> begin;        // the same, a ray
    alignas(64) std::array<float, kLaneSlots> tie;
    alignas(64) std::array<std::int32_t, kLaneSlots> end;     // LaneEnd; Candidate while it is walked
    alignas(64) std::array<std::int32_t, kLaneSlots> within;  // rays that go on: 1 in their cell, 0 behind it
    std::size_t count = 0;
    std::size_t behind = 0;  // rays of the block that follow the chunk
    // Rays of the chunk, by their number in it, that were not hits, and what became of them.
    struct Other {
        std::uint32_t ray;
        LaneEnd end;
    };
    std::array<Other, kLaneSlots> others;
    std::size_t othersCount = 0;
};

// Chunks of the rays [first, last) through kernel(begin, end, scratch); the rays it cannot finish, by rest(begin,
// scratch).
template <class Kernel, class Rest>
void traceChunks(std::size_t first, std::size_t last, HitBlock& hits, const Kernel& kernel, const Rest& rest) {
    static thread_local LaneRays scratch;
    for (std::size_t begin = first; begin < last; begin += kLaneChunk) {
        kernel(begin, std::min(begin + kLaneChunk, last), scratch);
        bool left = false;
        for (std::size_t n = 0; n < scratch.othersCount; ++n) {
            const LaneRays::Other& other = scratch.others[n];
            left = left || other.end != LaneEnd::Miss;
            if (other.end == LaneEnd::Miss) hits.set(begin + other.ray, Hit::none(Outcome::Miss));
        }
        if (left) rest(begin, scratch);
    }
}

}  // namespace relief
