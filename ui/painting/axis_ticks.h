// Round numbers for axes, legends and iso-lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenario/step_sentence.h"

namespace reliefui {

// 1, 2 or 5 times a power of ten, so that at most `most` of them fit into the range.
inline double niceStep(double range, double most) {
    const double rough = range / std::max(most, 1.0);
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough) return factor * power;
    }
    return 10 * power;
}

// With the decimals that the step needs.
inline std::string tickText(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
    return relief::fixedText(value, decimals);
}

// The marks of one axis between two of its values.
inline std::vector<double> ticks(double low, double high, double step) {
    std::vector<double> all;
    constexpr double kMost = 200;
    const double first = std::ceil(low / step - 1e-6);
    for (double n = first; n * step <= high + 1e-6 * step && n - first < kMost; ++n) all.push_back(n * step);
    return all;
}

// "10⁻³".
inline std::string powerOfTen(int n) {
    static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (n == 0) return "1";
    if (n == 1) return "10";
    std::string text = n < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(n))) text += kDigits[digit - '0'];
    return text;
}

}  // namespace reliefui
