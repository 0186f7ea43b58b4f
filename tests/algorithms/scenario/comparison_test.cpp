#include "scenario/comparison.h"

#include <gtest/gtest.h>

#include "relief/errors.h"

namespace relief::test {
namespace {

TEST(Comparison, dividersAreThoseGivenIfTheyFitElseEven) {
    Comparison comparison;
    EXPECT_TRUE(dividersOf(comparison).empty());
    comparison.others.resize(3);
    EXPECT_EQ(dividersOf(comparison), (std::vector<double>{0.25, 0.5, 0.75}));
    comparison.dividers = {0.1, 0.2};
    EXPECT_EQ(dividersOf(comparison), (std::vector<double>{0.25, 0.5, 0.75}));
    comparison.others.resize(2);
    EXPECT_EQ(dividersOf(comparison), (std::vector<double>{0.1, 0.2}));
}

TEST(Comparison, tooManyAreRefused) {
    Comparison comparison;
    comparison.others.assign(kMostCompared - 1, {"exact", {}});
    comparison.dividers = {0.25, 0.5, 0.75};
    checkComparison(comparison, "x.json");
    Comparison more = comparison;
    more.others.push_back({"cone", {}});
    EXPECT_THROW(checkComparison(more, "x.json"), InputError);
    more = comparison;
    more.dividers.push_back(0.9);
    EXPECT_THROW(checkComparison(more, "x.json"), InputError);
}

}  // namespace
}  // namespace relief::test
