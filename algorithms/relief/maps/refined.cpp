#include "relief/maps/refined.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include "relief/maps/azimuth_sectors.h"
#include "relief/maps/range_minimum.h"

namespace relief {

namespace {

// Gates are used in sectors over which they are crossed at no flatter an angle than this (cosine).
constexpr double kLeastCosine = 0.4;
// Cells beyond are not looked at: the bound is cut there, which is safe.
constexpr int kLargestRadius = 64;
// Rounding of slopes and roots in double stays far below this share.
constexpr double kShorter = 1 - 1e-9;

FloatImage transposed(const FloatImage& image) {
    FloatImage turned(image.height(), image.width());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) turned(y, x) = image(x, y);
    }
    return turned;
}

// What gates perpendicular to one axis know: along that axis the gate's number, across it the heights on it.
struct GateAxis {
    const GridAxis& along;
    const GridAxis& across;
    RangeMinimum heights;  // line: texel number along; place: texel number across
    bool nodes;            // bilinear: heights at nodes on the line; columns: of the column beyond it

    // The least height that a ray crossing line `gate` between lo and hi (cell coordinates) must be above; `towards`:
    // the sign of the way it comes from. Nothing outside the picture.
    std::optional<float> least(int gate, int towards, double lo, double hi) const {
        const bool wraps = along.wraps;
        const int offset = !wraps && nodes ? 1 : 0;  // node i lies on line i + 1 under clamp and border
        int line = nodes ? gate - offset : (towards < 0 ? gate - 1 : gate);
        if (wraps) {
            line = ((line % along.texels) + along.texels) % along.texels;
        } else {
            if (line < 0 || line >= along.texels) return std::nullopt;
            lo = std::max(lo, across.low);
            hi = std::min(hi, across.high);
            if (!(lo <= hi)) return std::nullopt;
        }
        auto first = static_cast<int>(std::floor(lo)) - offset;
        auto last = static_cast<int>(nodes ? std::ceil(hi) : std::floor(hi)) - offset;
        if (wraps) {
            last -= first;
            first = ((first % across.texels) + across.texels) % across.texels;
            last += first;
        } else {
            first = std::clamp(first, 0, across.texels - 1);
            last = std::clamp(last, first, across.texels - 1);
        }
        return heights.least(line, first, last);
    }
};

// A gate that matters: its least height (in the metric) and the longest way to it.
struct Gate {
    double g;
    double tau;
};

struct Span {
    double low;
    double high;
};

// Gates of one axis behind a box, in one sector: highest and nearest first kept.
void collectGates(const GateAxis& axis, Span box, Span boxAcross, double cosBegin, double sinBegin, double cosEnd,
                  double sinEnd, double slab, double reach, std::vector<Gate>& gates) {
    if (cosBegin * cosEnd <= 0) return;
    const double leastCosine = std::min(std::abs(cosBegin), std::abs(cosEnd));
    if (leastCosine < kLeastCosine) return;
    const int towards = cosBegin > 0 ? -1 : 1;  // the way back
    const double slopeA = -sinBegin / std::abs(cosBegin);
    const double slopeB = -sinEnd / std::abs(cosEnd);
    const double lowest = std::min(slopeA, slopeB);
    const double highest = std::max(slopeA, slopeB);
    const int first = static_cast<int>(towards < 0 ? box.low : box.high);
    double best = 0;
    for (int n = 0;; ++n) {
        const int gate = first + towards * n;
        const double d0 = n;
        const double d1 = n + (box.high - box.low);
        const double tau = d1 / leastCosine;
        if (tau > reach) return;
        const double lo = boxAcross.low + std::min(d0 * lowest, d1 * lowest);
        const double hi = boxAcross.high + std::max(d0 * highest, d1 * highest);
        const auto least = axis.least(gate, towards, lo, hi);
        if (!least) return;
        const double g = static_cast<double>(*least) * slab;
        if (g <= best) continue;
        best = g;
        gates.push_back({g, tau});
    }
}

// A cell near a box: how far, and in which sectors it can be seen.
struct Offset {
    int dx;
    int dy;
    double t;
    SectorSet sectors;
};

std::vector<Offset> offsetsAround(int footprint, int radius, const AzimuthSectors& sectors) {
    std::vector<Offset> offsets;
    const auto gap = [&](int d) { return std::max({0, d - footprint, -(d + 1)}); };
    for (int dy = -radius; dy < footprint + radius; ++dy) {
        for (int dx = -radius; dx < footprint + radius; ++dx) {
            const double t = std::hypot(gap(dx), gap(dy));
            if (t > radius) continue;
            offsets.push_back({dx, dy, t, sectors.meeting(dx - footprint, dx + 1, dy - footprint, dy + 1)});
        }
    }
    std::stable_sort(offsets.begin(), offsets.end(), [](const Offset& p, const Offset& q) { return p.t < q.t; });
    return offsets;
}

class Builder {
  public:
    Builder(const DistanceMap& map, int nx, int ny, const HeightField& field, const CellHeights& cells,
            std::vector<float>& values)
        : map_(map),
          nx_(nx),
          ny_(ny),
          cells_(cells),
          values_(values),
          grid_(field),
          sectors_(map.parameters.horizons),
          radius_(std::min(kLargestRadius, static_cast<int>(std::ceil(map.slabTexels)) + 1)),
          offsets_(offsetsAround(map.parameters.footprint, radius_, sectors_)),
          mMin_(std::tan(map.parameters.flattest * std::numbers::pi / 180)),
          gatesX_{grid_.x, grid_.y, RangeMinimum(transposed(field.heights()), grid_.y.wraps),
                  field.surface() == Surface::Bilinear},
          gatesY_{grid_.y, grid_.x, RangeMinimum(field.heights(), grid_.x.wraps),
                  field.surface() == Surface::Bilinear} {
        groups_.resize(static_cast<std::size_t>(map.parameters.sectors));
        for (int k = 0; k < sectors_.count(); ++k) {
            groups_[static_cast<std::size_t>(k * map.parameters.sectors / sectors_.count())] |= SectorSet{1} << k;
        }
    }

    double cap() const { return radius_ * std::sqrt(1 + mMin_ * mMin_); }

    struct Scratch {
        std::vector<std::vector<Gate>> gates;
        std::vector<double> slopes;
        std::vector<double> best;
    };

    void row(int by, Scratch& scratch) const {
        for (int bx = 0; bx < nx_; ++bx) box(bx, by, scratch);
    }

  private:
    void box(int bx, int by, Scratch& scratch) const;
    void horizons(int bx, int by, std::vector<std::vector<Gate>>& gates) const;
    void distances(int bx, int by, double z0, Scratch& scratch) const;
    float& value(int bx, int by, int k, int sector) const {
        const auto plane = static_cast<std::size_t>(sector * map_.layers() + k);
        return values_[(plane * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(by)) *
                           static_cast<std::size_t>(nx_) +
                       static_cast<std::size_t>(bx)];
    }

    const DistanceMap& map_;
    int nx_;
    int ny_;
    const CellHeights& cells_;
    std::vector<float>& values_;
    CellGrid grid_;
    AzimuthSectors sectors_;
    int radius_;
    std::vector<Offset> offsets_;
    double mMin_;
    GateAxis gatesX_;
    GateAxis gatesY_;
    std::vector<SectorSet> groups_;  // horizon sectors of each stored sector
};

void Builder::horizons(int bx, int by, std::vector<std::vector<Gate>>& gates) const {
    const int f = map_.parameters.footprint;
    // A clipped footprint is treated as if it were whole: a larger box has the smaller bound.
    const Span x{static_cast<double>(bx * f), static_cast<double>((bx + 1) * f)};
    const Span y{static_cast<double>(by * f), static_cast<double>((by + 1) * f)};
    const double reach = map_.maxRun;
    gates.resize(static_cast<std::size_t>(sectors_.count()));
    for (int k = 0; k < sectors_.count(); ++k) {
        auto& list = gates[static_cast<std::size_t>(k)];
        list.clear();
        // Between the ends of a sector the tangent is monotone, and the cosine is least at an end.
        const double c0 = std::cos(sectors_.begin(k));
        const double s0 = std::sin(sectors_.begin(k));
        const double c1 = std::cos(sectors_.end(k));
        const double s1 = std::sin(sectors_.end(k));
        collectGates(gatesX_, x, y, c0, s0, c1, s1, map_.slabTexels, reach, list);
        collectGates(gatesY_, y, x, s0, c0, s1, c1, map_.slabTexels, reach, list);
    }
}

void Builder::distances(int bx, int by, double z0, Scratch& scratch) const {
    const int f = map_.parameters.footprint;
    const double steepLeast = *std::min_element(scratch.slopes.begin(), scratch.slopes.end());
    const double perT = std::sqrt(1 + steepLeast * steepLeast);
    scratch.best.assign(static_cast<std::size_t>(map_.parameters.sectors), radius_ * perT);
    double worst = radius_ * perT;
    const auto place = [](const GridAxis& axis, int cell) {
        if (!axis.wraps) return cell >= 0 && cell < axis.cells ? cell : -1;
        const int rest = cell % axis.cells;
        return rest < 0 ? rest + axis.cells : rest;
    };
    for (const Offset& offset : offsets_) {
        if (offset.t * perT >= worst) break;
        const int x = place(grid_.x, bx * f + offset.dx);
        const int y = place(grid_.y, by * f + offset.dy);
        if (x < 0 || y < 0) continue;
        const double drop = std::max(z0 - static_cast<double>(cells_.highest(x, y)), 0.0) * map_.slabTexels;
        for (std::size_t s = 0; s < scratch.best.size(); ++s) {
            double slope = std::numeric_limits<double>::infinity();
            for (SectorSet seen = offset.sectors & groups_[s]; seen != 0; seen &= seen - 1) {
                slope = std::min(slope, scratch.slopes[static_cast<std::size_t>(std::countr_zero(seen))]);
            }
            if (std::isinf(slope)) continue;
            const double fall = std::max(drop, offset.t * slope);
            scratch.best[s] = std::min(scratch.best[s], std::sqrt(offset.t * offset.t + fall * fall));
        }
        worst = *std::max_element(scratch.best.begin(), scratch.best.end());
    }
}

void Builder::box(int bx, int by, Scratch& scratch) const {
    const int layers = map_.layers();
    const int stored = map_.parameters.sectors;
    horizons(bx, by, scratch.gates);
    scratch.slopes.resize(scratch.gates.size());
    for (int k = 0; k < layers; ++k) {
        const float mark = cells_.mark(bx, by, map_.parameters.footprint, k, layers);
        if (mark < 0) {
            for (int s = 0; s < stored; ++s) value(bx, by, k, s) = mark;
            continue;
        }
        const double z0 = static_cast<double>(k) / layers;
        const double z1 = static_cast<double>(k + 1) / layers * map_.slabTexels;
        for (std::size_t q = 0; q < scratch.gates.size(); ++q) {
            double slope = mMin_;
            for (const Gate& gate : scratch.gates[q]) slope = std::max(slope, (gate.g - z1) / gate.tau);
            scratch.slopes[q] = slope;
        }
        distances(bx, by, z0, scratch);
        for (int s = 0; s < stored; ++s) {
            // Rounded down: float has 24 bits, the share taken off is larger than their rounding.
            constexpr float kFloatShorter = 1 - 1.2e-7F;
            value(bx, by, k, s) =
                static_cast<float>(scratch.best[static_cast<std::size_t>(s)] * kShorter) * kFloatShorter;
        }
    }
}

}  // namespace

void refinedConservative(DistanceMap& map, int nx, int ny, const HeightField& field, const CellHeights& cells,
                         std::vector<float>& values, Work& work) {
    const Builder builder(map, nx, ny, field, cells, values);
    map.cap = builder.cap();
    tbb::enumerable_thread_specific<Builder::Scratch> scratch;
    work.progress().begin("map refined", ny);
    work.arena().execute([&] {
        tbb::parallel_for(0, ny, [&](int by) {
            if (work.stopped()) return;
            builder.row(by, scratch.local());
            work.progress().advance();
        });
    });
    work.throwIfStopped();
}

}  // namespace relief
