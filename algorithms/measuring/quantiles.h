// Medians and relative spreads of repeated measurements.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace relief {

// Returns the quantile with linear interpolation between values; share in [0, 1], at least one value.
inline double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double at = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

// Returns the middle value, the larger one of two, in linear time; at least one value.
inline double upperMedian(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Returns (p75 - p25) / median.
inline double relativeSpread(const std::vector<double>& values) {
    return (quantile(values, 0.75) - quantile(values, 0.25)) / quantile(values, 0.5);
}

}  // namespace relief
