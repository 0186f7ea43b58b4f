#include "relief/maps/refined.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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

// A horizon sector in which a cell can be seen from a box, the stored sector that it belongs to, and the least way to
// the cell within it.
struct Seen {
    std::uint8_t sector;
    std::uint8_t stored;
    double t2;
};

// A cell near a box: how far, and the sectors in which it can be seen, [firstSeen, endSeen) of the table.
struct Offset {
    int dx;
    int dy;
    double t;
    std::size_t firstSeen;
    std::size_t endSeen;
};

struct Offsets {
    std::vector<Offset> near;  // nearest first
    std::vector<Seen> seen;
};

// How far the directions of a sector reach to one side of an axis for each step: the largest component, 0 if none.
double largestComponent(double begin, double end, bool alongX, int side) {
    const double middle = (alongX ? 0.0 : 0.5 * std::numbers::pi) + (side > 0 ? 0.0 : std::numbers::pi);
    for (const double turn : {0.0, 2 * std::numbers::pi}) {
        if (begin <= middle + turn && middle + turn <= end) return 1;
    }
    return std::max({std::cos(begin - middle), std::cos(end - middle), 0.0});
}

// The least way in the sector to a cell that is `gap` away along the axis on that side; infinite if the sector's
// directions do not go there. exactQuadrants: no direction counts to a sector beyond an axis, not even by rounding.
double wayAlong(int gap, int side, bool alongX, double begin, double end, bool exactQuadrants) {
    constexpr double kAside = 1e-12;  // sectors' ends are rounded
    if (side == 0) return 0;
    const double component = largestComponent(begin, end, alongX, side);
    if (component <= kAside && exactQuadrants) return std::numeric_limits<double>::infinity();
    return gap / (component + kAside);
}

// Around a box of width x height cells.
Offsets offsetsAround(int width, int height, int radius, const AzimuthSectors& sectors, int stored) {
    Offsets all;
    const auto gap = [](int d, int size) { return std::max({0, d - size, -(d + 1)}); };
    const auto side = [](int d, int size) { return d < 0 ? -1 : (d >= size ? 1 : 0); };
    const bool exactQuadrants = sectors.count() % 4 == 0 && (stored == 1 || stored % 4 == 0);
    for (int dy = -radius; dy < height + radius; ++dy) {
        for (int dx = -radius; dx < width + radius; ++dx) {
            const double t = std::hypot(gap(dx, width), gap(dy, height));
            if (t > radius) continue;
            const std::size_t first = all.seen.size();
            const SectorSet set = sectors.meeting(dx - width, dx + 1, dy - height, dy + 1);
            for (int k = 0; k < sectors.count(); ++k) {
                if ((set >> k & 1U) == 0) continue;
                const double way = std::max(
                    {t,
                     wayAlong(gap(dx, width), side(dx, width), true, sectors.begin(k), sectors.end(k), exactQuadrants),
                     wayAlong(gap(dy, height), side(dy, height), false, sectors.begin(k), sectors.end(k),
                              exactQuadrants)});
                if (way > radius) continue;
                all.seen.push_back(
                    {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(k * stored / sectors.count()), way * way});
            }
            all.near.push_back({dx, dy, t, first, all.seen.size()});
        }
    }
    std::stable_sort(all.near.begin(), all.near.end(), [](const Offset& p, const Offset& q) { return p.t < q.t; });
    return all;
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
          mMin_(std::tan(map.parameters.flattest * std::numbers::pi / 180)),
          gatesX_{grid_.x, grid_.y, RangeMinimum(transposed(field.heights()), grid_.y.wraps),
                  field.surface() == Surface::Bilinear},
          gatesY_{grid_.y, grid_.x, RangeMinimum(field.heights(), grid_.x.wraps),
                  field.surface() == Surface::Bilinear} {
        const int f = map.parameters.footprint;
        for (const int height : {f, lastWidth(grid_.y)}) {
            for (const int width : {f, lastWidth(grid_.x)}) {
                offsets_.push_back(offsetsAround(width, height, radius_, sectors_, map.parameters.sectors));
            }
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
    // Cells of the last, clipped, box of an axis.
    int lastWidth(const GridAxis& axis) const { return (axis.cells - 1) % map_.parameters.footprint + 1; }
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
    std::vector<Offsets> offsets_;  // of whole boxes, the last column, the last row, the last of both
    double mMin_;
    GateAxis gatesX_;
    GateAxis gatesY_;
};

void Builder::horizons(int bx, int by, std::vector<std::vector<Gate>>& gates) const {
    const int f = map_.parameters.footprint;
    const Span x{static_cast<double>(bx * f), static_cast<double>(std::min((bx + 1) * f, grid_.x.cells))};
    const Span y{static_cast<double>(by * f), static_cast<double>(std::min((by + 1) * f, grid_.y.cells))};
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
    // Squares.
    const double cut = radius_ * radius_ * perT * perT;
    scratch.best.assign(static_cast<std::size_t>(map_.parameters.sectors), cut);
    double worst = cut;
    const Offsets& offsets = offsets_[(by == ny_ - 1 ? 2U : 0U) + (bx == nx_ - 1 ? 1U : 0U)];
    const auto place = [](const GridAxis& axis, int cell) {
        if (!axis.wraps) return cell >= 0 && cell < axis.cells ? cell : -1;
        const int rest = cell % axis.cells;
        return rest < 0 ? rest + axis.cells : rest;
    };
    for (const Offset& offset : offsets.near) {
        if (offset.t * offset.t * perT * perT >= worst) break;
        const int x = place(grid_.x, bx * f + offset.dx);
        const int y = place(grid_.y, by * f + offset.dy);
        if (x < 0 || y < 0) continue;
        const double drop = std::max(z0 - static_cast<double>(cells_.highest(x, y)), 0.0) * map_.slabTexels;
        for (std::size_t n = offset.firstSeen; n < offset.endSeen; ++n) {
            const Seen& seen = offsets.seen[n];
            const double slope = scratch.slopes[seen.sector];
            const double squared = seen.t2 + std::max(drop * drop, seen.t2 * slope * slope);
            scratch.best[seen.stored] = std::min(scratch.best[seen.stored], squared);
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
                static_cast<float>(std::sqrt(scratch.best[static_cast<std::size_t>(s)]) * kShorter) * kFloatShorter;
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
