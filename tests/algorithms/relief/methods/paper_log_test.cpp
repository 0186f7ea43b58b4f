// The step log of max-pyramid-paper follows the procedure of [MIP18] step by step: it is checked from the log alone by
// independent code, on the paper's 8 x 8 example and on other reliefs.
#include <iostream>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/leaf.h"
#include "relief/maps/max_pyramid_map.h"

namespace relief::test {
namespace {

class PaperLog : public testing::Test {
  protected:
    // Goes through the log and checks each step's decision against the rule that it claims.
    void follow(const HeightField& field, const ViewRay& ray);

    MapCache cache_;
    Work work_{1};
    std::array<long, 5> children_{};  // histogram of the number of children that a ray crosses in a texel
};

void PaperLog::follow(const HeightField& field, const ViewRay& ray) {
    const auto map = maxPyramidMap(field, cache_, work_);
    const CellGrid grid(field);
    const Logged logged = traceLogged(*makeTracer({"max-pyramid-paper", {}}, field, cache_, work_), ray);
    const std::vector<Step>& steps = logged.steps;
    ASSERT_GE(steps.size(), 2U);
    const int top = map->top();
    const double highest = map->highest();
    // Step 1: the top level's value is the highest point; the ray advances to it.
    ASSERT_EQ(steps[0].decision, Decision::Start);
    ASSERT_EQ(steps[0].level, top);
    ASSERT_EQ(steps[0].value, highest);
    std::size_t n = 1;
    if (highest < 1) {
        if (field.address() == Address::Border && steps[1].decision == Decision::Miss) return;  // it left before that
        ASSERT_EQ(steps[1].decision, Decision::Advance);
        ASSERT_NEAR(steps[1].lambdaAfter, 1 - highest, 2 * kExclusionMargin);
        n = 2;
    }
    if (steps[n].decision == Decision::Hit) {
        // The start is on the highest ground, so nothing is traced. The truth must agree that nothing is higher there.
        ASSERT_EQ(n + 1, steps.size());
        ASSERT_NEAR(logged.hit.lambda, 1 - highest, 2 * kExclusionMargin);
        return;
    }
    std::vector<Step> parents;  // texels descended into and not yet ascended from
    std::vector<int> crossed;   // number of children crossed in each of them
    for (; n < steps.size(); ++n) {
        const Step& step = steps[n];
        SCOPED_TRACE(std::to_string(n) + " " + std::string(decisionName(step.decision)) + " ray " + describe(ray));
        const int nameX = step.level == 0 ? grid.x.firstName : 0;
        const int nameY = step.level == 0 ? grid.y.firstName : 0;
        const int i = static_cast<int>(step.i) - nameX;
        const int j = static_cast<int>(step.j) - nameY;
        if (step.decision == Decision::Ascend) {  // step 5
            ASSERT_FALSE(parents.empty());
            ASSERT_EQ(step.level, parents.back().level);
            ASSERT_EQ(step.i, parents.back().i);
            ASSERT_EQ(step.j, parents.back().j);
            ASSERT_LE(crossed.back(), 3);
            ++children_.at(static_cast<std::size_t>(crossed.back()));
            parents.pop_back();
            crossed.pop_back();
            continue;
        }
        ASSERT_EQ(step.level, top - static_cast<int>(parents.size())) << "a level was left out";
        ASSERT_EQ(step.value, map->pyramid.level(step.level)(i, j)) << "not the stored maximum";
        if (!parents.empty()) {  // step 2: coordinates double
            const int parentX = static_cast<int>(parents.back().i);
            const int parentY = static_cast<int>(parents.back().j);
            ASSERT_TRUE(i == 2 * parentX || i == 2 * parentX + 1);
            ASSERT_TRUE(j == 2 * parentY || j == 2 * parentY + 1);
            if (step.decision != Decision::Miss) ++crossed.back();
        }
        const double lowest = 1 - step.lambdaOut;  // the ray's lowest point within the texel
        if (step.decision == Decision::Skip) {     // step 3
            ASSERT_LT(step.value, lowest);
            ASSERT_EQ(step.lambdaAfter, step.lambdaOut);
        } else if (step.decision == Decision::Descend) {  // step 4
            ASSERT_GE(step.value + 2 * kExclusionMargin, lowest);
            ASSERT_GT(step.level, 0);
            parents.push_back(step);
            crossed.push_back(0);
        } else if (step.decision == Decision::Test) {
            ASSERT_EQ(step.level, 0);
        } else if (step.decision == Decision::Hit) {  // step 6
            ASSERT_EQ(step.level, 0);
            ASSERT_EQ(n + 1, steps.size());
            ASSERT_EQ(step.lambdaAfter, logged.hit.lambda);
            ASSERT_GE(step.lambdaAfter, step.lambdaIn - 2 * kExclusionMargin);
            ASSERT_LE(step.lambdaAfter, step.lambdaOut);
        } else {
            ASSERT_EQ(step.decision, Decision::Miss);
            ASSERT_EQ(field.address(), Address::Border);
        }
    }
}

TEST_F(PaperLog, theExampleOfThePaper) {
    const Heights heights = share(makeRelief("paper8x8", 8, 8, 1));
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            const HeightField field(heights, surface, address, 0.5);
            Random random(101);
            for (int n = 0; n < 2000; ++n) follow(field, randomRay(random, field, 3));
        }
    }
}

TEST_F(PaperLog, anySizeAndTheShareOfChildrenCrossed) {
    for (const auto& [w, h] : std::vector<std::pair<int, int>>{{64, 64}, {31, 17}, {1, 7}, {100, 3}}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(randomHeights(w, h, 103), surface, address, 1);
                Random random(107);
                for (int n = 0; n < 300; ++n) follow(field, randomRay(random, field, 3));
            }
        }
    }
    std::cout << "children crossed in texels without a hit: one " << children_[1] << ", two " << children_[2]
              << ", three " << children_[3] << "\n";
    // The paper states at most two children; three do occur.
    EXPECT_GT(children_[3], 0);
}

// One ray of the example, step by step: along the first row, over its two high texels.
TEST_F(PaperLog, oneRayWordForWord) {
    const HeightField field(share(makeRelief("paper8x8", 8, 8, 1)), Surface::Columns, Address::Repeat, 0.5);
    // Enters above (0.5, 1.5), where the row is 0.2 0.3 0.2 0.6 ...; runs to the right by eight texels per unit of
    // lambda.
    const Logged logged = traceLogged(*makeTracer({"max-pyramid-paper", {}}, field, cache_, work_), {0.5, 1.5, 8, 0});
    std::string words;
    for (const Step& step : logged.steps) {
        words += std::string(decisionName(step.decision)) + " " + std::to_string(step.level) + " (" +
                 std::to_string(step.i) + "," + std::to_string(step.j) + ")\n";
    }
    EXPECT_EQ(words,
              "start 3 (0,0)\n"
              "advance 3 (0,0)\n"
              "descend 3 (0,0)\n"  // 0.9 is not below 0.0625, where the ray leaves the texture
              "descend 2 (0,0)\n"  // 0.9 against 0.5625
              "descend 1 (0,0)\n"  // 0.9 against 0.8125
              "skip 0 (1,1)\n"     // 0.3 is below 0.8125
              "ascend 1 (0,0)\n"   // the 0.9 exists, but not on the ray's projection
              "descend 1 (1,0)\n"  // 0.6 against 0.5625
              "skip 0 (2,1)\n"     // 0.2 is below 0.6875
              "hit 0 (3,1)\n");    // the top of the column 0.6, at lambda 0.4
    EXPECT_NEAR(logged.hit.lambda, 0.4, 1e-7);
    EXPECT_EQ(logged.hit.outcome, Outcome::Hit);
}

}  // namespace
}  // namespace relief::test
