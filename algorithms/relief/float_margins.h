// The margins of walks in float, for references and SIMD versions alike: what lies within them is not decided in float
// (margins.md).
#pragma once

namespace relief {

// Flatter rays are left to the reference: float would separate too few of their cells.
inline constexpr double kFloatRun = 65536;
// Cells from the origin within which positions are held as integers.
inline constexpr double kFloatPlaces = 4194304;
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
// Lambda by which walks begin before the first place that may be hit: more than the rounding of places (2^-30 of a
// cell) over kLeastRun.
inline constexpr double kStartSlack = 0x1p-12;
// Numbers below 2^22 added to it are rounded to whole ones, its last bits.
inline constexpr float kWhole = 0x1.8p23F;

}  // namespace relief
