// Finds the pixels of a frame that are most worth examining: where its method has the largest error, takes the most
// steps, passes through the surface, or disagrees with another method.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rendering/error_layer.h"

namespace relief {

// Error: largest distance from the exact hit (hits only). Steps: most steps. Overshoot: largest distance behind the
// exact hit; rays that miss the surface altogether come first. Disagreement: largest distance from another method's
// hit.
enum class Worth : std::uint8_t { Error, Steps, Overshoot, Disagreement };
inline constexpr std::array<std::string_view, 4> kWorthNames{"error", "steps", "overshoot", "disagreement"};

struct PixelWorth {
    int x = 0;
    int y = 0;
    double value = 0;  // texels or steps; infinite if the outcomes differ
    bool operator==(const PixelWorth&) const = default;
};

// Returns at most `most` pixels of largest value, largest first, no two of them closer than `apart` pixels in both x
// and y. Values that are 0, negative or NaN are ignored. values: rows top-down, `width` per row. Of equal values the
// upper left one comes first.
std::vector<PixelWorth> largestApart(const std::vector<float>& values, int width, int apart, std::size_t most);

// Returns the ranking value of every pixel. errorWorth: for Error and Overshoot, from the frame's error layer. The
// other functions trace the frame's rays again, with the frame's tracer (counting steps) or with another one; they
// throw Cancelled.
std::vector<float> errorWorth(Worth worth, const Frame& frame, const ErrorLayer& errors);
std::vector<float> stepWorth(const Frame& frame, const Tracer& tracer, Work& work);
// Distance between the frame's hits and those of the other tracer, texels.
std::vector<float> disagreement(const Frame& frame, const Tracer& other, Work& work);

}  // namespace relief
