// What lies outside a picture, in one place: repeat, clamp, border.
#pragma once

#include <algorithm>
#include <cassert>
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

}  // namespace relief
