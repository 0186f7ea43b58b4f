#include "scenario/breakpoint.h"

#include <gtest/gtest.h>

#include "relief/errors.h"

namespace relief::test {
namespace {

// A log that descends three levels, skips, ascends and descends to a hit.
std::vector<Step> log() {
    std::vector<Step> steps;
    const auto add = [&](int level, std::int64_t i, double after, Decision decision) {
        Step step;
        step.level = level;
        step.i = i;
        step.j = 1;
        step.lambdaAfter = after;
        step.decision = decision;
        steps.push_back(step);
    };
    add(3, 0, 0.0, Decision::Start);
    add(2, 0, 0.0, Decision::Descend);
    add(1, 0, 0.0, Decision::Descend);
    add(0, 4, 0.3, Decision::Skip);
    add(2, 1, 0.3, Decision::Ascend);
    add(1, 2, 0.3, Decision::Descend);
    add(0, 4, 0.6, Decision::Hit);
    return steps;
}

TEST(Breakpoint, StopsWhereTheConditionBeginsToHold) {
    const std::vector<Step> steps = log();
    const StoppedRay ray{&steps, 3, 6};
    const auto stops = [&](const Breakpoint& breakpoint) {
        std::vector<std::size_t> out;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            if (stopsAt(breakpoint, ray, k)) out.push_back(k);
        }
        return out;
    };
    using Steps = std::vector<std::size_t>;
    EXPECT_EQ(stops({StopKind::LevelBelow, 2}), (Steps{2, 5}));
    EXPECT_EQ(stops({StopKind::LevelBelow, 1}), (Steps{3, 6}));
    EXPECT_EQ(stops({StopKind::Texel, 0, 4, 1}), (Steps{3, 6}));
    EXPECT_EQ(stops({StopKind::Texel, 0, 4, 2}), Steps{});
    EXPECT_EQ(stops({StopKind::RayBelow, 0, 0, 0, 0.7}), Steps{6}) << "0.7 itself is not below 0.7";
    EXPECT_EQ(stops({StopKind::Overshoot}), Steps{3});
    EXPECT_EQ(stops({StopKind::Disagreement}), Steps{6});
}

TEST(Breakpoint, TheNextOneIsFoundBothWays) {
    const std::vector<Step> steps = log();
    const StoppedRay ray{&steps, {}, {}};
    std::vector<Breakpoint> breakpoints{{StopKind::LevelBelow, 2}, {StopKind::Overshoot}};
    EXPECT_EQ(nextStop(breakpoints, ray, 0, true), 2U);
    EXPECT_EQ(nextStop(breakpoints, ray, 2, true), 5U);
    EXPECT_EQ(nextStop(breakpoints, ray, 5, true), std::nullopt);
    EXPECT_EQ(nextStop(breakpoints, ray, 6, false), 5U);
    EXPECT_EQ(nextStop(breakpoints, ray, 2, false), std::nullopt);
    EXPECT_EQ(nextStop(breakpoints, ray, 0, false), std::nullopt);
    breakpoints.front().on = false;
    EXPECT_EQ(nextStop(breakpoints, ray, 0, true), std::nullopt);
    const std::vector<Step> none;
    EXPECT_EQ(nextStop({{StopKind::LevelBelow, 2}}, {&none, {}, {}}, 0, true), std::nullopt);
}

TEST(Breakpoint, SteppingOverSkipsWhatLiesDeeper) {
    const std::vector<Step> steps = log();
    EXPECT_EQ(stepOver(steps, 0, true), 6U) << "nothing else on the top level: to the end";
    EXPECT_EQ(stepOver(steps, 1, true), 4U);
    EXPECT_EQ(stepOver(steps, 3, true), 4U);
    EXPECT_EQ(stepOver(steps, 4, false), 1U);
    EXPECT_EQ(stepOver(steps, 5, false), 4U);
    EXPECT_EQ(stepOver(steps, 0, false), 0U);
    EXPECT_EQ(stepOver(steps, 6, true), 6U);
    EXPECT_EQ(stepOver({}, 0, true), 0U);
}

TEST(Breakpoint, NamesAndRangesAreChecked) {
    for (std::size_t k = 0; k < kStopNames.size(); ++k) {
        EXPECT_EQ(static_cast<std::size_t>(parseStop(kStopNames[k])), k);
        EXPECT_FALSE(sentence(breakpointTitle({static_cast<StopKind>(k)}), Language::Ukrainian).empty());
    }
    EXPECT_THROW(parseStop("never"), InputError);
    EXPECT_NO_THROW(checkBreakpoint({StopKind::LevelBelow, 32}, "s"));
    EXPECT_THROW(checkBreakpoint({StopKind::LevelBelow, 33}, "s"), InputError);
    EXPECT_THROW(checkBreakpoint({StopKind::RayBelow, 0, 0, 0, 1.01}, "s"), InputError);
}

}  // namespace
}  // namespace relief::test
