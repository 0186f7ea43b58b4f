// Texture addressing: which texel stands for an index outside the picture (repeat, clamp, border).
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace relief {

enum class Address : std::uint8_t { Repeat, Clamp, Border };

// Returns i modulo size, in [0, size), also for negative i. size > 0.
constexpr std::int64_t wrapIndex(std::int64_t i, std::int64_t size) {
    assert(size > 0);
    const std::int64_t m = i % size;
    return m < 0 ? m + size : m;
}

// Returns the texel, in [0, size), that stands for index i. Border addressing clamps as well: the caller, who knows the
// domain, decides what is outside it, and within half a texel of its edge interpolation uses clamped texels.
constexpr int addressIndex(std::int64_t i, int size, Address address) {
    if (address == Address::Repeat) return static_cast<int>(wrapIndex(i, size));
    return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
}

// The two texels between whose centres a coordinate lies, and the weight of the second one, in [0, 1).
struct BilinearSupport {
    int first = 0;
    int second = 0;
    float share = 0;
};

// Returns the support of x (texels, not wrapped) on an axis of `size` texels.
inline BilinearSupport bilinearSupport(double x, int size, Address address) {
    // Reduced to one period first, which preserves the precision of coordinates far from the origin.
    const double reduced = address == Address::Repeat ? std::fmod(x, size) : std::clamp(x, -1.0, size + 1.0);
    const double whole = std::floor(reduced - 0.5);
    const auto index = static_cast<std::int64_t>(whole);
    return {addressIndex(index, size, address), addressIndex(index + 1, size, address),
            static_cast<float>(reduced - 0.5 - whole)};
}

}  // namespace relief
