#include "mapping/rows/row_planner.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace relief {

namespace {

// The larger of E for u and v on m pixels from pixel n.
double worstError(const Homography& map, double y, const RowSlopes& slopes, std::int64_t n, std::int64_t m) {
    const double q0 = map.denominator(static_cast<double>(n) + 0.5, y);
    const double q1 = map.denominator(static_cast<double>(n + m) + 0.5, y);
    return linearError(std::max(std::abs(slopes.a), std::abs(slopes.b)), map.qx, static_cast<double>(m), q0, q1);
}

// The largest m in [1, most] with good(m), by bisection; good must not turn true again after it is false. Returns 1
// also if good(1) is false.
template <typename Good>
std::int64_t largest(std::int64_t most, const Good& good) {
    std::int64_t low = 1;
    std::int64_t high = most + 1;
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (good(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace

double linearError(double numerator, double stepQ, double length, double q0, double q1) {
    assert(q0 > 0 && q1 > 0);
    const double roots = std::sqrt(q0) + std::sqrt(q1);
    return std::abs(numerator * stepQ) * length * length / (q0 * q1 * roots * roots);
}

AffineError affineError(double ratio) {
    assert(ratio >= 1);
    const double root = std::sqrt(ratio);
    return {(root - 1) / (root + 1), root / (root + 1)};
}

RowSlopes rowSlopes(const Homography& map, double y) {
    return {(map.sx * map.qy - map.sy * map.qx) * y + (map.sx * map.q1 - map.s1 * map.qx),
            (map.tx * map.qy - map.ty * map.qx) * y + (map.tx * map.q1 - map.t1 * map.qx)};
}

std::int64_t longestSpan(const Homography& map, double y, PixelSpan span, double error) {
    assert(error > 0);
    if (span.size() < 2) return 1;
    const RowSlopes slopes = rowSlopes(map, y);
    // E is largest where q is smallest, which is at one end of the row.
    const bool smallestAtEnd = map.qx < 0;
    return largest(span.size() - 1, [&](std::int64_t m) {
        return worstError(map, y, slopes, smallestAtEnd ? span.end - 1 - m : span.begin, m) <= error;
    });
}

}  // namespace relief
