// Which azimuth sectors a rectangle of directions meets. Sectors: azimuthSector() of distance_map.h.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace relief {

// Sets of sectors as bits; at most 32 of them.
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

    // Every sector that holds the direction of a point of [x0, x1] x [y0, y1], and perhaps a neighbour: all, if the
    // rectangle holds the origin.
    SectorSet meeting(double x0, double x1, double y0, double y1) const {
        if (count_ <= 2 || (x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0)) return all();
        // Borders are sines and cosines rounded; a corner this near a border counts on both sides.
        const double slack = 1e-9 * (std::abs(x0) + std::abs(x1) + std::abs(y0) + std::abs(y1));
        SectorSet set = 0;
        for (int k = 0; k < count_; ++k) {
            const Border& from = borders_[static_cast<std::size_t>(k)];
            const Border& to = borders_[static_cast<std::size_t>(k) + 1];
            bool afterFrom = false;
            bool beforeTo = false;
            for (const double x : {x0, x1}) {
                for (const double y : {y0, y1}) {
                    afterFrom = afterFrom || from.x * y - from.y * x >= -slack;
                    beforeTo = beforeTo || x * to.y - y * to.x >= -slack;
                }
            }
            if (afterFrom && beforeTo) set |= SectorSet{1} << k;
        }
        return set;
    }

  private:
    struct Border {
        double x;
        double y;
    };
    int count_;
    std::vector<Border> borders_;
};

}  // namespace relief
