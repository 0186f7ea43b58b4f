#include "panes/pyramid/pyramid_layout.h"

#include <cmath>

namespace reliefui {

namespace {

constexpr double kGap = 8;
// Limit of the aspect of blocks; maps with a more extreme aspect are stretched.
constexpr double kLongest = 6;

// A grid of places for small blocks; level 0 takes span x span of them in the upper left corner.
struct Plan {
    int columns = 1;
    int rows = 1;
    int span = 1;
    double large = 0;  // height of level 0
    double small = 0;  // height of the other levels

    // Quality of a plan. Both sizes should be large, but legibility of the many small blocks counts more.
    double score() const { return large * std::pow(small, 1.6); }
};

Plan fit(int columns, int rows, int span, double aspect, double width, double height) {
    Plan plan{columns, rows, span, 0, 0};
    const double acrossWide = (width + kGap) / columns - kGap;
    const double acrossHigh = (height + kGap) / rows - kTitleHeight - kGap;
    plan.small = std::min(acrossWide / aspect, acrossHigh);
    const double wide = span * (aspect * plan.small + kGap) - kGap;
    const double high = span * (plan.small + kTitleHeight + kGap) - kTitleHeight - kGap;
    plan.large = std::min(wide / aspect, high);
    return plan;
}

Plan bestPlan(int others, double aspect, double width, double height) {
    Plan best;
    for (int span = 1; span <= others + 1; ++span) {
        for (int columns = span; columns <= span + others; ++columns) {
            const int beside = (columns - span) * span;
            const int below = std::max(0, others - beside);
            const int rows = span + (below + columns - 1) / columns;
            const Plan plan = fit(columns, rows, span, aspect, width, height);
            if (plan.small > 0 && plan.score() > best.score()) best = plan;
        }
    }
    if (best.small <= 0) best = {others + 1, 1, 1, 20, 20};  // a pane without area
    return best;
}

}  // namespace

std::vector<LevelBlock> pyramidLayout(int levels, const Box& domain, double width, double height) {
    const double aspect = std::clamp(domain.width() / domain.height(), 1 / kLongest, kLongest);
    const Plan plan = bestPlan(levels - 1, aspect, width, height);
    const double stepX = aspect * plan.small + kGap;
    const double stepY = plan.small + kTitleHeight + kGap;
    std::vector<LevelBlock> blocks;
    const auto add = [&](double x, double y, double side) {
        const double top = y + kTitleHeight;
        blocks.push_back(
            {static_cast<int>(blocks.size()), {x, top, x + aspect * side, top + side}, domain, {x, top - 2}});
    };
    // Level 0 is placed first. It may be lower than its places, so that the others move up.
    add(0, 0, plan.large);
    for (int place = 0; static_cast<int>(blocks.size()) < levels; ++place) {
        const int column = place % plan.columns;
        const int row = place / plan.columns;
        if (column < plan.span && row < plan.span) continue;
        add(column * stepX, row * stepY, plan.small);
    }
    return blocks;
}

}  // namespace reliefui
