// What lies outside a picture, in one place: repeat, clamp, border.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace relief {

enum class Address : std::uint8_t { Repeat, Clamp, Border };

// i modulo size, in [0, size), also for negative i. size > 0.
constexpr std::int64_t wrapIndex(std::int64_t i, std::int64_t size) {
    assert(size > 0);
    const std::int64_t m = i % size;
    return m < 0 ? m + size : m;
}

// The texel that stands for index i. Border clamps, too: what is outside is decided by the caller, who knows the
// domain; the half-texel rim inside it interpolates clamped.
constexpr int addressIndex(std::int64_t i, int size, Address address) {
    if (address == Address::Repeat) return static_cast<int>(wrapIndex(i, size));
    return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
}

// The two texels between whose centres x (texels, unwrapped) lies, and the second one's share, in [0, 1).
struct BilinearSupport {
    int first = 0;
    int second = 0;
    float share = 0;
};

inline BilinearSupport bilinearSupport(double x, int size, Address address) {
    // Reduced first, so that far-off points keep their digits.
    const double reduced = address == Address::Repeat ? std::fmod(x, size) : std::clamp(x, -1.0, size + 1.0);
    const double whole = std::floor(reduced - 0.5);
    const auto index = static_cast<std::int64_t>(whole);
    return {addressIndex(index, size, address), addressIndex(index + 1, size, address),
            static_cast<float>(reduced - 0.5 - whole)};
}

}  // namespace relief
