// What the entry points of SIMD walks over stored maps share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "relief/maps/stored_values.h"

namespace relief {

// Returns true if SIMD can number the values with signed indices of 32 bits.
inline bool fitsLanes(const StoredValues& values) {
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    return values.bytes() / bytesEach(values.precision()) <= kMost;
}
// Returns the indices first to last - 1: all these rays are traced by the reference.
inline std::vector<std::size_t> allRays(std::size_t first, std::size_t last) {
    std::vector<std::size_t> all(last - first);
    std::iota(all.begin(), all.end(), first);
    return all;
}

}  // namespace relief
