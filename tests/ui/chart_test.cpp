// The chart kit: properties of ticks, numbers and axes for many scales and sizes.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "chart_laws.h"
#include "painting/chart.h"

namespace reliefui {

namespace {

using chart::Numbers;
using chart::Scale;
using chart::Side;

// Scales of all kinds, some of them reversed, far from 0, or very narrow.
std::vector<Scale> manyScales(double from, double to) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<Scale> scales;
    for (int n = 0; n < 150; ++n) {
        const double range = std::pow(10.0, uniform(-6, 6));
        const double low = uniform(-3, 3) * (n % 3 == 0 ? 1e6 : range);
        scales.push_back({.low = low, .high = low + range, .from = from, .to = to});
        scales.push_back(
            {.low = low, .high = low + range, .from = to, .to = from, .leastStep = n % 5 == 0 ? 1.0 : 0.0});
        const double first = uniform(-9, 4);
        for (const Numbers numbers : {Numbers::Powers, Numbers::Decades}) {
            scales.push_back(
                {.low = first, .high = first + uniform(0.1, 14), .from = from, .to = to, .numbers = numbers});
        }
    }
    return scales;
}

TEST(Chart, TicksLieOnTheirScaleAndNumbersDoNotTouch) {
    for (const double unit : {1.0, 0.01}) {
        for (const double length : {14.0, 60.0, 190.0, 900.0}) {
            for (const Scale& scale : manyScales(20 * unit, (20 + length) * unit)) {
                for (const Side side : {Side::Left, Side::Below}) {
                    const std::vector<chart::Tick> all = chart::ticks(scale, side, unit);
                    SCOPED_TRACE(std::to_string(scale.low) + " to " + std::to_string(scale.high) + " on " +
                                 std::to_string(length));
                    for (std::size_t n = 0; n < all.size(); ++n) {
                        EXPECT_GE(all[n].at, 20 * unit - 1e-3 * unit);
                        EXPECT_LE(all[n].at, (20 + length) * unit + 1e-3 * unit);
                        if (n == 0) continue;
                        EXPECT_NE(all[n].text, all[n - 1].text);
                        const double apart = std::abs(all[n].at - all[n - 1].at) / unit;
                        const double words = (textWidth(all[n].text) + textWidth(all[n - 1].text)) / 2;
                        EXPECT_GE(apart, side == Side::Left ? 10 : words + 4) << all[n - 1].text << ", " << all[n].text;
                    }
                }
            }
        }
    }
}

TEST(Chart, NumbersAreTheValuesAtTheirTicks) {
    for (const Scale& scale : {Scale{-0.31, 7.4, 0, 300}, Scale{1e6, 1e6 + 3, 300, 0}, Scale{0.1234, 0.1236, 0, 300}}) {
        const std::vector<chart::Tick> all = chart::ticks(scale, Side::Below);
        ASSERT_GE(all.size(), 3u);
        for (const chart::Tick& tick : all) EXPECT_NEAR(std::stod(tick.text), scale.valueAt(tick.at), 1e-9);
    }
    const Scale times{1.2, 3.1, 0, 400, Numbers::Decades};
    std::vector<std::string> words;
    for (const chart::Tick& tick : chart::ticks(times, Side::Below)) words.push_back(tick.text);
    EXPECT_EQ(words, (std::vector<std::string>{"20", "50", "100", "200", "500", "1000"}));
    const Scale powers{-3, 0, 100, 0, Numbers::Powers};
    EXPECT_EQ(chart::ticks(powers, Side::Left).front().text, "10⁻³");
    EXPECT_NEAR(powers.at(0.1), 100.0 / 3, 1e-9);
}

// A scale of counts has no numbers between integers.
TEST(Chart, WholeNumbersStayWhole) {
    const Scale pixels{.low = 99.5, .high = 101.5, .from = 0, .to = 600, .leastStep = 1};
    const std::vector<chart::Tick> all = chart::ticks(pixels, Side::Below);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].text + " " + all[1].text, "100 101");
}

TEST(Chart, AxesStayInTheirRoom) {
    const relief::Message title(relief::MessageId::DrawDistanceAxis);
    const relief::Message height(relief::MessageId::DrawHeightAxis, {{"texels", "12.3"}});
    for (const double width : {120.0, 226.0, 700.0}) {
        for (const double high : {90.0, 165.0, 400.0}) {
            const Box room{5, 7, 5 + width, 7 + high};
            const Box plot = chart::plotIn(room, {.top = 16, .bottom = chart::bottomOf(high)});
            for (const Scale& across : manyScales(plot.x0, plot.x1)) {
                Drawing drawing;
                drawing.bounds = room;
                const chart::Axes axes(drawing, plot, room);
                Scale upwards = across;
                upwards.from = plot.y1, upwards.to = plot.y0;
                axes.left(upwards);
                axes.below(across, title);
                axes.corner(height);
                axes.sides();
                expectWordsInside(drawing);
                if (::testing::Test::HasFailure()) FAIL() << across.low << " to " << across.high << " in " << width;
            }
        }
    }
}

// In an area smaller than the margins the plot still has positive sizes.
TEST(Chart, NoPlotIsInsideOut) {
    for (const double side : {0.0, 3.0, 40.0}) {
        const Box plot = chart::plotIn({0, 0, side, side}, {});
        EXPECT_GT(plot.width(), 0);
        EXPECT_GT(plot.height(), 0);
    }
}

}  // namespace

}  // namespace reliefui
