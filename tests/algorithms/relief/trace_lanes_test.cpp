// Laws of the lanes: the bits of the scalar text, for every instruction set, number of rays, surface and addressing.
#include <gtest/gtest.h>

#include "fields.h"
#include "mapping/rows/row_lanes.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261121;
// Rays a field; a hundred times as many with RELIEF_LONG.
std::size_t rayCount() {
    return std::getenv("RELIEF_LONG") != nullptr ? 200000 : 700;
}

const std::vector<std::string>& laneMethods() {
    static const std::vector<std::string> names{"max-pyramid", "cone"};
    return names;
}

// Each target that this machine can run, and at the end the best again.
template <class Body>
void onEveryTarget(const Body& body) {
    for (const std::int64_t target : laneTargets()) {
        SCOPED_TRACE(laneTargetName(target));
        forceLaneTarget(target);
        body();
    }
    forceLaneTarget(0);
}

// Rays of all kinds: random, along the axes, vertical, through texel corners and borders, far away, flat, not finite.
RayBlock awkwardRays(const HeightField& field, std::uint64_t seed, std::size_t count) {
    Random random(seed);
    RayBlock rays;
    for (std::size_t i = 0; i < count; ++i) {
        ViewRay ray = randomRay(random, field, 0.3);
        switch (random.below(16)) {
            case 0:
                ray.a = 0;
                break;
            case 1:
                ray.b = -0.0;
                break;
            case 2:
                ray.s0 = std::floor(ray.s0) + 0.5 * random.below(2), ray.t0 = std::floor(ray.t0);
                break;
            case 3:
                ray.s0 = std::floor(ray.s0) + 0.5, ray.t0 = std::floor(ray.t0) + 0.5;
                ray.b = ray.a = std::floor(ray.a);
                break;
            case 4:
                ray.s0 += field.width() * (random.below(7) - 3);
                break;
            case 5:
                ray.a *= 1e-9, ray.b *= 1e-7;
                break;
            case 8:
                ray.s0 = random.below(field.width() + 1), ray.t0 = random.below(field.height() + 1);
                ray.a = ray.b = random.below(2) == 0 ? 0.0 : -0.0;
                break;
            case 9:
                (random.below(2) == 0 ? ray.a : ray.b) = random.below(2) == 0 ? -1e-200 : 1e-40;
                break;
            case 6:
                ray.a *= 1e-3;
                break;
            case 7:
                if (random.below(20) == 0) ray.a = std::numeric_limits<double>::quiet_NaN();
                if (random.below(20) == 0) ray.b = 3e6;
                break;
            case 10:
            case 11:
                // Next to a line, by one rounding.
                for (double* place : {&ray.s0, &ray.t0}) {
                    const double line = std::floor(*place) + 0.5 * random.below(2);
                    const double side = random.below(2) == 0 ? -1.0 : 1.0;
                    *place = random.below(3) == 0 ? *place : std::nextafter(line, line + side);
                }
                break;
            default:
                break;
        }
        rays.push(ray);
    }
    return rays;
}

void expectTwins(const HeightField& field, const std::string& name, const RayBlock& rays, MapCache& cache) {
    Work work(1);
    const auto tracer = makeTracer({name, {}}, field, cache, work);
    HitBlock scalar;
    BlockCounts counts;
    tracer->trace(rays, scalar, counts, work);
    onEveryTarget([&] {
        HitBlock lanes;
        NullSink sink;
        tracer->trace(rays, lanes, sink, work);
        std::size_t different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (sameBits(scalar[i], lanes[i])) continue;
            if (++different > 3) continue;
            ADD_FAILURE() << name << ", " << describe(field) << ", ray " << i << ": " << describe(rays[i])
                          << ": scalar " << static_cast<int>(scalar.outcome[i]) << " " << numberText(scalar.lambda[i])
                          << ", lanes " << static_cast<int>(lanes.outcome[i]) << " " << numberText(lanes.lambda[i]);
        }
        EXPECT_EQ(different, 0U);
    });
}

void expectTwinsEverywhere(const Heights& heights, std::uint64_t seed) {
    MapCache cache;
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const double depth : {0.02, 0.1, 0.9}) {
                const HeightField field(heights, surface, address, depth);
                const RayBlock rays = awkwardRays(field, seed, rayCount());
                for (const std::string& name : laneMethods()) expectTwins(field, name, rays, cache);
            }
        }
    }
}

TEST(Lanes, haveTheBitsOfTheScalarTextOnEveryRelief) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (!recipe.anySize) continue;
        const std::string name(recipe.name);
        SCOPED_TRACE(name);
        expectTwinsEverywhere(share(makeRelief(name, 128, 128, kSeed)), kSeed);
    }
}

TEST(Lanes, haveTheBitsOfTheScalarTextOnAwkwardSizes) {
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{
             {1, 1}, {1, 7}, {2, 2}, {3, 1}, {5, 3}, {16, 17}, {33, 64}, {100, 3}, {257, 31}}) {
        expectTwinsEverywhere(randomHeights(width, height, kSeed), kSeed + static_cast<std::uint64_t>(width));
        expectTwinsEverywhere(constantHeights(width, height, 0.25F), kSeed);
    }
    for (const float value : {0.0F, 1.0F}) expectTwinsEverywhere(constantHeights(9, 9, value), kSeed);
}

TEST(Lanes, haveTheBitsOfTheScalarTextForAnyNumberOfRaysAndThreads) {
    const HeightField field(randomHeights(60, 60, kSeed));
    MapCache cache;
    for (const std::size_t count : {0, 1, 2, 7, 15, 16, 17, 31, 511, 512, 513, 1030}) {
        const RayBlock rays = awkwardRays(field, kSeed, count);
        for (const std::string& name : laneMethods()) expectTwins(field, name, rays, cache);
    }
    const RayBlock rays = awkwardRays(field, kSeed, 20000);
    for (const std::string& name : laneMethods()) {
        Work one(1), three(3);
        const auto tracer = makeTracer({name, {}}, field, cache, one);
        HitBlock alone, together;
        NullSink sink;
        tracer->trace(rays, alone, sink, one);
        tracer->trace(rays, together, sink, three);
        for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_TRUE(sameBits(alone[i], together[i])) << i;
    }
}

}  // namespace
}  // namespace relief::test
