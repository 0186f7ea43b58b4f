// The rows of the filters' benchmark: which pixels of a view are compared, and how.
#include "measuring/bench/bench_filters.h"

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/supersample.h"

namespace relief::test {
namespace {

// Just wide enough for one column whose pixels have all of their neighbours in the picture.
TEST(BenchFilters, theErrorIsAMeanOverThePixelsWhoseNeighboursAreSeen) {
    FilterBenchOptions options;
    options.scenes = {filterScene("checker", 64, 1)};
    options.filters = {{"nearest", {}}};
    options.pixelModels = {PixelModel::Gaussian};
    options.elevations = {80};
    options.distance = 0.4;
    options.width = 2 * (kGaussianRing + 1) + 1;
    options.height = 2 * (kGaussianRing + 1) + 10;
    options.samples = 2;
    options.pass = BenchPass::Counts;
    Work work(1);
    const auto rows = benchFilters(options, work);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].texelsRead, 1);
    EXPECT_GT(rows[0].rmse, 0);
    EXPECT_GT(rows[0].flip, 0);
    EXPECT_LE(rows[0].flip, 1);
    // One column less, and no pixel can be compared: the row has no values.
    --options.width;
    const auto none = benchFilters(options, work);
    ASSERT_EQ(none.size(), 1U);
    for (const double value : {none[0].rate, none[0].rmse, none[0].psnr, none[0].flip, none[0].texelsRead}) {
        EXPECT_TRUE(std::isnan(value)) << value;
    }
    EXPECT_NE(filterBenchText(none).find(" - "), std::string::npos) << filterBenchText(none);
}

}  // namespace
}  // namespace relief::test
