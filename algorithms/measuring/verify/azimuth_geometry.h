// Azimuths of rectangles of direction vectors, and their shortest vectors in azimuth sectors. For certificates:
// independent of the implementation that the map builders use (relief/maps/azimuth_sectors.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace relief {

// The vectors (x, y) with x in [x0, x1], y in [y0, y1].
struct VectorRange {
    double x0, x1, y0, y1;
};

// The interval of azimuths of all vectors in a rectangle, computed from the angles of its corners.
class AzimuthRange {
  public:
    explicit AzimuthRange(const VectorRange& v) {
        const auto [x0, x1, y0, y1] = v;
        if (x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0) return;
        const double middle = std::atan2(y0 + y1, x0 + x1);
        double low = 0;
        double high = 0;
        for (const double x : {x0, x1}) {
            for (const double y : {y0, y1}) {
                const double turn = std::remainder(std::atan2(y, x) - middle, kTurn);
                low = std::min(low, turn);
                high = std::max(high, turn);
            }
        }
        // Much larger than the rounding error of the angles, radians.
        constexpr double kSlack = 1e-12;
        begin_ = middle + low - kSlack;
        span_ = high - low + 2 * kSlack;
    }

    // Returns true if the interval overlaps sector k of n.
    bool meets(int k, int n) const {
        if (n == 1 || span_ >= kTurn) return true;
        const double width = kTurn / n;
        double after = std::fmod(begin_ - k * width, kTurn);
        if (after < 0) after += kTurn;
        return after <= width || after + span_ >= kTurn;
    }

  private:
    static constexpr double kTurn = 2 * std::numbers::pi;
    double begin_ = 0;
    double span_ = kTurn;
};

// Returns the length of the shortest vector of the range in sector k of n (n at least 4), infinity if there is none.
// The sector is widened by more than the rounding error. With byQuadrants (n a multiple of 4), a vector belongs only to
// the quadrant of its signs, as for azimuthSector(), and vectors on an axis are excluded: a ray along an axis only
// touches the cells next to it.
inline double shortestInSector(VectorRange v, int k, int n, bool byQuadrants) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    constexpr double kSlack = 1e-12;
    if (byQuadrants) {
        const int quadrant = 4 * k / n;
        const bool right = quadrant == 0 || quadrant == 3;
        const bool up = quadrant < 2;
        if (right ? !(v.x1 > 0) : !(v.x0 < 0)) return kNone;
        if (up ? !(v.y1 > 0) : !(v.y0 < 0)) return kNone;
        (right ? v.x0 : v.x1) = right ? std::max(v.x0, 0.0) : std::min(v.x1, 0.0);
        (up ? v.y0 : v.y1) = up ? std::max(v.y0, 0.0) : std::min(v.y1, 0.0);
    }
    const double x = std::clamp(0.0, v.x0, v.x1);
    const double y = std::clamp(0.0, v.y0, v.y1);
    if (x == 0 && y == 0) return 0;
    const double begin = 2 * std::numbers::pi * k / n - kSlack;
    const double end = 2 * std::numbers::pi * (k + 1) / n + kSlack;
    double after = std::fmod(std::atan2(y, x) - begin, 2 * std::numbers::pi);
    if (after < 0) after += 2 * std::numbers::pi;
    if (after <= end - begin) return std::hypot(x, y);
    // Rectangle and sector are convex, so otherwise the shortest vector lies on one of the rays that bound the sector.
    double shortest = kNone;
    for (const double angle : {begin, end}) {
        double in = 0;
        double out = kNone;
        const auto between = [&](double component, double low, double high) {
            if (component == 0) {
                if (low > 0 || high < 0) out = -kNone;
                return;
            }
            in = std::max(in, std::min(low / component, high / component));
            out = std::min(out, std::max(low / component, high / component));
        };
        between(std::cos(angle), v.x0, v.x1);
        between(std::sin(angle), v.y0, v.y1);
        if (in <= out) shortest = std::min(shortest, in);
    }
    return shortest;
}

}  // namespace relief
