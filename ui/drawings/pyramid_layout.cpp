#include "drawings/pyramid_layout.h"

#include <cmath>

namespace reliefui {

namespace {

constexpr double kGap = 9;
// Maps of a very uneven shape are stretched to no more than this.
constexpr double kLongest = 6;

// Level 0 of height `large` and small blocks of height `small` in `columns` and `rows`.
struct Plan {
    bool beside = true;
    int columns = 1;
    int rows = 0;
    double large = 0;
    double small = 0;

    double score() const { return large > 0 && small > 0 ? large * small : 0; }
};

// The largest plan of this shape that fits; aspect: width over height of a block.
Plan fit(bool beside, int columns, int others, double aspect, double width, double height) {
    Plan plan{beside, columns, (others + columns - 1) / columns, 0, 0};
    double low = 0;
    double high = height - kTitleHeight;
    for (int k = 0; k < 40; ++k) {
        const double large = (low + high) / 2;
        double small = 0;
        bool fits = false;
        if (beside) {
            small = (large + kTitleHeight - plan.rows * kTitleHeight - (plan.rows - 1) * kGap) / plan.rows;
            fits = aspect * large + columns * (kGap + aspect * small) <= width;
        } else {
            small = (aspect * large - (columns - 1) * kGap) / columns / aspect;
            fits =
                aspect * large <= width && large + kTitleHeight + plan.rows * (kGap + kTitleHeight + small) <= height;
        }
        small = std::min(small, large);
        (fits ? low : high) = large;
        if (fits) {
            plan.large = large;
            plan.small = small;
        }
    }
    return plan;
}

}  // namespace

std::vector<LevelBlock> pyramidLayout(int levels, const Box& domain, double width, double height) {
    const double aspect = std::clamp(domain.width() / domain.height(), 1 / kLongest, kLongest);
    const int others = levels - 1;
    std::vector<LevelBlock> blocks;
    Plan best;
    if (others == 0) {
        best.large = std::min(height - kTitleHeight, width / aspect);
    }
    for (const bool beside : {true, false}) {
        for (int columns = 1; columns <= others; ++columns) {
            const Plan plan = fit(beside, columns, others, aspect, width, height);
            if (plan.score() > best.score()) best = plan;
        }
    }
    const double large = std::max(best.large, 20.0);
    const double small = std::max(best.small, 4.0);
    const auto add = [&](int level, double x, double y, double side) {
        const double top = y + kTitleHeight;
        blocks.push_back({level, {x, top, x + aspect * side, top + side}, domain, {x, top - 3}});
    };
    add(0, 0, 0, large);
    const double startX = best.beside ? aspect * large + kGap : 0;
    const double startY = best.beside ? 0 : kTitleHeight + large + kGap;
    for (int k = 0; k < others; ++k) {
        const int column = k % best.columns;
        const int row = k / best.columns;
        add(k + 1, startX + column * (aspect * small + kGap), startY + row * (small + kTitleHeight + kGap), small);
    }
    return blocks;
}

}  // namespace reliefui
