// Offset, layers, interpolated distances and cones of texels in SIMD against their references: the same bits, for every
// target.
#include <bit>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "algorithms/relief/fields.h"

namespace relief::test {
namespace {

void expectSameBits(const HitBlock& lanes, const HitBlock& scalar, const RayBlock& rays) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(lanes.outcome[i], scalar.outcome[i]) << describe(rays[i]);
        const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
        ASSERT_EQ(bits(lanes.lambda[i]), bits(scalar.lambda[i])) << describe(rays[i]);
        ASSERT_EQ(bits(lanes.s[i]), bits(scalar.s[i])) << describe(rays[i]);
        ASSERT_EQ(bits(lanes.t[i]), bits(scalar.t[i])) << describe(rays[i]);
    }
}

// Random rays, and rays that are hard to reduce to a period or must not be traced.
RayBlock hardRays(const HeightField& field, std::size_t count) {
    RayBlock rays = randomRays(141, field, count, 3);
    Random random(142);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ViewRay ray = rays[i];
        switch (random.below(12)) {
            case 0:
                ray.a = ray.b = 0;
                break;
            case 1:
                ray.s0 = std::floor(ray.s0);
                ray.t0 = std::floor(ray.t0) + 0.5;
                break;
            case 2:
                ray.a *= 1e5;
                break;
            case 3:
                ray.b *= -1e14;
                break;
            case 4:
                ray.s0 -= 12345678.0 * field.width();
                break;
            case 5:
                // Whole periods, for which the quotient may be rounded down too far.
                ray.s0 = 0.5 * random.below(2);
                ray.a = random.below(1000) * field.width();
                break;
            case 6:
                if (random.below(10) == 0) ray.a = std::numeric_limits<double>::quiet_NaN();
                break;
            default:
                break;
        }
        rays.set(i, ray);
    }
    return rays;
}

TEST(SampledLanes, HaveTheBitsOfTheReference) {
    MapCache cache;
    Work work(2);
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{49, 19}, {1, 1}, {1, 8}, {64, 32}}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(randomHeights(width, height, 12), surface, address, 0.3);
                for (const MethodChoice& choice :
                     {MethodChoice{"layers", {}},
                      MethodChoice{"layers", {{"layers", "1"}}},
                      MethodChoice{"layers-secant", {{"layers", "13"}}},
                      MethodChoice{"layers-bisection", {{"layers", "7"}, {"bisections", "11"}}},
                      MethodChoice{"distance", {{"layers", "9"}}},
                      MethodChoice{"distance", {{"layers", "1"}, {"footprint", "3"}, {"iterations", "5"}}},
                      MethodChoice{"distance", {{"precision", "u8"}}},
                      MethodChoice{"distance-refined-sampled", {{"footprint", "2"}, {"layers", "5"}}},
                      MethodChoice{"offset", {}},
                      MethodChoice{"offset-limited", {}},
                      MethodChoice{"cone", {{"layout", "texel"}}},
                      MethodChoice{"cone", {{"sectors", "4"}}},
                      MethodChoice{"cone", {{"precision", "u16"}}},
                      MethodChoice{"cone-dummer", {}},
                      MethodChoice{"cone-dummer", {{"iterations", "3"}, {"precision", "u8"}}},
                      MethodChoice{"cone-robust", {{"precision", "u16"}}},
                      MethodChoice{"relaxed-cone-robust", {{"radius", "9"}}},
                      MethodChoice{"relaxed-cone", {{"radius", "9"}}},
                      MethodChoice{"relaxed-cone", {{"radius", "9"}, {"iterations", "4"}, {"bisections", "0"}}},
                      MethodChoice{"hybrid", {}},
                      MethodChoice{"hybrid", {{"level", "1"}, {"inner", "cone-dummer"}}},
                      MethodChoice{"hybrid", {{"level", "2"}, {"inner", "cone"}, {"inner.layout", "texel"}}},
                      MethodChoice{"hybrid", {{"level", "0"}, {"inner", "relaxed-cone"}, {"inner.radius", "5"}}}}) {
                    if (!supports(choice, surface, address)) continue;
                    SCOPED_TRACE(describe(field) + " " + describe(choice));
                    const auto tracer = makeTracer(choice, field, cache, work);
                    // Walks over cones take the longest, and their blocks are as those of the others.
                    const bool cones = choice.name.find("cone") != std::string::npos || choice.name == "hybrid";
                    for (const std::size_t count : {std::size_t{3}, std::size_t{cones ? 1003U : 4001U}}) {
                        const RayBlock rays = hardRays(field, count);
                        HitBlock scalar;
                        BlockCounts counts;
                        tracer->trace(rays, scalar, counts, work);
                        onEveryTarget([&] {
                            HitBlock lanes;
                            NullSink null;
                            tracer->trace(rays, lanes, null, work);
                            expectSameBits(lanes, scalar, rays);
                        });
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace relief::test
