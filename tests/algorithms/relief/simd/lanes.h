// Compares SIMD versions with their references, bit for bit, on every instruction set.
#pragma once

#include "algorithms/every_target.h"
#include "algorithms/relief/fields.h"

namespace relief::test {

// Rays of all kinds: random, along the axes, vertical, through texel corners and borders, far away, flat, not finite.
inline RayBlock awkwardRays(const HeightField& field, std::uint64_t seed, std::size_t count) {
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
                // Next to a line, off by one rounding.
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

// Calls body(field, rays) for maps of unusual sizes, level and with deep relief, with every surface and addressing, and
// for awkwardRays().
template <class Body>
void onAwkwardMaps(std::uint64_t seed, std::size_t count, const Body& body) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {5, 3}, {16, 17}, {100, 3}, {64, 64}}) {
        const Heights heights =
            width == 64 ? share(makeRelief("spikes", width, height, seed)) : randomHeights(width, height, seed);
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                for (const double depth : {0.02, 0.9}) {
                    const HeightField field(heights, surface, address, depth);
                    body(field, awkwardRays(field, seed, count));
                }
            }
        }
    }
}

// Reports the first three rays whose hits differ.
inline void expectSameHits(const HitBlock& expected, const HitBlock& hits, const RayBlock& rays,
                           const std::string& what) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (sameBits(expected[i], hits[i])) continue;
        if (++different > 3) continue;
        ADD_FAILURE() << what << ", ray " << i << ": " << describe(rays[i]) << ": expected "
                      << static_cast<int>(expected.outcome[i]) << " " << numberText(expected.lambda[i]) << ", got "
                      << static_cast<int>(hits.outcome[i]) << " " << numberText(hits.lambda[i]);
    }
    EXPECT_EQ(different, 0U) << what;
}

inline HitBlock scalarHits(const Tracer& tracer, const RayBlock& rays) {
    Work work(1);
    HitBlock hits;
    BlockCounts counts;
    tracer.trace(rays, hits, counts, work);
    return hits;
}

inline void expectSameBits(const HeightField& field, const MethodChoice& method, const RayBlock& rays,
                           MapCache& cache) {
    if (!supports(method, field.surface(), field.address())) return;
    Work work(1);
    const auto tracer = makeTracer(method, field, cache, work);
    const HitBlock scalar = scalarHits(*tracer, rays);
    onEveryTarget([&] {
        HitBlock lanes;
        NullSink sink;
        tracer->trace(rays, lanes, sink, work);
        expectSameHits(scalar, lanes, rays, describe(method) + ", " + describe(field) + ", SIMD against reference");
    });
}

}  // namespace relief::test
