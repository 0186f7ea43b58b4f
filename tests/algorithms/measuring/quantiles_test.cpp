// Medians and spreads of measurements, with results computed by hand.
#include "measuring/quantiles.h"

#include <gtest/gtest.h>

namespace relief {
namespace {

TEST(Quantiles, LieBetweenTheSortedValues) {
    const std::vector<double> values{40, 10, 30, 20};
    EXPECT_EQ(quantile(values, 0), 10);
    EXPECT_EQ(quantile(values, 1), 40);
    EXPECT_EQ(quantile(values, 0.5), 25);
    EXPECT_EQ(quantile(values, 0.25), 17.5);
    EXPECT_EQ(quantile(values, 0.75), 32.5);
    EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
    for (const double share : {0.0, 0.3, 1.0}) EXPECT_EQ(quantile({7}, share), 7);
}

TEST(Quantiles, SpreadIsTheMiddleHalfOverTheMedian) {
    EXPECT_DOUBLE_EQ(relativeSpread({40, 10, 30, 20}), (32.5 - 17.5) / 25);
    EXPECT_EQ(relativeSpread({5, 5, 5}), 0);
    EXPECT_DOUBLE_EQ(relativeSpread({2, 4}), 1.0 / 3);
}

}  // namespace
}  // namespace relief
