// Error margins of walks in float, shared by references and SIMD versions. Within these margins float does not decide.
// Derivations: margins.md.
#pragma once

namespace relief {

// Longest run, in cells, that is walked in float. Flatter rays fall back to the reference in double, because float
// could distinguish too few of their cells.
inline constexpr double kFloatRun = 65536;
// Distance from the origin, in cells, up to which positions are stored as integers.
inline constexpr double kFloatPlaces = 4194304;
// Times 1 + 1 / run: bound of the error of lambda = n * inverse + base in float, which is at most 7 + 4.5 / run units
// of 2^-24 (margins.md).
inline constexpr float kCrossingMargin = 0x1p-21F;
// Shortest run, in cells, of a ray that begins within this distance after a line. For a shorter one, the rounding of
// the start (2^-30 of a cell) may choose the wrong side of the line.
inline constexpr double kLeastRun = 1e-5;
// Largest relative error of an approximate reciprocal: x86 gives eleven bits or more, ARM eight.
#if defined(__x86_64__) || defined(__i386__)
inline constexpr float kReciprocalError = 0x1p-11F;
#else
inline constexpr float kReciprocalError = 0x1p-7F;
#endif
// Factor on slopes, so that a ray meets a cone slightly early. It exceeds the error of an approximate reciprocal and
// all rounding.
inline constexpr float kSteeper = 1 + 2 * kReciprocalError;
// Shortening of jumps, in cells, times run + 1. It exceeds the rounding of the apex, the jump and positions, so that
// the cell found is never too far along the ray.
inline constexpr float kShorterJump = 0x1p-19F;
// Lambda by which walks begin before the first possible hit: more than the rounding of positions (2^-30 of a cell)
// divided by kLeastRun.
inline constexpr double kStartSlack = 0x1p-12;
// Adding this rounds a number below 2^22 to an integer, which is then in the lowest bits of the sum.
inline constexpr float kWhole = 0x1.8p23F;

}  // namespace relief
