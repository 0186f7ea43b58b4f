// The displayed steps are those that rendered the pixel: SIMD visits the pyramid's nodes that the reference logs, one
// by one.
#include "depth_nodes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "images/height_rows.h"
#include "images/tiled_heights.h"
#include "images/tiled_writer.h"
#include "lanes.h"
#include "relief/files.h"
#include "relief/methods/max_pyramid.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261125;

// The nodes of the steps in float, which SIMD takes as well; steps in double are left to the reference.
std::vector<VisitedNode> loggedNodes(const MaxPyramidTracer& tracer, const ViewRay& ray) {
    std::vector<VisitedNode> nodes;
    if (!ray.finite()) return nodes;
    LogSink sink;
    NullSink inDouble;
    tracer.trace(ray, sink, inDouble);
    const CellGrid& grid = tracer.pyramidWalk().grid();
    for (const Step& step : sink.steps) {
        const bool visits = step.tests() || step.decision == Decision::Skip || step.decision == Decision::Descend;
        if (!visits) continue;
        const bool cell = step.level == 0;
        nodes.push_back(
            {step.level, step.i - (cell ? grid.x.firstName : 0), step.j - (cell ? grid.y.firstName : 0), step.value});
    }
    return nodes;
}

// Least number of steps to compare on each instruction set. With this seed, the test with fewer compares 21,407.
constexpr std::size_t kLeastSteps = 20000;

struct Seen {
    std::size_t rays = 0, steps = 0, different = 0;
};

void compare(const HeightField& field, const RayBlock& rays, bool asTheReference, Seen& seen) {
    Work work(1);
    MapCache cache;
    const MaxPyramidTracer tracer = MaxPyramidTracer::make(field, {}, cache, work);
    const auto depths = depthPyramid(field, tracer.pyramidWalk().map(), cache, work);
    const DepthWalk walk(tracer.pyramidWalk(), *depths);
    std::vector<std::vector<VisitedNode>> reference;
    for (std::size_t i = 0; i < rays.size(); ++i) reference.push_back(loggedNodes(tracer, rays[i]));
    onEveryTarget([&] {
        HitBlock hits;
        const auto lanes = nodesInLanes(walk.scene(), *depths, rays, hits, asTheReference);
        ASSERT_EQ(lanes.size(), rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ++seen.rays;
            seen.steps += reference[i].size();
            if (lanes[i] == reference[i]) continue;
            ++seen.different;
            if (!asTheReference || seen.different > 3) continue;
            const auto at =
                std::mismatch(reference[i].begin(), reference[i].end(), lanes[i].begin(), lanes[i].end()).first -
                reference[i].begin();
            ADD_FAILURE() << describe(field) << ", ray " << i << ": " << describe(rays[i]) << ": step " << at << " of "
                          << reference[i].size() << " and " << lanes[i].size();
        }
    });
}

TEST(DepthNodes, simdVisitsThoseThatTheReferenceLogs) {
    constexpr std::size_t kRays = 400;
    Seen seen;
    onAwkwardMaps(kSeed, kRays,
                  [&](const HeightField& field, const RayBlock& rays) { compare(field, rays, true, seen); });
    std::printf("%zu steps of %zu rays\n", seen.steps, seen.rays);
    EXPECT_GT(seen.steps, kLeastSteps * laneTargets().size());
}

// Of a map that is read by tiles: codes of 8 and 16 bits, and floats; with bounds of memory within which the heights'
// tiles stay, or are dropped again and again. The lower levels of the pyramid are read from the tiles.
TEST(DepthNodes, simdVisitsThemInMapsReadByTiles) {
    constexpr int kWidth = 1000, kHeight = 700;
    const testing::TemporaryFolder folder;
    Work work;
    const FloatImage heights = makeRelief("fractal", kWidth, kHeight, kSeed);
    ColorImage grey(kWidth, kHeight);
    std::transform(heights.pixels().begin(), heights.pixels().end(), grey.pixels().begin(),
                   [](float h) { return Color(h); });
    writeColor(folder / "8.png", grey);
    writeHeight(folder / "16.png", heights);
    writeHeight(folder / "float.exr", heights, true);
    Seen seen;
    for (const char* name : {"8.png", "16.png", "float.exr"}) {
        SCOPED_TRACE(name);
        TiledWriter(*pictureHeightRows(folder / name, {}), folder / "map.tif", {}).write(work);
        for (const std::size_t megabytes : {1U, 5U}) {
            const std::shared_ptr<const TiledHeights> tiles = TiledHeights::open(folder / "map.tif", megabytes << 20U);
            for (const Address address : allAddresses()) {
                const HeightField field(tiles, Surface::Bilinear, address, 0.05);
                EXPECT_GT(TiledPyramid(field, work).firstKept(), 0);
                Random random(kSeed);
                RayBlock rays;
                for (int n = 0; n < 100; ++n) rays.push(randomRay(random, field, 0.3));
                compare(field, rays, true, seen);
            }
        }
    }
    EXPECT_GT(seen.steps, kLeastSteps * laneTargets().size());
}

// Sums are fused: largest share of rays that leave a node within a rounding of its depth or of a corner, and so visit
// other nodes.
constexpr double kMostDifferent = 0.001;

TEST(DepthNodes, shippedSimdDiffersInRoundingOnly) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    Seen seen;
    for (const char* name : {"spikes", "bricks", "fractal"}) {
        for (const Surface surface : allSurfaces()) {
            const HeightField field(share(makeRelief(name, 96, 96, kSeed)), surface, Address::Repeat, 0.2);
            Random random(kSeed);
            RayBlock rays;
            for (int n = 0; n < 4000; ++n) rays.push(randomRay(random, field, 0.3));
            compare(field, rays, false, seen);
        }
    }
    std::printf("%zu steps of %zu rays; %zu rays differ\n", seen.steps, seen.rays, seen.different);
    EXPECT_GT(seen.steps, 100000U);
    EXPECT_LT(static_cast<double>(seen.different), kMostDifferent * static_cast<double>(seen.rays));
}

}  // namespace
}  // namespace relief::test
