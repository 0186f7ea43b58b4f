// The data of a chunk of rays in SIMD walks. SIMD only excludes cells, in float with margins that cover its rounding.
// The leaf decides hits in double, and the reference handles what the margins cannot decide. So hits have the same bits
// as those of the reference for any instruction set.
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
// Length of a chunk's columns, padded so that a whole vector may be loaded from any ray on, and that parts of a chunk
// may be padded to whole vectors.
inline constexpr std::size_t kLaneSlots = kLaneChunk + 112;

// For every byte, the indices of its set bits, packed to the front: to compact lanes where vectors have at most eight.
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

// Result of a ray's SIMD walk. Scalar: float cannot walk the ray, the reference traces it. FalseCandidate: no hit in
// the candidate cell, resume in the next. Ambiguous: near a corner or an end of the map float precision cannot choose
// the next cell; fall back to the reference.
enum class LaneEnd : std::int32_t { Candidate, Miss, Scalar, FalseCandidate, Ambiguous };

// One axis of the rays of a chunk.
struct LaneAxisRays {
    // Set up from the rays. first: cell of the start, mirrored, before addressing is applied.
    alignas(64) std::array<std::int32_t, kLaneSlots> first;
    alignas(64) std::array<std::int32_t, kLaneSlots> cell;  // the same with addressing applied
    alignas(64) std::array<float, kLaneSlots> inverse, base;
    alignas(64) std::array<float, kLaneSlots> run;  // signed; negative runs are mirrored
    alignas(64) std::array<float, kLaneSlots> rim;  // border: lambda at which the ray leaves the map
    // Of the candidate: its cell within the period, the first cell of its period under repeat, and its distance from
    // `first` (cones: in cells of the map).
    alignas(64) std::array<std::int32_t, kLaneSlots> hitCell, hitPeriod, hitPlace;
};

// Doubles per cache line.
inline constexpr std::size_t kLineOfDoubles = 8;
// Number of rays that begin their walks together.
inline constexpr std::size_t kLaneGroup = 16;

// The rays of a chunk; about 100 KiB, reused for all chunks of a thread.
struct LaneRays {
    LaneAxisRays x, y;
    std::array<double, kLaneSlots / kLaneGroup + 1> start;  // lambda at which a group begins; no hit lies before it
    alignas(64) std::array<float, kLaneSlots> begin;        // the same for each ray
    alignas(64) std::array<float, kLaneSlots> tie;
    alignas(64) std::array<std::int32_t, kLaneSlots> end;     // a LaneEnd; Candidate while the ray is walked
    alignas(64) std::array<std::int32_t, kLaneSlots> within;  // for resumed rays: 1 in their cell, 0 after it
    std::size_t count = 0;
    std::size_t behind = 0;  // number of rays of the block that follow the chunk
    // The rays of the chunk that are not hits, by their index in it, and their results.
    struct Other {
        std::uint32_t ray;
        LaneEnd end;
    };
    std::array<Other, kLaneSlots> others;
    std::size_t othersCount = 0;
};

// Divides the rays [first, last) into chunks and calls kernel(begin, end, scratch) for each. Sets misses, and calls
// rest(begin, scratch) if rays remain that the kernel could not finish.
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
