#include "relief/maps/surface_cones.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "base/parallel.h"
#include "images/pyramid.h"
#include "relief/leaf.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/maps/maxima_around.h"

namespace relief {

namespace {

// Squares of 2 r + 1 cells, r up to this, in which the surface's own slope bounds a cone's.
constexpr int kRings = 8;

class SurfaceConeSearch {
  public:
    SurfaceConeSearch(const HeightField& field, Work& work)
        : grid_(field),
          pyramid_(PyramidKind::Max, cellMaxima(field, work), work),
          wraps_(field.address() == Address::Repeat),
          width_(grid_.x.cells),
          height_(grid_.y.cells),
          lowest_(width_, height_) {
        FloatImage steepest(width_, height_);
        const FloatImage& heights = field.heights();
        parallelFor(work, height_, [&](int y) {
            for (int x = 0; x < width_; ++x) {
                const auto [h00, h10, h01, h11] = cellCorners<double>(heights, grid_, x, y);
                lowest_(x, y) = static_cast<float>(std::min({h00, h10, h01, h11}));
                // The squared length of the gradient is convex in the cell: it is largest at a corner.
                const double across = std::max(std::abs(h10 - h00), std::abs(h11 - h01));
                const double down = std::max(std::abs(h01 - h00), std::abs(h11 - h10));
                steepest(x, y) = static_cast<float>(std::hypot(across, down) * kUp);
            }
        });
        for (FloatImage& ring : rings_) ring = steepest = maximaAround(steepest, field.address(), work);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    const CellGrid& grid() const { return grid_; }

    // The slope of the cell (x, y).
    float slope(int x, int y) const {
        double kappa = static_cast<double>(rings_[0](x, y));
        const int around = wraps_ ? 1 : 0;
        // The own period first: its results prune the others. Farther copies of a cell than the nearest lower nothing.
        visit(x, y, pyramid_.levels() - 1, 0, 0, 0, 0, kappa);
        for (int py = -around; py <= around; ++py) {
            for (int px = -around; px <= around; ++px) {
                if (px == 0 && py == 0) continue;
                visit(x, y, pyramid_.levels() - 1, 0, 0, px * width_, py * height_, kappa);
            }
        }
        return std::nextafter(static_cast<float>(kappa * kUp), 1e30F);
    }

  private:
    void visit(int x, int y, int level, int i, int j, int shiftX, int shiftY, double& kappa) const {
        const int x0 = (i << level) + shiftX;
        const int x1 = std::min((i + 1) << level, width_) + shiftX;
        const int y0 = (j << level) + shiftY;
        const int y1 = std::min((j + 1) << level, height_) + shiftY;
        const double rise = static_cast<double>(pyramid_.level(level)(i, j)) - static_cast<double>(lowest_(x, y));
        if (rise <= 0) return;
        const int dx = std::max({0, x0 - (x + 1), x - x1});
        const int dy = std::max({0, y0 - (y + 1), y - y1});
        const double gap = std::sqrt(static_cast<double>(dx) * dx + static_cast<double>(dy) * dy);
        if (gap > 0 && rise <= kappa * gap) return;
        if (level == 0) {
            if (gap == 0) return;  // a neighbour: its slope is in the first ring
            const int ring = std::max(std::abs(x0 - x), std::abs(y0 - y));
            double bound = rise / gap;
            if (ring <= kRings)
                bound = std::min(bound, static_cast<double>(rings_[static_cast<std::size_t>(ring) - 1](x, y)));
            kappa = std::max(kappa, bound);
            return;
        }
        const FloatImage& below = pyramid_.level(level - 1);
        const int nearX = 2 * x + 1 > x0 + x1 ? 1 : 0;
        const int nearY = 2 * y + 1 > y0 + y1 ? 1 : 0;
        for (int n = 0; n < 4; ++n) {
            const int ci = 2 * i + (nearX ^ (n & 1));
            const int cj = 2 * j + (nearY ^ (n >> 1));
            if (ci < below.width() && cj < below.height()) visit(x, y, level - 1, ci, cj, shiftX, shiftY, kappa);
        }
    }

    // More than the rounding of the bounds.
    static constexpr double kUp = 1 + 1e-7;

    CellGrid grid_;
    Pyramid pyramid_;
    bool wraps_;
    int width_;
    int height_;
    FloatImage lowest_;
    std::array<FloatImage, kRings> rings_;
};

}  // namespace

FloatImage surfaceCones(const HeightField& field, Work& work) {
    assert(field.surface() == Surface::Bilinear);
    const SurfaceConeSearch search(field, work);
    FloatImage cells(search.width(), search.height());
    work.progress().begin("map surface cones", search.height());
    parallelFor(work, search.height(), [&](int y) {
        for (int x = 0; x < search.width(); ++x) cells(x, y) = search.slope(x, y);
        work.progress().advance();
    });
    FloatImage slopes(field.width(), field.height());
    const auto before = [](const GridAxis& axis, int k) { return axis.wraps ? (k > 0 ? k - 1 : axis.cells - 1) : k; };
    const auto after = [](const GridAxis& axis, int k) { return axis.wraps ? k : k + 1; };
    const CellGrid& grid = search.grid();
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) {
            const int x0 = before(grid.x, i), x1 = after(grid.x, i);
            const int y0 = before(grid.y, j), y1 = after(grid.y, j);
            slopes(i, j) = std::max({cells(x0, y0), cells(x1, y0), cells(x0, y1), cells(x1, y1)});
        }
    }
    return slopes;
}

}  // namespace relief
