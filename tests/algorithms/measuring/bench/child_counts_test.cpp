#include "measuring/bench/child_counts.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"

namespace relief::test {
namespace {

ChildrenByLevel countChildren(const StepLog& log) {
    ChildrenByLevel counts;
    for (std::size_t r = 0; r < log.rays(); ++r) addChildren(log.steps, log.begin[r], log.begin[r + 1], counts);
    return counts;
}

ChildrenByLevel counted(const char* name, const HeightField& field, int rays, std::uint64_t seed) {
    MapCache cache;
    Work work;
    RayBlock block;
    Random random(seed);
    for (int n = 0; n < rays; ++n) block.push(randomRay(random, field, 3));
    HitBlock hits;
    StepLog log;
    makeTracer({name, {}}, field, cache, work)->trace(block, hits, log, work);
    return countChildren(log);
}

// A needle next to the ray's path: every texel is descended into; one child after the other is free.
TEST(ChildCounts, ofOneRayByHand) {
    FloatImage heights(4, 4, 0.0F);
    heights(3, 3) = 0.9F;
    heights(3, 0) = 0.5F;
    const HeightField field(share(heights), Surface::Columns, Address::Border, 0.5);
    MapCache cache;
    Work work;
    RayBlock block;
    block.push({0.25, 3.5, 3.5, -3.25});  // from the lower left to the upper right, above everything that it crosses
    HitBlock hits;
    StepLog log;
    makeTracer({"max-pyramid-paper", {}}, field, cache, work)->trace(block, hits, log, work);
    const ChildrenByLevel counts = countChildren(log);
    std::int64_t descents = 0;
    for (const Step& step : log.steps) descents += step.decision == Decision::Descend;
    std::int64_t ascents = 0;
    for (const Step& step : log.steps) ascents += step.decision == Decision::Ascend;
    const ChildCounts all = sumOf(counts);
    EXPECT_EQ(all.descents(), ascents);
    EXPECT_EQ(all.ended, descents - ascents);
}

TEST(ChildCounts, oneTwoOrThreeOfFourAndTheLevelsAddUp) {
    const HeightField field(share(makeRelief("paper8x8", 8, 8, 1)), Surface::Columns, Address::Repeat, 0.5);
    const ChildrenByLevel counts = counted("max-pyramid-paper", field, 2000, 101);
    EXPECT_EQ(counts.size(), 3U) << "levels 3, 2 and 1 are descended into";
    const ChildCounts all = sumOf(counts);
    EXPECT_GT(all.finished[0], all.finished[1]);
    EXPECT_GT(all.finished[1], all.finished[2]);
    EXPECT_GT(all.finished[2], 0) << "the paper says at most two";
    EXPECT_GT(all.mean(), 1);
    EXPECT_LT(all.mean(), 2);
    EXPECT_NEAR(all.share(1) + all.share(2) + all.share(3), 1, 1e-12);
    // The stackless traversal descends as often, except for parents that it leaves without ascending.
    EXPECT_GT(sumOf(counted("max-pyramid", field, 2000, 101)).finished[2], 0);
}

TEST(ChildCounts, methodsWithoutAPyramidHaveNone) {
    const HeightField field(randomHeights(16, 16, 3), Surface::Bilinear, Address::Repeat, 0.5);
    for (const char* name : {"exact", "layers", "cone"}) EXPECT_TRUE(counted(name, field, 50, 7).empty()) << name;
    // The hybrid's descents continue in another method, not one level below, so none is counted.
    EXPECT_TRUE(counted("hybrid", field, 50, 7).empty());
}

TEST(ChildCounts, asATable) {
    ChildrenByLevel counts;
    counts[1] = {{5, 3, 2}, 4};
    counts[2] = {{1, 0, 0}, 1};
    EXPECT_EQ(childrenCsv(counts), "level,one,two,three,mean,ended\n2,1,0,0,1,1\n1,5,3,2,1.7,4\nall,6,3,2," +
                                       numberText(18.0 / 11) + ",5\n");
    EXPECT_NE(childrenText(counts).find("one   54.5% #############"), std::string::npos) << childrenText(counts);
}

}  // namespace
}  // namespace relief::test
