// Per-pixel difference between a frame's hits and those of the exact tracer: the errors of an approximate method.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rendering/frame.h"

namespace relief {

// None: no polygon covers the pixel. Right: the same lambda, or both miss. Short, Past: the hit lies before or behind
// the exact one (Past is an overshoot). Wrong: the outcome (hit, miss, step limit) differs from the exact tracer's.
enum class ErrorKind : std::uint8_t { None, Right, Short, Past, Wrong };
inline constexpr std::size_t kErrorKinds = 5;

// One entry per pixel, rows top-down. texels: |lambda - exact lambda| max(1, hypot(a, b)), the error measured along the
// ray, at least the error in depth; infinite if the outcome is wrong, NaN if no polygon covers the pixel.
struct ErrorLayer {
    std::vector<float> texels;
    std::vector<ErrorKind> kinds;
    std::array<std::int64_t, kErrorKinds> counts{};
    double largest = 0;  // largest finite error, texels
};

// Compares the frame's hits with those of an exact tracer, whose map comes from the cache; traces all rays again.
// Throws Cancelled.
ErrorLayer errorAgainstExact(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work);

}  // namespace relief
