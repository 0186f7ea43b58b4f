#include "scenario/breakpoint.h"

#include <algorithm>

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

// A breakpoint with a condition.
Breakpoint when(const std::string& condition, int ignore = 0) {
    Breakpoint breakpoint;
    breakpoint.kind = StopKind::Condition;
    breakpoint.condition = condition;
    breakpoint.ignore = ignore;
    return breakpoint;
}

TEST(Breakpoint, AConditionStopsAtEveryStepAtWhichItHolds) {
    const std::vector<Step> steps = log();
    const std::vector<FurtherColumn> further{{"sdf", {"", "0.5", "0.25", "", "1e-3", "2", "3"}},
                                             {"who", {"a", "b", "a", "1", "", "a", "b"}},
                                             {"my column", {"0", "0", "0", "0", "0", "0", "9"}}};
    const StoppedRay ray{&steps, {}, {}, StepColumns(steps, &further, std::array{480, 300})};
    using Steps = std::vector<std::size_t>;
    const std::vector<std::pair<const char*, Steps>> expected{
        {"level == 2", {1, 4}},
        {"level < 2 && lambda_after < 0.3", {2}},
        {"level == 0 || decision == ascend", {3, 4, 6}},
        {"!(level == 0 or level == 1)", {0, 1, 4}},
        {"number >= 6", {5, 6}},
        {"delta_lambda == 0.6 +- 1e-9", {6}},
        {"pixel == 480,300 and decision == 'hit'", {6}},
        {"pixel == 480, 300", {0, 1, 2, 3, 4, 5, 6}},
        {"pixel == 480,301", {}},
        {"pixel_x == 480 && pixel_y < 300", {}},
        {"kind == texel and i == 4", {3, 6}},
        {"sdf < 1", {1, 2, 4}},  // an empty cell compares as false
        {"sdf <= 0.5 && sdf >= 0.25", {1, 2}},
        {"who == 'a'", {0, 2, 5}},
        {"who == '1'", {3}},
        {"column('my column') > 8", {6}},
        {"s > 0", {}},  // these steps have no such value
        {"true", {0, 1, 2, 3, 4, 5, 6}},
    };
    for (const auto& [condition, stops] : expected) {
        const BreakpointHits hits = breakpointHits(when(condition), ray);
        EXPECT_EQ(hits.steps, stops) << condition;
        EXPECT_FALSE(hits.fault) << condition;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            EXPECT_EQ(stopsAt(when(condition), ray, k), std::find(stops.begin(), stops.end(), k) != stops.end());
        }
    }
    EXPECT_EQ(nextStop({when("level == 2")}, ray, 1, true), 4U);
    EXPECT_EQ(nextStop({when("level == 2")}, ray, 4, false), 1U);
    EXPECT_EQ(nextStop({when("level == 2"), when("sdf == 2")}, ray, 4, true), 5U);
}

TEST(Breakpoint, TheFirstMeetingsAreIgnored) {
    const std::vector<Step> steps = log();
    const StoppedRay ray{&steps, {}, {}};
    const Breakpoint third = when("level < 3", 2);  // met at 1 to 6
    const BreakpointHits hits = breakpointHits(third, ray);
    EXPECT_EQ(hits.steps.size(), 6U);
    EXPECT_EQ(hits.ignored, 2U);
    EXPECT_EQ(nextStop({third}, ray, 0, true), 3U);
    EXPECT_EQ(nextStop({third}, ray, 6, false), 5U);
    EXPECT_EQ(nextStop({third}, ray, 3, false), std::nullopt);
    EXPECT_FALSE(stopsAt(third, ray, 2));
    Breakpoint below{StopKind::LevelBelow, 2};  // met at 2 and 5
    below.ignore = 1;
    EXPECT_EQ(nextStop({below}, ray, 0, true), 5U);
    below.ignore = 9;
    EXPECT_EQ(nextStop({below}, ray, 0, true), std::nullopt);
    EXPECT_EQ(breakpointHits(below, ray).ignored, 2U);
}

TEST(Breakpoint, AConditionWithoutValueStopsNowhereAndSaysWhy) {
    const std::vector<Step> steps = log();
    const StoppedRay ray{&steps, {}, {}};
    const auto fault = [&](const char* condition) {
        const BreakpointHits hits = breakpointHits(when(condition), ray);
        EXPECT_TRUE(hits.steps.empty()) << condition;
        EXPECT_EQ(nextStop({when(condition)}, ray, 0, true), std::nullopt) << condition;
        return hits.fault ? sentence(*hits.fault) : std::string();
    };
    EXPECT_NE(fault("levl == 3").find("there is no column of the steps \"levl\"; did you mean \"level\"?"),
              std::string::npos)
        << fault("levl == 3");
    EXPECT_EQ(fault("level"), "3 is neither true nor false");
    EXPECT_NE(fault("level == 'hit'"), "");
    EXPECT_NE(fault("sdf < 1"), "") << "the column of a file that is not open";
    // A scenario may name columns of files; only what is no expression is refused.
    EXPECT_NO_THROW(checkBreakpoint(when("sdf < 1"), "s"));
    for (const char* const wrong : {"", "level ==", "level = 3", "pixel == 480,", "(level == 3"}) {
        EXPECT_THROW(checkBreakpoint(when(wrong), "s"), InputError) << wrong;
    }
    EXPECT_THROW(checkBreakpoint(when("level == 3", -1), "s"), InputError);
    EXPECT_THROW(checkBreakpoint(when(std::string(1001, ' ') + "true"), "s"), InputError);
    try {
        checkBreakpoint(when("level ="), "s.json");
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "s.json: the condition \"level =\" is wrong: an operator, or the end, is missing at character 7");
    }
}

TEST(WatchedValues, ChangeAndAreDrawn) {
    const std::vector<Step> steps = log();
    const std::vector<FurtherColumn> further{{"sdf", {"", "", "0.25", "0.25", "", "2", "2"}}};
    const StepColumns columns(steps, &further);
    const WatchedValues levels = watchedValues("level", columns);
    EXPECT_EQ(levels.heights(), (std::vector<double>{3, 2, 1, 0, 2, 1, 0}));
    EXPECT_EQ(levels.nextChange(0, true), 1U);
    const WatchedValues after = watchedValues("lambda_after", columns);
    EXPECT_EQ(after.nextChange(0, true), 3U);
    EXPECT_EQ(after.nextChange(5, false), 2U);
    EXPECT_EQ(after.nextChange(6, true), std::nullopt);
    EXPECT_EQ(after.nextChange(0, false), std::nullopt);
    // Steps without a value are equal.
    const WatchedValues sdf = watchedValues("sdf", columns);
    EXPECT_EQ(sdf.nextChange(0, true), 2U);
    EXPECT_EQ(sdf.nextChange(2, true), 4U);
    // Texts are numbered in the order in which they occur.
    EXPECT_EQ(watchedValues("decision", columns).heights(), (std::vector<double>{0, 1, 1, 2, 3, 1, 4}));
    EXPECT_EQ(watchedValues("level < 2", columns).heights(), (std::vector<double>{0, 0, 1, 1, 0, 1, 1}));
    EXPECT_EQ(watchedValues("z_out - value", columns).values.size(), steps.size());
    EXPECT_THROW(watchedValues("nothing", columns), InputError);
    EXPECT_THROW(watchedValues("level -", columns), InputError);
}

TEST(Breakpoint, NamesAndRangesAreChecked) {
    for (std::size_t k = 0; k < kStopNames.size(); ++k) {
        EXPECT_EQ(static_cast<std::size_t>(parseStop(kStopNames[k])), k);
        Breakpoint breakpoint{static_cast<StopKind>(k)};
        breakpoint.condition = "level == 3";
        EXPECT_FALSE(sentence(breakpointTitle(breakpoint), Language::Ukrainian).empty());
    }
    EXPECT_THROW(parseStop("never"), InputError);
    EXPECT_NO_THROW(checkBreakpoint({StopKind::LevelBelow, 32}, "s"));
    EXPECT_THROW(checkBreakpoint({StopKind::LevelBelow, 33}, "s"), InputError);
    EXPECT_THROW(checkBreakpoint({StopKind::RayBelow, 0, 0, 0, 1.01}, "s"), InputError);
}

}  // namespace
}  // namespace relief::test
