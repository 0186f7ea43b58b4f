// Which pixels of a frame are worth looking at first: where its method is farthest from exact, works hardest, goes past
// the surface, or disagrees with another method.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rendering/error_layer.h"

namespace relief {

// Error: the farthest from the exact hit (hits only). Steps: the most steps. Overshoot: the farthest behind the exact
// hit; a ray that misses the surface altogether before all. Disagreement: the farthest from another method's hit.
enum class Worth : std::uint8_t { Error, Steps, Overshoot, Disagreement };
inline constexpr std::array<std::string_view, 4> kWorthNames{"error", "steps", "overshoot", "disagreement"};

struct PixelWorth {
    int x = 0;
    int y = 0;
    double value = 0;  // texels or steps; infinite where the outcomes differ
    bool operator==(const PixelWorth&) const = default;
};

// The pixels of largest value, largest first, no two of them closer than `apart` pixels in x and in y; values that are
// 0, negative or NaN are not worth it. values: rows top-down. Of equal values the upper left one comes first.
std::vector<PixelWorth> largestApart(const std::vector<float>& values, int width, int apart, std::size_t most);

// What the kinds rank by, pixel by pixel. errorWorth: Error and Overshoot, of the frame's own error layer. The others
// trace the frame's rays once more, by the tracer of the frame, counting, or by another one. Throw Cancelled.
std::vector<float> errorWorth(Worth worth, const Frame& frame, const ErrorLayer& errors);
std::vector<float> stepWorth(const Frame& frame, const Tracer& tracer, Work& work);
// Distance between the frame's hits and those of the other tracer, texels.
std::vector<float> disagreement(const Frame& frame, const Tracer& other, Work& work);

}  // namespace relief
