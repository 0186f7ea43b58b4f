// Computes the minimum slope of a ray that reaches a box of the slab unobstructed, by plain scans over the heights.
// These are the horizons of the refined map, for its certificate; the geometry is that of relief/maps/refined.h, but
// the implementation is independent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "relief/cell_grid.h"

namespace relief {

// The gates of one box by azimuth sector: least: minimum height that a ray must have passed over, metric texels; way:
// its longest distance from there into the box.
class HorizonGates {
  public:
    struct Gate {
        double least;
        double way;
    };
    std::vector<std::vector<Gate>> sectors;

    // Returns the minimum slope of rays that reach a point no higher than z1 (metric texels).
    double leastSlope(int sector, double z1, double atLeast) const {
        double slope = atLeast;
        for (const Gate& gate : sectors[static_cast<std::size_t>(sector)]) {
            slope = std::max(slope, (gate.least - z1) / gate.way);
        }
        return slope;
    }
};

class HorizonScan {
  public:
    // reach: run of the flattest ray, texels. sectors: 0 disables the scan.
    HorizonScan(const HeightField& field, double slabTexels, double reach, int sectors)
        : field_(field), grid_(field), slab_(slabTexels), reach_(reach), sectors_(sectors) {}

    int sectors() const { return sectors_; }

    // The box consists of the cells [x0, x1) x [y0, y1).
    void collect(int x0, int x1, int y0, int y1, HorizonGates& gates) const {
        gates.sectors.assign(static_cast<std::size_t>(sectors_), {});
        for (int k = 0; k < sectors_; ++k) {
            const double begin = 2 * std::numbers::pi * k / sectors_;
            const double end = 2 * std::numbers::pi * (k + 1) / sectors_;
            auto& list = gates.sectors[static_cast<std::size_t>(k)];
            scan(grid_.x, grid_.y, false, x0, x1, y0, y1, {std::cos(begin), std::cos(end)},
                 {std::sin(begin), std::sin(end)}, list);
            scan(grid_.y, grid_.x, true, y0, y1, x0, x1, {std::sin(begin), std::sin(end)},
                 {std::cos(begin), std::cos(end)}, list);
        }
    }

  private:
    using Pair = std::array<double, 2>;

    // Scans the lines of one axis behind the box. At the two ends of the sector, a ray moves by ahead[n] along the axis
    // and by sideways[n] across it; all rays of the sector lie between.
    void scan(const GridAxis& along, const GridAxis& across, bool turned, int low, int high, int acrossLow,
              int acrossHigh, Pair ahead, Pair sideways, std::vector<HorizonGates::Gate>& list) const {
        // Sectors nearly parallel to the lines are not scanned, because the intervals of crossing points would be too
        // wide to be of use.
        constexpr double kLeastCosine = 0.4;
        const double cosine = std::min(std::abs(ahead[0]), std::abs(ahead[1]));
        if (ahead[0] * ahead[1] <= 0 || cosine < kLeastCosine) return;
        const bool fromBelow = ahead[0] > 0;  // the ray comes from smaller coordinates
        double highest = 0;
        // Lines farther away than the run of the flattest ray require no steeper slope than that ray has.
        for (int n = 0; n + (high - low) <= reach_ * cosine + 1; ++n) {
            const int line = fromBelow ? low - n : high + n;
            // Range of the ray's offset across the axis where it crossed this line, which is between n and
            // n + (high - low) texels behind the ray's points in the box.
            double from = std::numeric_limits<double>::infinity();
            double to = -from;
            for (const double back : {static_cast<double>(n), static_cast<double>(n + high - low)}) {
                for (const std::size_t e : {std::size_t{0}, std::size_t{1}}) {
                    const double off = -back * sideways[e] / std::abs(ahead[e]);
                    from = std::min(from, off);
                    to = std::max(to, off);
                }
            }
            if (!inside(along, line, fromBelow)) return;
            double lo = acrossLow + from;
            double hi = acrossHigh + to;
            if (!across.wraps) {
                lo = std::max(lo, across.low);
                hi = std::min(hi, across.high);
                if (lo > hi) return;
            }
            const double least = leastOn(along, across, turned, line, fromBelow, lo, hi, highest / slab_) * slab_;
            if (!(least > highest)) continue;
            highest = least;
            list.push_back({least, (n + high - low) / cosine});
        }
    }

    // Returns the texel whose heights are on a line: the node on it, or the column beyond it.
    int texelOf(const GridAxis& along, int line, bool fromBelow) const {
        if (field_.surface() == Surface::Columns) return fromBelow ? line - 1 : line;
        return along.wraps ? line : line - 1;
    }
    bool inside(const GridAxis& along, int line, bool fromBelow) const {
        const int texel = texelOf(along, line, fromBelow);
        return along.wraps || (texel >= 0 && texel < along.texels);
    }

    // Returns the minimum height on the line between lo and hi; the scan ends early once the minimum does not exceed
    // `enough`.
    double leastOn(const GridAxis& along, const GridAxis& across, bool turned, int line, bool fromBelow, double lo,
                   double hi, double enough) const {
        const bool nodes = field_.surface() == Surface::Bilinear;
        const int shift = nodes && !across.wraps ? 1 : 0;
        // The ray stays in the box for a finite interval, so it crosses strictly between lo and hi, and nodes or
        // columns that it would only touch there do not count. kEdge exceeds the rounding error of lo and hi, and the
        // error of an interpolated height.
        constexpr double kEdge = 1e-11;
        const auto first = static_cast<std::int64_t>(std::floor(lo + kEdge)) - shift;
        auto last = static_cast<std::int64_t>(std::ceil(hi - kEdge)) - (nodes ? 0 : 1) - shift;
        if (across.wraps) last = std::min<std::int64_t>(last, first + across.texels - 1);
        const int texel = texelOf(along, line, fromBelow);
        double least = std::numeric_limits<double>::infinity();
        for (std::int64_t p = first; p <= last && least > enough; ++p) {
            // Outside the picture, clamped to its edge as the addressing does.
            const std::int64_t q = across.wraps ? p : std::clamp<std::int64_t>(p, 0, across.texels - 1);
            least = std::min(least, static_cast<double>(turned ? field_.texel(q, texel) : field_.texel(texel, q)));
        }
        return nodes ? least - kEdge : least;
    }

    HeightField field_;
    CellGrid grid_;
    double slab_;
    double reach_;
    int sectors_;
};

}  // namespace relief
