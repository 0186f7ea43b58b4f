// The scalar fallback for rays that SIMD cannot resolve: it finds the hit of `exact` from any start before the hit, and
// SIMD hands rays over at a point before the hit.
#include "relief/simd/packed_parts.h"

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/leaf.h"
#include "relief/methods/cone_walk.h"
#include "relief/simd/cone_lanes.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261122;
constexpr std::size_t kRays = 300;
// Rays over needles that cross a whole map: enough that SIMD rejects some hundred candidates.
constexpr int kWide = 512;
constexpr std::size_t kManyRays = 60000;
constexpr std::size_t kLeastRefused = 30;
constexpr std::size_t kLeastUnclear = 30;

RayBlock walkable(const HeightField& field, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const CellGrid grid(field);
    RayBlock rays;
    while (rays.size() < count) {
        const ViewRay ray = randomRay(random, field, 0.3);
        if (packedWalks(grid, ray)) rays.push(ray);
    }
    return rays;
}

HitBlock exactHits(const HeightField& field, const RayBlock& rays) {
    Work work(2);
    MapCache cache;
    HitBlock hits;
    NullSink sink;
    makeTracer({"exact", {}}, field, cache, work)->trace(rays, hits, sink, work);
    return hits;
}

TEST(PackedWalk, findsTheHitFromAnyPlaceBeforeIt) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    const Heights heights = randomHeights(37, 24, kSeed);
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const double depth : {0.02, 0.9}) {
                const HeightField field(heights, surface, address, depth);
                SCOPED_TRACE(describe(field));
                Work work(1);
                const PackedCones cones = buildPackedCones(field, work);
                const CellGrid grid(field);
                const RayBlock rays = walkable(field, kRays, kSeed);
                const HitBlock exact = exactHits(field, rays);
                for (const double share : {0.0, 0.5, 0.999, 1.0}) {
                    std::vector<PackedStart> starts;
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                        starts.push_back({i, exact.outcome[i] == Outcome::Hit ? share * exact.lambda[i] : 0});
                    }
                    HitBlock hits(rays.size());
                    packedHits({field, grid, cones}, rays, starts, hits);
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                        ASSERT_TRUE(sameBits(hits[i], exact[i])) << "ray " << i << " from " << share;
                    }
                }
            }
        }
    }
}

// Traverses each ray from a point before its hit for a random length.
void partsOf(const HeightField& field) {
    SCOPED_TRACE(describe(field));
    Work work(1);
    const PackedCones cones = buildPackedCones(field, work);
    const CellGrid grid(field);
    const RayBlock rays = walkable(field, kRays, kSeed);
    const HitBlock exact = exactHits(field, rays);
    Random random(kSeed);
    std::vector<PackedPart> parts;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (GridRay(grid, rays[i]).entersOutside(grid)) continue;
        const double from = exact.outcome[i] == Outcome::Hit ? random.unit() * exact.lambda[i] : 0;
        parts.push_back({i, from, from + random.unit() * (1 - from)});
    }
    packedParts({field, grid, cones}, rays, parts);
    std::size_t ended = 0;
    for (const PackedPart& part : parts) {
        SCOPED_TRACE("ray " + std::to_string(part.ray));
        ended += part.ended ? 1 : 0;
        if (part.ended) {
            ASSERT_TRUE(sameBits(part.hit, exact[part.ray]));
            continue;
        }
        const GridRay ray(grid, rays[part.ray]);
        const CellInterval interval = cellInterval(grid, ray, part.x, part.y);
        EXPECT_LT(interval.in, interval.out);
        EXPECT_GT(interval.out, part.until);
        if (exact.outcome[part.ray] == Outcome::Hit) {
            EXPECT_LE(interval.in, exact.lambda[part.ray]);
        }
    }
    EXPECT_GT(ended, 0U);
    EXPECT_LT(ended, parts.size());
}

// Where the ray hardly moves along an axis, crossings in float are imprecise; the walk in double must still not begin
// at the ray's start again.
TEST(PackedWalk, aRayThatHardlyMovesAlongAnAxisIsWalkedOnce) {
    const HeightField field(share(makeRelief("spikes", 33, 2, 764250)), Surface::Bilinear, Address::Repeat, 0.02);
    Work work(1);
    MapCache cache;
    const auto tracer = makeTracer({"cone", {}}, field, cache, work);
    for (const double run : {0.0, -1e-17, -1e-9, 1e-7}) {
        RayBlock rays;
        rays.push({2.0428060188460733, 1.1852827161587962, run, -1282.2770637867904});
        HitBlock hits;
        BlockCounts counts;
        tracer->trace(rays, hits, counts, work);
        EXPECT_TRUE(sameBits(hits[0], exactHits(field, rays)[0])) << run;
        EXPECT_LE(hits.steps[0], GridRay(CellGrid(field), rays[0]).cellBound()) << run;
    }
}

// A part ends with the hit of `exact`, or in the cell in which the ray is after `until`.
TEST(PackedWalk, partsEndAtTheHitOrWhereTheRayIs) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    const Heights heights = randomHeights(37, 24, kSeed);
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) partsOf(HeightField(heights, surface, address, 0.9));
    }
}

TEST(PackedWalk, simdHandsRaysOverBeforeTheirHits) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    for (const Address address : allAddresses()) {
        const HeightField field(share(makeRelief("spikes", kWide, kWide, 1)), Surface::Bilinear, address, 0.3);
        SCOPED_TRACE(describe(field));
        Work work(2);
        const PackedCones cones = buildPackedCones(field, work);
        const RayBlock rays = walkable(field, kManyRays, kSeed);
        const HitBlock exact = exactHits(field, rays);
        const FloatScene scene(field, cones);
        const auto scratch = std::make_unique<LaneRays>();
        HitBlock hits(rays.size());
        std::size_t refused = 0, unclear = 0;
        for (std::size_t first = 0; first < rays.size(); first += kLaneChunk) {
            const std::size_t last = std::min(first + kLaneChunk, rays.size());
            traceConeLanes(scene, cones, rays, first, last, hits, *scratch);
            for (std::size_t n = 0; n < scratch->othersCount; ++n) {
                const LaneRays::Other& other = scratch->others[n];
                const std::size_t i = first + other.ray;
                if (other.end != LaneEnd::FalseCandidate && other.end != LaneEnd::Ambiguous) continue;
                ++(other.end == LaneEnd::FalseCandidate ? refused : unclear);
                const auto cell = [&](const LaneAxisRays& axis) {
                    return AxisCell{axis.hitCell[other.ray], axis.hitPeriod[other.ray]};
                };
                const AmbiguousPart part(scene.grid, GridRay(scene.grid, rays[i]), cell(scratch->x), cell(scratch->y));
                EXPECT_LT(part.from, part.until);
                if (exact.outcome[i] == Outcome::Hit) {
                    ASSERT_LE(part.from, exact.lambda[i]) << "ray " << i;
                }
            }
        }
        EXPECT_GE(refused, kLeastRefused) << "the property is not tested";
        EXPECT_GE(unclear, kLeastUnclear) << "the property is not tested";
    }
}

}  // namespace
}  // namespace relief::test
