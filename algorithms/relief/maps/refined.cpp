#include "relief/maps/refined.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/maps/cells_around.h"
#include "relief/maps/range_minimum.h"

namespace relief {

namespace {

// Gates are used in sectors in which they are crossed at an angle with at least this cosine.
constexpr double kLeastCosine = 0.4;
// Cells farther than this, in texels, are not examined: the bound is cut there, which is safe.
constexpr int kLargestRadius = 64;
// Relative margin of the radius in which gates are searched; above the rounding of slopes in double.
constexpr double kReachMargin = 1e-9;

FloatImage transposed(const FloatImage& image) {
    FloatImage turned(image.height(), image.width());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) turned(y, x) = image(x, y);
    }
    return turned;
}

// The gates perpendicular to one axis: the index of a gate along that axis, and the heights on it across.
struct GateAxis {
    const GridAxis& along;
    const GridAxis& across;
    RangeMinimum heights;  // line: index of the texel along; place: index across
    bool nodes;            // bilinear: heights at nodes on the line; columns: heights of the column beyond it

    // The smallest height that a ray crossing line `gate` between lo and hi (cell coordinates) must exceed. towards:
    // sign of the direction from the box to the gate. std::nullopt outside the picture.
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

// A gate that matters: its smallest height (in the metric) and the longest horizontal distance to it.
struct Gate {
    double g;
    double tau;
};

struct Span {
    double low;
    double high;
};

// Appends the gates of one axis behind a box, in one sector, nearest first and only those higher than all before. top:
// upper bound of their heights (in the metric).
void collectGates(const GateAxis& axis, Span box, Span boxAcross, double cosBegin, double sinBegin, double cosEnd,
                  double sinEnd, double slab, double reach, double top, std::vector<Gate>& gates) {
    if (cosBegin * cosEnd <= 0) return;
    const double leastCosine = std::min(std::abs(cosBegin), std::abs(cosEnd));
    if (leastCosine < kLeastCosine) return;
    const int towards = cosBegin > 0 ? -1 : 1;  // from the box back along the rays
    const double slopeA = -sinBegin / std::abs(cosBegin);
    const double slopeB = -sinEnd / std::abs(cosEnd);
    const double lowest = std::min(slopeA, slopeB);
    const double highest = std::max(slopeA, slopeB);
    const int first = static_cast<int>(towards < 0 ? box.low : box.high);
    double best = 0;
    for (int n = 0; best < top; ++n) {
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

class Builder {
  public:
    Builder(const DistanceMap& map, int nx, int ny, const HeightField& field, const CellHeights& cells,
            UnfilledVector<float>& values, Work& work)
        : map_(map),
          nx_(nx),
          ny_(ny),
          cells_(cells),
          boxes_(cells, map.parameters.footprint, nx, ny, work),
          tiles_(highestOfTiles(cells.highest, field.address() == Address::Repeat)),
          top_(static_cast<double>(*std::max_element(cells.highest.pixels().begin(), cells.highest.pixels().end())) *
               map.slabTexels),
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
                offsets_.push_back(cellsAround(width, height, radius_, sectors_, map.parameters.sectors));
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
    // Number of cells of the last, clipped box of an axis.
    int lastWidth(const GridAxis& axis) const { return (axis.cells - 1) % map_.parameters.footprint + 1; }
    void horizons(int bx, int by, double lowestTop, std::vector<std::vector<Gate>>& gates) const;
    void distances(int bx, int by, double z0, Scratch& scratch) const;
    void tile(const CellsAround& offsets, const Tile& tile, int x0, int y0, double z0, Scratch& scratch) const;
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
    BoxHeights boxes_;
    FloatImage tiles_;
    double top_;  // highest point of the relief, in the metric
    UnfilledVector<float>& values_;
    CellGrid grid_;
    AzimuthSectors sectors_;
    int radius_;
    std::vector<CellsAround> offsets_;  // for whole boxes, those of the last column, of the last row, and of both
    double mMin_;
    GateAxis gatesX_;
    GateAxis gatesY_;
};

// Collects the gates of a box. lowestTop: top of the lowest layer that needs them, in the metric. Gates farther than
// the distance at which the flattest ray reaches the highest point are no steeper than that ray.
void Builder::horizons(int bx, int by, double lowestTop, std::vector<std::vector<Gate>>& gates) const {
    const int f = map_.parameters.footprint;
    const Span x{static_cast<double>(bx * f), static_cast<double>(std::min((bx + 1) * f, grid_.x.cells))};
    const Span y{static_cast<double>(by * f), static_cast<double>(std::min((by + 1) * f, grid_.y.cells))};
    const double reach = std::min(map_.maxRun, std::max(0.0, top_ - lowestTop) / mMin_ * (1 + kReachMargin));
    gates.resize(static_cast<std::size_t>(sectors_.count()));
    for (int k = 0; k < sectors_.count(); ++k) {
        auto& list = gates[static_cast<std::size_t>(k)];
        list.clear();
        // Between the ends of a sector the tangent is monotone, and the cosine is smallest at an end.
        const double c0 = std::cos(sectors_.begin(k));
        const double s0 = std::sin(sectors_.begin(k));
        const double c1 = std::cos(sectors_.end(k));
        const double s1 = std::sin(sectors_.end(k));
        collectGates(gatesX_, x, y, c0, s0, c1, s1, map_.slabTexels, reach, top_, list);
        collectGates(gatesY_, y, x, s0, c0, s1, c1, map_.slabTexels, reach, top_, list);
    }
}

void Builder::distances(int bx, int by, double z0, Scratch& scratch) const {
    const int f = map_.parameters.footprint;
    const double steepLeast = *std::min_element(scratch.slopes.begin(), scratch.slopes.end());
    const double perT = std::sqrt(1 + steepLeast * steepLeast);
    // Squared.
    const double cut = radius_ * radius_ * perT * perT;
    scratch.best.assign(static_cast<std::size_t>(map_.parameters.sectors), cut);
    const CellsAround& offsets = offsets_[(by == ny_ - 1 ? 2U : 0U) + (bx == nx_ - 1 ? 1U : 0U)];
    double worst = cut;
    for (const Tile& square : offsets.tiles) {
        if (square.t * square.t * perT * perT >= worst) break;
        tile(offsets, square, bx * f, by * f, z0, scratch);
        worst = *std::max_element(scratch.best.begin(), scratch.best.end());
    }
}

// Examines the cells of a tile around the box with its corner at the cell (x0, y0).
void Builder::tile(const CellsAround& offsets, const Tile& tile, int x0, int y0, double z0, Scratch& scratch) const {
    const auto place = [](const GridAxis& axis, int cell) {
        if (!axis.wraps) return cell >= 0 && cell < axis.cells ? cell : -1;
        const int rest = cell % axis.cells;
        return rest < 0 ? rest + axis.cells : rest;
    };
    const auto worstOf = [&] {
        double worst = 0;
        for (std::size_t s = 0; s < scratch.best.size(); ++s) {
            if ((tile.stored >> s & 1U) != 0) worst = std::max(worst, scratch.best[s]);
        }
        return worst;
    };
    const auto dropTo = [&](float highest) {
        return std::max(z0 - static_cast<double>(highest), 0.0) * map_.slabTexels;
    };
    double worst = worstOf();
    const int shift = grid_.x.wraps ? 0 : kTile - 1;
    const int tx = grid_.x.wraps ? place(grid_.x, x0 + tile.dx) : x0 + tile.dx + shift;
    const int ty = grid_.y.wraps ? place(grid_.y, y0 + tile.dy) : y0 + tile.dy + shift;
    if (tx < 0 || ty < 0 || tx >= tiles_.width() || ty >= tiles_.height()) return;
    const double least = dropTo(tiles_(tx, ty));
    if (tile.t * tile.t + least * least >= worst) return;
    for (std::size_t c = tile.first; c < tile.end; ++c) {
        const CellAround& offset = offsets.cells[c];
        if (offset.t * offset.t + least * least >= worst) return;
        const int x = place(grid_.x, x0 + offset.dx);
        const int y = place(grid_.y, y0 + offset.dy);
        if (x < 0 || y < 0) continue;
        const double drop = dropTo(cells_.highest(x, y));
        if (offset.t * offset.t + drop * drop >= worst) continue;
        for (std::size_t n = offset.firstSeen; n < offset.endSeen; ++n) {
            const Seen& seen = offsets.seen[n];
            const double slope = scratch.slopes[seen.sector];
            const double squared = seen.t2 + std::max(drop * drop, seen.t2 * slope * slope);
            scratch.best[seen.stored] = std::min(scratch.best[seen.stored], squared);
        }
        worst = worstOf();
    }
}

void Builder::box(int bx, int by, Scratch& scratch) const {
    const int layers = map_.layers();
    const int stored = map_.parameters.sectors;
    int lowest = 0;
    while (lowest < layers && boxes_.mark(bx, by, lowest, layers) < 0) ++lowest;
    horizons(bx, by, (lowest + 1.0) / layers * map_.slabTexels, scratch.gates);
    scratch.slopes.resize(scratch.gates.size());
    for (int k = 0; k < layers; ++k) {
        const float mark = boxes_.mark(bx, by, k, layers);
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
            // The conversion to float rounds up by at most half a unit in the last place. The factor subtracts at least
            // one; the other half covers the rounding in double.
            constexpr float kFloatShorter = 1 - 1.2e-7F;
            value(bx, by, k, s) =
                static_cast<float>(std::sqrt(scratch.best[static_cast<std::size_t>(s)])) * kFloatShorter;
        }
    }
}

}  // namespace

void refinedConservative(DistanceMap& map, int nx, int ny, const HeightField& field, const CellHeights& cells,
                         UnfilledVector<float>& values, Work& work) {
    const Builder builder(map, nx, ny, field, cells, values, work);
    map.cap = builder.cap();
    ScratchPool<Builder::Scratch> scratch;
    work.progress().begin("map refined", ny);
    parallelFor(work, ny, [&](int by) {
        builder.row(by, *scratch.borrow());
        work.progress().advance();
    });
}

}  // namespace relief
