// Planes above the nodes of a max pyramid: C(q) <= value + gradient . (q - middle) for each cell q of a node. On slopes
// they bound the cells of a node to second order, the maximum alone only to first order.
#pragma once

#include <algorithm>
#include <vector>

#include "images/pyramid.h"
#include "relief/work.h"

namespace relief {

// The cells [x0, x1) of a node on one axis, by their centres: the middle, and half the distance of the outermost ones.
struct NodeSpan {
    double middle = 0;  // of the outermost cells' centres
    double half = 0;

    // The span of node i of a level, on an axis with the given number of cells.
    static NodeSpan of(int level, int i, int cells) {
        const int from = i << level;
        const int to = std::min((i + 1) << level, cells) - 1;
        return {0.5 * (static_cast<double>(from) + to), 0.5 * (to - from)};
    }
};

class ConePlanes {
  public:
    struct Node {
        float highest;
        float value;  // at the middle of the node's cells; rounded up
        float gradientX;
        float gradientY;
    };

    ConePlanes(const Pyramid& highest, Work& work);

    int top() const { return static_cast<int>(levels_.size()) - 1; }
    int width(int level) const { return widths_[static_cast<std::size_t>(level)]; }
    int height(int level) const { return heights_[static_cast<std::size_t>(level)]; }
    const Node& at(int level, int i, int j) const {
        return levels_[static_cast<std::size_t>(
            level)][static_cast<std::size_t>(j) * static_cast<std::size_t>(width(level)) + static_cast<std::size_t>(i)];
    }

  private:
    Node above(int level, int i, int j) const;

    std::vector<std::vector<Node>> levels_;
    std::vector<int> widths_;
    std::vector<int> heights_;
};

}  // namespace relief
