#include "mapping/rows/row_planner.h"

#include <gtest/gtest.h>

#include "mapping/rows/row_kernels.h"
#include "row_cases.h"

namespace relief {
namespace {

using test::Random;
using test::rowOfRatio;

constexpr std::uint64_t kSeed = 20183;

// Returns the largest distance of u and v from the chord between pixels n and n + m, sampled at kPerPixel points per
// pixel.
double sampledError(const Homography& map, double n, double m) {
    const auto at = [&](double x, bool v) {
        const TexelPoint p = map.at(x, 0.5);
        return v ? p.t : p.s;
    };
    double worst = 0;
    constexpr int kPlaces = 4000;
    for (const bool v : {false, true}) {
        const double first = at(n + 0.5, v), last = at(n + m + 0.5, v);
        for (int i = 0; i <= kPlaces; ++i) {
            const double part = static_cast<double>(i) / kPlaces;
            worst = std::max(worst, std::abs(at(n + 0.5 + part * m, v) - (first + part * (last - first))));
        }
    }
    return worst;
}

Homography randomRow(Random& random, int width) {
    return rowOfRatio(width, std::exp2(random.real(-4.0, -0.3)), random.real(100.0, 5000.0), random.real(0.0, 1000.0),
                      random.real(0.0, 1000.0), random.whole(0, 1) == 1);
}

TEST(RowPlanner, TheErrorOfALineIsTheClosedForm) {
    Random random(kSeed);
    for (int n = 0; n < 200; ++n) {
        const Homography map = randomRow(random, 4000);
        const double from = random.whole(0, 2000), length = random.whole(1, 1900);
        const RowSlopes slopes = rowSlopes(map, 0.5);
        const double closed = linearError(std::max(std::abs(slopes.a), std::abs(slopes.b)), map.qx, length,
                                          map.denominator(from + 0.5, 0.5), map.denominator(from + length + 0.5, 0.5));
        // The samples are a 4000th of the span apart, and the error curve is flat at its maximum.
        EXPECT_NEAR(sampledError(map, from, length), closed, 1e-6 * closed + 1e-9) << "seed " << kSeed << ", " << n;
    }
}

TEST(RowPlanner, TheLongestSpanKeepsTheErrorAndOneMoreDoesNot) {
    Random random(kSeed + 1);
    int limited = 0;
    for (int n = 0; n < 100; ++n) {
        const int width = 4000;
        const Homography map = randomRow(random, width);
        const double error = std::exp2(random.real(-8.0, 3.0));
        const std::int64_t m = longestSpan(map, 0.5, {0, width}, error);
        const auto worstOf = [&](std::int64_t length) {
            const double atLeft = sampledError(map, 0, static_cast<double>(length));
            const double atRight =
                sampledError(map, static_cast<double>(width - 1 - length), static_cast<double>(length));
            return std::max(atLeft, atRight);
        };
        SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", case " + std::to_string(n) +
                     ", m = " + std::to_string(m));
        if (m > 1) {
            EXPECT_LE(worstOf(m), error * (1 + 1e-9));
        }
        if (m < width - 1) {
            EXPECT_GT(worstOf(m + 1), error * (1 - 1e-6));
            ++limited;
        }
        // The variant satisfies the bound, too: its spans are some of these, its pixels some of the sampled points.
        RowOptions options{RowVariant::Subspan};
        options.span = static_cast<int>(m);
        options.anchor = kNever;
        if (m > 1) {
            EXPECT_LE(test::evaluated<double>(map, 0.5, {0, width}, options).worst, error * (1 + 1e-9));
        }
    }
    EXPECT_GT(limited, 50);
}

TEST(RowPlanner, ALineKeepsAnyError) {
    const Homography flat;  // the identity, for which a chord is exact
    EXPECT_EQ(longestSpan(flat, 0.5, {0, 500}, 1e-9), 499);
    EXPECT_EQ(longestSpan(flat, 0.5, {3, 4}, 1e-9), 1);
}

TEST(RowPlanner, SpansOfAnyLengthReachBothEnds) {
    for (const int width : {1, 2, 3, 15, 16, 17, 18, 33, 100}) {
        for (const int m : {1, 2, 3, 16, 40}) {
            for (const int anchor : {kNever, kRecommended, 32}) {
                const Homography map = rowOfRatio(width, 0.3, 500, 2, 90, false);
                RowOptions options{RowVariant::Subspan};
                options.span = m;
                options.anchor = anchor;
                std::vector<double> u(static_cast<std::size_t>(width)), v(u);
                evaluateRow(map, 0.5, {0, width}, options, u.data(), v.data());
                for (int n = 0; n < width; n = n + 1 < width && n + m > width - 1 ? width - 1 : n + m) {
                    const auto i = static_cast<std::size_t>(n);
                    EXPECT_NEAR(u[i], static_cast<double>(truthAt(map, 0.5, n).s), 1e-9) << width << ", " << m;
                    EXPECT_NEAR(v[i], static_cast<double>(truthAt(map, 0.5, n).t), 1e-9) << width << ", " << m;
                }
            }
        }
    }
}

// A mirrored row drifts as much, so it restarts as often, whichever end recedes.
TEST(RowPlanner, AMirroredRowHasTheSameAnchor) {
    constexpr int kWidth = 3000;
    Random random(kSeed + 5);
    int anchored = 0;
    for (int n = 0; n < 100; ++n) {
        const Homography map = randomRow(random, kWidth);
        // x becomes kWidth - x.
        Homography mirror = map;
        mirror.sx = -map.sx, mirror.tx = -map.tx, mirror.qx = -map.qx;
        mirror.s1 = map.s1 + kWidth * map.sx, mirror.t1 = map.t1 + kWidth * map.tx;
        mirror.q1 = map.q1 + kWidth * map.qx;
        const RowOptions options{RowVariant::Incremental};
        const RowPlan one = planRow<float>(map, 0.5, {0, kWidth}, options);
        const RowPlan other = planRow<float>(mirror, 0.5, {0, kWidth}, options);
        anchored += one.anchor > 0 ? 1 : 0;
        // The ends of the row are rounded.
        EXPECT_NEAR(static_cast<double>(one.anchor), static_cast<double>(other.anchor),
                    1 + 1e-3 * static_cast<double>(one.anchor))
            << n;
    }
    EXPECT_GT(anchored, 50);
}

}  // namespace
}  // namespace relief
