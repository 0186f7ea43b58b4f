// Searches a max pyramid for the cells around a box of cells that are high enough to matter, in all periods within
// reach. For certificates: independent of the searches in the map builders.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "images/pyramid.h"
#include "relief/maps/refined.h"

namespace relief {

// Cells [x0, x1) x [y0, y1) of cell_grid.h; under repeat they may lie outside the grid.
struct CellBox {
    int x0, x1, y0, y1;
};

class CellSearch {
  public:
    CellSearch(const HeightField& field, Work& work)
        : wraps_(field.address() == Address::Repeat),
          cells_(field, work),
          pyramid_(PyramidKind::Max, cells_.highest, work),
          width_(cells_.highest.width()),
          height_(cells_.highest.height()) {}

    const FloatImage& highest() const { return cells_.highest; }
    double highestOfAll() const { return static_cast<double>(pyramid_.level(pyramid_.levels() - 1)(0, 0)); }

    // Calls leaf(x, y, gap, highest) for every cell for which keep(gap, highest) is true. gap: distance of the cell
    // from the box, texels; highest: its height. keep is also called for pyramid texels, with lower bounds of gap and
    // upper bounds of highest, and must be true if it could be true for one of their cells. Cells farther away than
    // `reach` texels are skipped.
    template <class Keep, class Leaf>
    void visit(const CellBox& box, double reach, const Keep& keep, const Leaf& leaf) const {
        const int top = pyramid_.levels() - 1;
        // The box's own period is searched first, because what it finds prunes the others.
        node(box, top, 0, 0, 0, 0, reach, keep, leaf);
        if (!wraps_) return;
        const auto periods = [&](int first, int last, int size) {
            return std::pair(static_cast<int>(std::floor((first - reach) / size)),
                             static_cast<int>(std::floor((last + reach) / size)));
        };
        const auto [px0, px1] = periods(box.x0, box.x1, width_);
        const auto [py0, py1] = periods(box.y0, box.y1, height_);
        for (int py = py0; py <= py1; ++py) {
            for (int px = px0; px <= px1; ++px) {
                if (px == 0 && py == 0) continue;
                node(box, top, 0, 0, px * width_, py * height_, reach, keep, leaf);
            }
        }
    }

  private:
    template <class Keep, class Leaf>
    void node(const CellBox& box, int level, int i, int j, int shiftX, int shiftY, double reach, const Keep& keep,
              const Leaf& leaf) const {
        const int x0 = (i << level) + shiftX;
        const int x1 = std::min((i + 1) << level, width_) + shiftX;
        const int y0 = (j << level) + shiftY;
        const int y1 = std::min((j + 1) << level, height_) + shiftY;
        const double dx = std::max({0, x0 - box.x1, box.x0 - x1});
        const double dy = std::max({0, y0 - box.y1, box.y0 - y1});
        const double gap = std::sqrt(dx * dx + dy * dy);
        const auto highest = static_cast<double>(pyramid_.level(level)(i, j));
        if (gap > reach || !keep(gap, highest)) return;
        if (level == 0) {
            leaf(x0, y0, gap, highest);
            return;
        }
        const FloatImage& below = pyramid_.level(level - 1);
        // Nearer children are visited first, because they prune the others.
        const int nearX = box.x0 + box.x1 > x0 + x1 ? 1 : 0;
        const int nearY = box.y0 + box.y1 > y0 + y1 ? 1 : 0;
        for (int n = 0; n < 4; ++n) {
            const int ci = 2 * i + (nearX ^ (n & 1));
            const int cj = 2 * j + (nearY ^ (n >> 1));
            if (ci < below.width() && cj < below.height()) {
                node(box, level - 1, ci, cj, shiftX, shiftY, reach, keep, leaf);
            }
        }
    }

    bool wraps_;
    CellHeights cells_;
    Pyramid pyramid_;
    int width_;
    int height_;
};

}  // namespace relief
