// Any-hit queries in SIMD against their reference: the same results and the same cells, for every target.
#include <iostream>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "algorithms/relief/fields.h"
#include "algorithms/relief/simd/lane_steps.h"
#include "relief/visibility/any_hit.h"

namespace relief::test {
namespace {

// Segments from any point, or from the surface itself (as for shadows and footprints); with zero components, starts on
// grid lines, and values that must not be traced.
AnyRay segmentFor(Random& random, const HeightField& field) {
    const double reach = random.between(0, 2) * field.width();
    const double azimuth = random.between(0, 7);
    AnyRay ray{random.between(-1, field.width() + 1.0),
               random.between(-1, field.height() + 1.0),
               random.between(-0.1, 1.1),
               reach * std::cos(azimuth),
               reach * std::sin(azimuth),
               random.between(-1, 1)};
    if (random.below(7) == 0) ray.s = std::floor(ray.s);
    if (random.below(7) == 0) ray.t = std::floor(ray.t) + 0.5;
    if (random.below(2) == 0) {
        ray.z = field.at(ray.s, ray.t);
        ray.dz = 1 - ray.z;
    }
    if (random.below(8) == 0) ray.ds = 0;
    if (random.below(8) == 0) ray.dt = 0;
    if (random.below(8) == 0) ray.dz = 0;
    if (random.below(9) == 0) ray.dt = ray.ds;
    if (random.below(400) == 0) ray.dz = std::numeric_limits<double>::quiet_NaN();
    if (random.below(50) == 0) ray.ds = -1e-301;
    // So flat that the reference gives up; only a few, because they take long.
    if (random.below(20000) == 0) ray.ds = 3e6, ray.z = ray.dz = 0.5;
    return ray;
}

TEST(AnyHitLanes, AnswerAsTheReference) {
    constexpr std::uint64_t kSeed = 131;
    constexpr std::size_t kSegments = 19000;
    std::size_t rays = 0;
    std::array<std::size_t, 3> answers{};
    MapCache cache;
    Work work(2);
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            Random random(kSeed);
            for (const ReliefRecipe& recipe : reliefRecipes()) {
                const std::string relief(recipe.name);
                const HeightField field(
                    share(relief == "paper8x8" ? makeRelief(relief, 8, 8, 3) : makeRelief(relief, 75, 52, 3)), surface,
                    address, 0.3);
                SCOPED_TRACE(describe(field) + " " + relief + " seed " + std::to_string(kSeed));
                const auto query = makeAnyHit({"packed-cone-any", {}}, field, cache, work);
                AnyRayBlock block(kSegments);
                for (std::size_t i = 0; i < block.size(); ++i) block.set(i, segmentFor(random, field));
                VisibilityBlock scalar;
                BlockCounts counts;
                query->query(block, scalar, counts, work);
                for (const Visibility visibility : scalar.visibility) ++answers[static_cast<std::size_t>(visibility)];
                rays += block.size();
                onEveryTarget([&] {
                    VisibilityBlock lanes;
                    NullSink null;
                    query->query(block, lanes, null, work);
                    ASSERT_EQ(lanes.visibility, scalar.visibility);
                });
            }
        }
    }
    std::cout << rays << " segments: clear " << answers[0] << ", blocked " << answers[1] << ", limit " << answers[2]
              << "\n";
    EXPECT_GE(rays, 1000000U);
    EXPECT_GT(answers[0], rays / 10);
    EXPECT_GT(answers[1], rays / 10);
    EXPECT_GT(answers[2], 0U);
}

// Blocks shorter than a SIMD vector, maps of single cells and rows.
TEST(AnyHitLanes, AnswerOnAwkwardSizes) {
    MapCache cache;
    Work work(1);
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {1, 9}, {7, 1}, {3, 3}, {17, 2}}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(randomHeights(width, height, 7), surface, address, 0.3);
                SCOPED_TRACE(describe(field));
                const auto query = makeAnyHit({"packed-cone-any", {}}, field, cache, work);
                Random random(132);
                for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 8U, 9U, 500U}) {
                    AnyRayBlock block(count);
                    for (std::size_t i = 0; i < count; ++i) block.set(i, segmentFor(random, field));
                    VisibilityBlock scalar;
                    VisibilityBlock lanes;
                    BlockCounts counts;
                    NullSink null;
                    query->query(block, scalar, counts, work);
                    query->query(block, lanes, null, work);
                    ASSERT_EQ(lanes.visibility, scalar.visibility) << count;
                }
            }
        }
    }
}

// Returns the cells that the reference logs.
LaneSteps loggedCells(const PackedConeAnyHit& query, const AnyRay& ray) {
    LogSink log;
    query.query(ray, log);
    const CellGrid& grid = query.grid();
    LaneSteps cells;
    for (const Step& step : log.steps) {
        if (step.decision == Decision::Start || step.decision == Decision::Miss) continue;
        cells.push_back(
            {static_cast<double>(step.i - grid.x.firstName), static_cast<double>(step.j - grid.y.firstName)});
    }
    return cells;
}

TEST(AnyHitLanes, VisitTheCellsThatTheReferenceLogs) {
    constexpr std::uint64_t kSeed = 133;
    constexpr std::size_t kSegments = 800;
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    std::size_t steps = 0;
    Work work(1);
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {1, 9}, {5, 3}, {33, 18}}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                MapCache cache;
                const HeightField field(randomHeights(width, height, kSeed), surface, address, 0.3);
                const PackedConeAnyHit query = PackedConeAnyHit::make(field, {}, cache, work);
                Random random(kSeed);
                AnyRayBlock block;
                std::vector<LaneSteps> reference;
                while (block.size() < kSegments) {
                    const AnyRay ray = segmentFor(random, field);
                    if (!ray.finite() || !GridRay(query.grid(), ray.course()).inDomain()) continue;
                    block.push(ray);
                    reference.push_back(loggedCells(query, ray));
                    steps += reference.back().size();
                }
                onEveryTarget([&] {
                    const std::vector<LaneSteps> lanes = stepsInLanes(query, block);
                    for (std::size_t i = 0; i < block.size(); ++i) {
                        ASSERT_EQ(lanes[i], reference[i]) << describe(field) << ", segment " << i;
                    }
                });
            }
        }
    }
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 20000U);
}

}  // namespace
}  // namespace relief::test
