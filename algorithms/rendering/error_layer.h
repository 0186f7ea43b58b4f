// How far a frame's hits are from the exact tracer's: what an approximate method got wrong, pixel by pixel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rendering/frame.h"

namespace relief {

// None: no polygon covers the pixel. Right: the same lambda, or both miss. Short, Past: a hit before or behind the
// exact one (an overshoot). Wrong: hit, miss or step limit where the exact tracer answers otherwise.
enum class ErrorKind : std::uint8_t { None, Right, Short, Past, Wrong };
inline constexpr std::size_t kErrorKinds = 5;

// Of every pixel, rows top-down. texels: |lambda - exact lambda| max(1, hypot(a, b)), the way along the ray that is
// wrong, at least the descent itself; infinite where the outcome is wrong, NaN where there is no polygon.
struct ErrorLayer {
    std::vector<float> texels;
    std::vector<ErrorKind> kinds;
    std::array<std::int64_t, kErrorKinds> counts{};
    double largest = 0;  // of the finite ones
};

// Traces the frame's rays once more, by an exact tracer whose map comes from the cache. Throws Cancelled.
ErrorLayer errorAgainstExact(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work);

}  // namespace relief
