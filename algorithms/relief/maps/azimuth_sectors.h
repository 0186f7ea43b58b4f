// Azimuth sectors that contain directions of a rectangle. Sectors: azimuthSector() of distance_map.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace relief {

// A set of sectors, one bit each; at most 32.
using SectorSet = std::uint32_t;
inline constexpr int kMaxSectors = 32;

class AzimuthSectors {
  public:
    explicit AzimuthSectors(int count) : count_(count) {
        for (int k = 0; k <= count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            borders_.push_back({std::cos(angle), std::sin(angle)});
        }
    }

    int count() const { return count_; }
    SectorSet all() const { return count_ >= kMaxSectors ? ~SectorSet{0} : (SectorSet{1} << count_) - 1; }
    double begin(int k) const { return 2 * std::numbers::pi * k / count_; }
    double end(int k) const { return 2 * std::numbers::pi * (k + 1) / count_; }

    // Every sector that contains or touches the direction of a point of [x0, x1] x [y0, y1]. All sectors if the
    // rectangle contains the origin.
    SectorSet meeting(double x0, double x1, double y0, double y1) const {
        if (count_ <= 2 || (x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0)) return all();
        SectorSet set = 0;
        for (int k = 0; k < count_; ++k) {
            if (meets(k, x0, x1, y0, y1)) set |= SectorSet{1} << k;
        }
        return set;
    }

    // Whether sector k is in that set.
    bool meets(int k, double x0, double x1, double y0, double y1) const {
        if (count_ <= 2 || (x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0)) return true;
        // Borders are rounded sines and cosines; a corner this close to a border counts on both sides.
        const double slack = 1e-9 * (std::abs(x0) + std::abs(x1) + std::abs(y0) + std::abs(y1));
        const Border& from = borders_[static_cast<std::size_t>(k)];
        const Border& to = borders_[static_cast<std::size_t>(k) + 1];
        // Two fast tests decide most rectangles: entirely beyond a border, or the centre between both borders.
        const auto most = [&](double a, double b) { return std::max(a * x0, a * x1) + std::max(b * y0, b * y1); };
        if (most(-from.y, from.x) + slack < 0 || most(to.y, -to.x) + slack < 0) return false;
        const Border middle{0.5 * (x0 + x1), 0.5 * (y0 + y1)};
        if (from.x * middle.y > from.y * middle.x && middle.x * to.y > middle.y * to.x) return true;
        // Corners in order; `after` and `before` are their signed distances to the inner side of both borders.
        const std::array<Border, 4> corners{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
        std::array<double, 4> after{};
        std::array<double, 4> before{};
        for (std::size_t n = 0; n < 4; ++n) {
            after[n] = from.x * corners[n].y - from.y * corners[n].x + slack;
            before[n] = corners[n].x * to.y - corners[n].y * to.x + slack;
        }
        return meets(after, before);
    }

  private:
    struct Border {
        double x;
        double y;
    };

    // Whether a convex polygon contains a point at which both linear functions, given at its corners, are not negative.
    // It is not enough that each is so at some corner, which is also true for a wide rectangle in the opposite sector.
    static bool meets(const std::array<double, 4>& f, const std::array<double, 4>& g) {
        for (std::size_t n = 0; n < 4; ++n) {
            const std::size_t m = (n + 1) % 4;
            if (f[n] >= 0 && g[n] >= 0) return true;
            if ((f[n] >= 0) == (f[m] >= 0)) continue;
            const double share = f[n] / (f[n] - f[m]);
            if (g[n] + share * (g[m] - g[n]) >= 0) return true;
        }
        return false;
    }

    int count_;
    std::vector<Border> borders_;
};

}  // namespace relief
