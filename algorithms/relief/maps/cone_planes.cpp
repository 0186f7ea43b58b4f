#include "relief/maps/cone_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace relief {

ConePlanes::ConePlanes(const Pyramid& highest, Work& work) {
    for (int level = 0; level < highest.levels(); ++level) {
        const FloatImage& image = highest.level(level);
        widths_.push_back(image.width());
        heights_.push_back(image.height());
        levels_.emplace_back(image.size());
        std::vector<Node>& nodes = levels_.back();
        parallelFor(work, image.height(), [&](int j) {
            for (int i = 0; i < image.width(); ++i) {
                Node node{image(i, j), image(i, j), 0, 0};
                if (level > 0) {
                    node = above(level, i, j);
                    node.highest = image(i, j);
                }
                nodes[static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width()) +
                      static_cast<std::size_t>(i)] = node;
            }
        });
    }
}

// A plane above the planes of the node's children.
ConePlanes::Node ConePlanes::above(int level, int i, int j) const {
    struct Child {
        Node node;
        NodeSpan x, y;
    };
    std::array<Child, 4> children{};
    std::size_t count = 0;
    const int cellsX = width(0);
    const int cellsY = height(0);
    const int columns = std::min(2, width(level - 1) - 2 * i);
    const int rows = std::min(2, height(level - 1) - 2 * j);
    for (int cj = 2 * j; cj < 2 * j + rows; ++cj) {
        for (int ci = 2 * i; ci < 2 * i + columns; ++ci) {
            children[count++] = {at(level - 1, ci, cj), NodeSpan::of(level - 1, ci, cellsX),
                                 NodeSpan::of(level - 1, cj, cellsY)};
        }
    }
    const NodeSpan x = NodeSpan::of(level, i, cellsX);
    const NodeSpan y = NodeSpan::of(level, j, cellsY);
    float slopeX = 0;
    float slopeY = 0;
    const auto slope = [](const Child& from, const Child& to, double distance) {
        return (to.node.value - from.node.value) / static_cast<float>(distance);
    };
    const auto lower = static_cast<std::size_t>(columns);
    if (columns == 2) {
        for (std::size_t n = 0; n < count; n += 2) {
            slopeX += slope(children[n], children[n + 1], children[1].x.middle - children[0].x.middle);
        }
        slopeX /= static_cast<float>(rows);
    }
    if (rows == 2) {
        for (std::size_t n = 0; n < lower; ++n) {
            slopeY += slope(children[n], children[n + lower], children[lower].y.middle - children[0].y.middle);
        }
        slopeY /= static_cast<float>(columns);
    }
    // At a wall a flatter plane may be the better bound.
    constexpr double kRoundedUp = 2.4e-7;  // float has 24 bits; values stay below 2
    Node best{};
    double least = 0;
    for (const float share : {1.0F, 0.5F, 0.0F}) {
        const Node node{0, 0, slopeX * share, slopeY * share};
        double value = 0;
        for (std::size_t n = 0; n < count; ++n) {
            const Child& child = children[n];
            const auto axis = [](float own, float plane, const NodeSpan& from, const NodeSpan& to) {
                return static_cast<double>(plane) * (to.middle - from.middle) +
                       from.half * std::abs(static_cast<double>(own) - static_cast<double>(plane));
            };
            const double stands = static_cast<double>(child.node.value) +
                                  axis(child.node.gradientX, node.gradientX, child.x, x) +
                                  axis(child.node.gradientY, node.gradientY, child.y, y);
            value = n == 0 ? stands : std::max(value, stands);
        }
        // Measure of the bound: its value in the middle, and half its rise at the corners.
        const double rise = x.half * std::abs(static_cast<double>(node.gradientX)) +
                            y.half * std::abs(static_cast<double>(node.gradientY));
        if (share == 1.0F || value + 0.5 * rise < least) {
            least = value + 0.5 * rise;
            best = node;
            best.value = static_cast<float>(value + kRoundedUp);
        }
    }
    return best;
}

}  // namespace relief
