// A chunk of rays as the lanes walk it. The lanes only exclude cells, in float with margins that cover its rounding;
// where a ray meets its cell is decided by the one leaf, in double; whatever the margins cannot decide is left to the
// reference. So hits have the bits of the reference for any instruction set.
//
// Frame of the walk: cells of cell_grid.h, mirrored so that every ray runs towards larger indices, n counted in cells
// from the one in which the walk begins. The ray crosses line n at lambda = n * inverse + base; base holds a margin, so
// that this is at or after the true crossing, and by no more than `tie` on both axes together.
#pragma once

#include <array>
#include <cstdint>

#include "relief/cell_grid.h"
#include "relief/maps/packed_cones.h"
#include "relief/step_log.h"

namespace relief {

inline constexpr std::size_t kLaneChunk = 1024;
// Columns of a chunk: a whole vector may be loaded from any of its rays on, and parts of it begin a vector.
inline constexpr std::size_t kLaneSlots = kLaneChunk + 112;
// Flatter rays are left to the reference: float would separate too few of their cells.
inline constexpr double kLaneRun = 65536;
// Cells from the origin within which positions are held as integers.
inline constexpr double kLanePlaces = 4194304;
// Times 1 + 1 / run, a bound of the error of lambda = n * inverse + base in float: at most 7 + 4.5 / run units of 2^-24
// (margins.md).
inline constexpr float kCrossingMargin = 0x1p-21F;
// Least run, in cells, of rays that begin less than this past a line: below it, rounding of the start (2^-30 of a cell)
// may choose the wrong side.
inline constexpr double kLeastRun = 1e-5;
// Relative error of an approximate reciprocal, at most: x86 has eleven bits or more, ARM eight.
#if defined(__x86_64__) || defined(__i386__)
inline constexpr float kReciprocalError = 0x1p-11F;
#else
inline constexpr float kReciprocalError = 0x1p-7F;
#endif
// Cones met a little early: more than the error of an approximate reciprocal and all rounding.
inline constexpr float kSteeper = 1 + 2 * kReciprocalError;
// Jumps end so early, in cells, times run + 1: what the apex, the jump and places are rounded by. So the cell that is
// found is not too far on.
inline constexpr float kShorterJump = 0x1p-19F;
// Numbers below 2^22 added to it are rounded to whole ones, its last bits.
inline constexpr float kWhole = 0x1.8p23F;
// A word's depth of the apex, bits 10 to 19, under the bits of this number is a float: the depth and this.
inline constexpr float kApexMore = 0x1p13F;
// Lambda by which walks begin before the first place that may be hit: more than the rounding of places (2^-30 of a
// cell) over kLeastRun.
inline constexpr double kStartSlack = 0x1p-12;

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
enum class LaneEnd : std::int32_t { Candidate, Miss, Scalar, Refused, Unclear };

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

// What the lanes walk over; pointers are not owned.
struct LaneScene {
    const float* heights = nullptr;
    std::int32_t stride = 0;
    const float* nodes =
        nullptr;  // the four of a cell in one place (PackedCones); null: they are read from the heights
    std::int32_t nodeStride = 0;
    CellGrid grid;
    Surface surface{};
    Address address{};
    std::int32_t mirror = 1;  // cell i is mirrored to mirror - 1 - i; at least the cells of either axis
    double start = 0;         // lambda at which walks begin: nothing is as high

    LaneScene() = default;
    LaneScene(const HeightField& field, double highest, std::int32_t mirrored)
        : heights(field.heights().data()),
          stride(field.width()),
          grid(field),
          surface(field.surface()),
          address(field.address()),
          mirror(mirrored) {
        start = std::max(0.0, 1 - highest - kStartSlack);
    }
    LaneScene(const HeightField& field, const PackedCones& cones)
        : LaneScene(field, cones.highest, std::max(cones.nx, cones.ny)) {
        if (cones.nodes.empty()) return;
        nodes = cones.nodes.data();
        nodeStride = cones.stride;
    }
};

// Without lanes: the tracer's reference, ray after ray.
template <class T>
void traceOneByOne(const T& tracer, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) {
    NullSink sink;
    for (std::size_t i = first; i < last; ++i) hits.set(i, tracer.trace(rays[i], sink));
}

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
// The same; the rays it cannot finish, by the tracer's reference.
template <class T, class Kernel>
void traceInLanes(const T& tracer, const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
                  const Kernel& kernel) {
    traceChunks(first, last, hits, kernel, [&](std::size_t begin, const LaneRays& scratch) {
        NullSink sink;
        for (std::size_t n = 0; n < scratch.othersCount; ++n) {
            const std::size_t i = begin + scratch.others[n].ray;
            if (scratch.others[n].end != LaneEnd::Miss) hits.set(i, tracer.trace(rays[i], sink));
        }
    });
}

}  // namespace relief
