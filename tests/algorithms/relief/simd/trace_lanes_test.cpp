// SIMD tracing gives the bits of the reference, for every instruction set, number of rays, surface and addressing.
#include <gtest/gtest.h>

#include "lanes.h"
#include "relief/maps/cone_map.h"
#include "relief/maps/packed_cones.h"
#include "relief/methods/distance_conservative.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261121;
// Rays per field; a hundred times as many with RELIEF_LONG.
std::size_t rayCount() {
    return std::getenv("RELIEF_LONG") != nullptr ? 200000 : 700;
}

const std::vector<MethodChoice>& jumps() {
    static const std::vector<MethodChoice> all{{"max-pyramid", {}}, {"cone", {}}};
    return all;
}
// Building their maps takes long.
const std::vector<MethodChoice>& voxelWalks() {
    static const std::vector<MethodChoice> all{
        {"distance-conservative", {{"layers", "5"}}},
        {"distance-conservative", {{"footprint", "4"}, {"layers", "16"}, {"rule", "classic"}}},
        {"distance-refined", {{"footprint", "2"}, {"layers", "7"}, {"sectors", "4"}, {"horizons", "8"}}},
        {"distance-refined", {{"footprint", "3"}, {"layers", "6"}, {"flattest", "40"}, {"horizons", "4"}}}};
    return all;
}

void expectSameBitsEverywhere(const std::vector<MethodChoice>& methods, const std::vector<double>& depths,
                              const Heights& heights, std::uint64_t seed) {
    MapCache cache;
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const double depth : depths) {
                const HeightField field(heights, surface, address, depth);
                const RayBlock rays = awkwardRays(field, seed, rayCount());
                for (const MethodChoice& method : methods) expectSameBits(field, method, rays, cache);
            }
        }
    }
}
void expectSameBitsEverywhere(const Heights& heights, std::uint64_t seed) {
    expectSameBitsEverywhere(jumps(), {0.02, 0.1, 0.9}, heights, seed);
}

TEST(Lanes, haveTheBitsOfTheReferenceOnEveryRelief) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (!recipe.anySize) continue;
        const std::string name(recipe.name);
        SCOPED_TRACE(name);
        expectSameBitsEverywhere(share(makeRelief(name, 128, 128, kSeed)), kSeed);
    }
}

TEST(Lanes, haveTheBitsOfTheReferenceOnAwkwardSizes) {
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{
             {1, 1}, {1, 7}, {2, 2}, {3, 1}, {5, 3}, {16, 17}, {33, 64}, {100, 3}, {257, 31}}) {
        expectSameBitsEverywhere(randomHeights(width, height, kSeed), kSeed + static_cast<std::uint64_t>(width));
        expectSameBitsEverywhere(constantHeights(width, height, 0.25F), kSeed);
    }
    for (const float value : {0.0F, 1.0F}) expectSameBitsEverywhere(constantHeights(9, 9, value), kSeed);
}

// These maps have more entries than float has integers, and rows longer than their cells.
TEST(Lanes, haveTheBitsOfTheReferenceOnMapsOfManyEntries) {
    const Heights heights = std::make_shared<FloatImage>(makeRelief("fractal", 2101, 2005, 3));
    MapCache cache;
    for (const Address address : allAddresses()) {
        const HeightField field(heights, Surface::Bilinear, address, 0.1);
        Work work(2);
        const auto cones = packedCones(field, cache, work);
        ASSERT_GE(cones->quadrantEntries(), kWideEntries);
        ASSERT_GT(cones->stride, cones->nx + 1);
        expectSameBits(field, {"cone", {}}, awkwardRays(field, kSeed + 9, rayCount()), cache);
    }
}

TEST(Lanes, haveTheBitsOfTheReferenceForAnyNumberOfRaysAndThreads) {
    const HeightField field(randomHeights(60, 60, kSeed));
    MapCache cache;
    for (const std::size_t count : {0U, 1U, 2U, 7U, 15U, 16U, 17U, 31U, 511U, 512U, 513U, 1030U}) {
        const RayBlock rays = awkwardRays(field, kSeed, count);
        for (const MethodChoice& method : jumps()) expectSameBits(field, method, rays, cache);
    }
    const RayBlock rays = awkwardRays(field, kSeed, 20000);
    for (const MethodChoice& method : jumps()) {
        Work one(1), three(3);
        const auto tracer = makeTracer(method, field, cache, one);
        HitBlock alone, together;
        NullSink sink;
        tracer->trace(rays, alone, sink, one);
        tracer->trace(rays, together, sink, three);
        for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_TRUE(sameBits(alone[i], together[i])) << i;
    }
}

// Rays that pass the edges of a stair by less than the resolution of float: the exact leaf rejects candidate after
// candidate, hundreds in one chunk.
TEST(Lanes, haveTheBitsOfTheReferenceWhereManyCandidatesAreRejected) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    constexpr int kSteps = 16, kTread = 8, kRows = 24;
    constexpr double kClearance = 2e-7;  // largest clearance, relative to the height
    auto stair = std::make_shared<FloatImage>(kSteps * kTread, kRows);
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < stair->width(); ++x) (*stair)(x, y) = 1 - static_cast<float>(x / kTread + 1) / kSteps;
    }
    Random random(kSeed);
    RayBlock rays;
    for (int i = 0; i < 1500; ++i) {
        ViewRay ray;
        ray.a = stair->width();
        ray.s0 = random.unit() * kClearance * ray.a;
        ray.t0 = kRows * random.unit();
        ray.b = random.below(4) == 0 ? 8 * random.unit() - 4 : 0;
        // Some leave the stair early.
        if (random.below(3) == 0) ray.a *= 1 + 0.5 * random.unit();
        rays.push(ray);
    }
    MapCache cache;
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const MethodChoice& method : jumps()) {
                expectSameBits(HeightField(stair, surface, address, 0.1), method, rays, cache);
            }
        }
    }
}

TEST(Lanes, haveTheBitsOfTheReferenceThroughVoxels) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    for (const char* name : {"bricks", "spikes", "fractal"}) {
        SCOPED_TRACE(name);
        expectSameBitsEverywhere(voxelWalks(), {0.02, 0.3}, share(makeRelief(name, 64, 64, kSeed)), kSeed);
    }
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {5, 3}, {33, 14}, {60, 3}}) {
        expectSameBitsEverywhere(voxelWalks(), {0.0, 0.9}, randomHeights(width, height, kSeed), kSeed);
    }
    for (const float value : {0.0F, 1.0F}) {
        expectSameBitsEverywhere(voxelWalks(), {0.3}, constantHeights(9, 9, value), kSeed);
    }
}

// A cone map from a file must be used as it is, since the user wants to see its effect, wrong results included, with a
// log and without.
TEST(Lanes, coneMapsFromFilesAreUsedAsTheyAre) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    const HeightField field(share(makeRelief("spikes", 50, 50, kSeed)), Surface::Bilinear, Address::Repeat, 0.5);
    Work work(2);
    MapCache cache;
    ConeMap map = buildConeMap(ConeKind::Conservative, {}, field, work);
    const UnfilledVector<float> nothing(map.slopes.codes().index() == 0 ? std::get<0>(map.slopes.codes()).size() : 0,
                                        0.0F);
    // These cones contain the whole space above the cell, so most of the relief is missed.
    map.slopes = StoredValues(map.nx(), map.ny(), 1, nothing, Precision::Float, Rounding::Up);
    cache.put(coneMapKey(ConeKind::Conservative, {}, field), std::make_shared<const ConeMap>(std::move(map)));
    const auto tracer = makeTracer({"cone", {{"layout", "texel"}}}, field, cache, work);
    const auto exact = makeTracer({"exact", {}}, field, cache, work);
    const RayBlock rays = awkwardRays(field, kSeed, 4 * rayCount());
    HitBlock logged, plain, right;
    BlockCounts counts;
    NullSink sink;
    tracer->trace(rays, logged, counts, work);
    tracer->trace(rays, plain, sink, work);
    exact->trace(rays, right, sink, work);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_TRUE(sameBits(logged[i], plain[i])) << i << ": " << describe(rays[i]);
        wrong += sameBits(plain[i], right[i]) ? 0 : 1;
    }
    EXPECT_GT(wrong, rays.size() / 50) << "the map's error is too small for the test";
}

// With an unsafe map the traversal itself is the same as the reference's, not only its result.
TEST(Lanes, traverseUnsafeMapsAsTheReferenceDoes) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    for (const StepRule rule : {StepRule::Exit, StepRule::Classic}) {
        for (const Address address : allAddresses()) {
            const HeightField field(share(makeRelief("spikes", 50, 50, kSeed)), Surface::Bilinear, address, 0.5);
            DistanceParameters parameters;
            parameters.footprint = 3;
            parameters.layers = 9;
            Work work(2);
            DistanceMap map = buildDistanceMap(DistanceKind::EuclideanConservative, parameters, field, work);
            auto values = std::get<0>(map.values.codes());
            for (float& value : values) value = value < 0 ? value : 1.7F * value + 0.4F;
            map.values = StoredValues(map.nx(), map.ny(), 9, std::move(values), Precision::Float, Rounding::Down);
            const DistanceWalk walk(field, std::make_shared<const DistanceMap>(std::move(map)), rule);
            const DistanceConservativeTracer exact =
                DistanceConservativeTracer(field,
                                           std::make_shared<const DistanceMap>(buildDistanceMap(
                                               DistanceKind::EuclideanConservative, parameters, field, work)),
                                           rule);
            const RayBlock rays = awkwardRays(field, kSeed, 4 * rayCount());
            NullSink sink;
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                wrong += sameBits(walk.trace(rays[i], sink), exact.trace(rays[i], sink)) ? 0 : 1;
            }
            EXPECT_GT(wrong, rays.size() / 50) << "the map's error is too small for the test";
            onEveryTarget([&] {
                HitBlock lanes(rays.size());
                walk.traceSimd(rays, 0, rays.size(), lanes);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    ASSERT_TRUE(sameBits(walk.trace(rays[i], sink), lanes[i])) << i << ": " << describe(rays[i]);
                }
            });
        }
    }
}

// Additional data of SIMD versions count as memory, too; cones are used by both.
TEST(Lanes, useTheMapOfTheReference) {
    MapCache cache;
    Work work(2);
    const HeightField field(randomHeights(40, 24, kSeed), Surface::Bilinear, Address::Repeat, 0.2);
    for (const MethodChoice& method : jumps()) {
        const auto reference = makeTracer(method, field, cache, work, Form::Scalar);
        EXPECT_EQ(makeTracer(method, field, cache, work)->bytes(), reference->bytes()) << method.name;
    }
    const auto bytesOf = [&](const char* name) { return makeTracer({name, {}}, field, cache, work)->bytes(); };
    EXPECT_GT(bytesOf("max-pyramid"), bytesOf("max-pyramid-paper")) << "the depths are not counted";
}

}  // namespace
}  // namespace relief::test
