// The rows of the filters' benchmark: which pixels of a view are compared, and how.
#include "measuring/bench/bench_filters.h"

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
}

}  // namespace
}  // namespace relief::test
