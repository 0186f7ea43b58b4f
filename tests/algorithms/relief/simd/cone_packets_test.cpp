// Packets of neighbouring rays find the candidates that each ray finds by itself.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "cone_cells.h"
#include "lanes.h"
#include "relief/methods/cone_walk.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261126;

// A view in which neighbouring pixels are `apart` texels from each other, in squares of 4 x 4 pixels, after some single
// rays, so that the squares do not begin where vectors do. (a, b): run of the first ray, in slab heights.
RayBlock squares(const HeightField& field, double apart, double a, double b) {
    RayBlock rays;
    const auto ray = [&](double x, double y) {
        const double s = 40.3 + apart * x, t = 38.2 + apart * y;
        rays.push({s, t, a * (1 + 2e-4 * x) * field.slabTexels(), b * (1 + 3e-4 * y) * field.slabTexels()});
    };
    for (int n = 0; n < 5; ++n) ray(-3.0 * n, -20);
    for (int n = 0; n < 96; ++n) {
        for (int k = 0; k < 16; ++k) ray(n % 12 * 4 + k % 4, n / 12 * 4 + k / 4);
    }
    return rays;
}

struct Counts {
    std::size_t rays = 0, inPackets = 0, misses = 0, decided = 0;
};

void expectSame(const HeightField& field, const RayBlock& rays, Counts& counts) {
    Work work(1);
    MapCache cache;
    const auto cones = packedCones(field, cache, work);
    const ConeWalk walk(field, *cones);
    NullSink none;
    std::vector<Hit> expected;
    for (std::size_t i = 0; i < rays.size(); ++i) expected.push_back(walk.trace(rays[i], none));
    onEveryTarget([&] {
        HitBlock hits;
        const auto lanes = cellsInLanes(field, *cones, rays, hits, false);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(sameBits(expected[i], hits[i]))
                << describe(field) << ", ray " << i << ": " << describe(rays[i]);
            ++counts.rays;
            counts.misses += hits[i].outcome == Outcome::Miss ? 1 : 0;
            if (!lanes[i].candidate) continue;
            ++counts.inPackets;
            // The reference, begun in the candidate cell before the hit, tests this cell. At corners it may reject it,
            // as the leaf does for the packet, and hit in the next one.
            const GridRay exact(walk.scene().grid, rays[i]);
            const auto [x, y] = *lanes[i].candidate;
            const CellGrid& grid = walk.scene().grid;
            // Lambda at which the ray enters and leaves the cell along an axis.
            const auto passes = [](const RayAxis& ray, const GridAxis& axis, std::int64_t cell) {
                const auto base =
                    axis.wraps
                        ? static_cast<std::int64_t>(std::floor(static_cast<double>(cell) / axis.cells)) * axis.cells
                        : 0;
                const auto index = static_cast<int>(cell - base);
                return std::pair(ray.enter(axis, index, index + 1, base), ray.leave(axis, index, index + 1, base));
            };
            const auto [inX, outX] = passes(exact.x, grid.x, x);
            const auto [inY, outY] = passes(exact.y, grid.y, y);
            const double in = std::max({inX, inY, 0.0});
            // Float cannot tell cells apart in which a ray is for less than this.
            constexpr double kRounding = 1e-4;
            EXPECT_LE(in, std::min(outX, outY) + kRounding)
                << describe(field) << ", ray " << i << " leaves its packet where it does not pass";
            // Not where the hit is next to a border, since a walk cannot begin between the two.
            constexpr double kApart = 1e-6;
            if (!lanes[i].cells.empty() || hits[i].outcome != Outcome::Hit) continue;
            if (!(in + kApart < hits[i].lambda)) continue;
            LogSink sink;
            const Hit hit = walk.trace(rays[i], (in + hits[i].lambda) / 2, sink, sink);
            EXPECT_TRUE(sameBits(hit, hits[i])) << i;
            const bool tests = std::ranges::any_of(sink.steps, [&](const Step& step) {
                return (step.decision == Decision::Hit || step.decision == Decision::Test) &&
                       std::int64_t{step.i} - grid.x.firstName + std::int64_t{step.periodX} * grid.x.cells == x &&
                       std::int64_t{step.j} - grid.y.firstName + std::int64_t{step.periodY} * grid.y.cells == y;
            });
            EXPECT_TRUE(tests) << describe(field) << ", ray " << i << ": " << describe(rays[i]);
            ++counts.decided;
        }
    });
}

TEST(ConePackets, findTheHitsOfTheReference) {
    Counts counts;
    for (const char* name : {"spikes", "bricks", "fractal"}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
                const HeightField field(share(makeRelief(name, 96, 80, kSeed)), surface, address, 0.15);
                // All quadrants and both long axes; along the diagonal, so that rays pass corners; steep and flat.
                expectSame(field, squares(field, 0.04, 3, 1.7), counts);
                expectSame(field, squares(field, 0.3, -1.1, 4), counts);
                expectSame(field, squares(field, 0.125, 2, -2), counts);
                expectSame(field, squares(field, 0.2, -6, -0.01), counts);
            }
        }
    }
    std::printf("%zu rays, %zu left packets at candidates, %zu of these checked; %zu misses\n", counts.rays,
                counts.inPackets, counts.decided, counts.misses);
    EXPECT_GT(counts.misses, counts.rays / 100);
    // Packets need vectors of 16 rays.
    if (counts.inPackets == 0) GTEST_SKIP() << "no packets on this processor";
    EXPECT_GT(counts.inPackets, counts.rays / 10);
    EXPECT_GT(counts.decided, counts.inPackets / 2);
}

// Rays that begin and run exactly on lines and through corners, over terraces whose edges are on lines.
TEST(ConePackets, alongLinesAndThroughCorners) {
    Counts counts;
    FloatImage heights(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) heights(x, y) = static_cast<float>((x / 4 * 5 + y / 8 * 3) % 7) / 8.0F;
    }
    for (const Surface surface : allSurfaces()) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            const HeightField field(share(heights), surface, address, 0.25);
            for (const double run : {32.0, -32.0}) {
                RayBlock rays;
                for (int n = 0; n < 1040; ++n) {
                    // Some pass exactly through corners.
                    const double s = 30 + 0.0625 * (n % 4) + 0.5 * (n / 64), t = 30.5 + 0.0625 * (n / 4 % 4);
                    rays.push({s, t, run + n * 1e-9, run});
                }
                expectSame(field, rays, counts);
            }
        }
    }
    std::printf("%zu rays, %zu left packets at candidates, %zu of these checked\n", counts.rays, counts.inPackets,
                counts.decided);
    if (counts.inPackets == 0) GTEST_SKIP() << "no packets on this processor";
    EXPECT_GT(counts.inPackets, counts.rays / 20);
}

}  // namespace
}  // namespace relief::test
