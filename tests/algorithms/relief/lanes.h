// SIMD versions held against their references, bit for bit, on every instruction set.
#pragma once

#include "algorithms/every_target.h"
#include "fields.h"

namespace relief::test {

// The first three rays whose hits differ are named.
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
