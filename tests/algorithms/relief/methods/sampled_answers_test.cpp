// Results of methods without a guarantee, against their definitions: the first layer at or below the surface, its
// refinements, and the cone that a march samples. Where ties occur, the numbers are exactly representable in float and
// double.
#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/methods/cone_dummer.h"
#include "relief/methods/layers.h"

namespace relief::test {
namespace {

using Truth = long double;

// Lambda over level ground of height h: of the first layer at or below it, after the given bisections; layers are
// counted from `in`, the last one is at `out`.
Truth halved(Truth h, int layers, int bisections, Truth in = 0, Truth out = 1) {
    const Truth ground = 1 - h;
    Truth above = in;
    for (int n = 0;; ++n) {
        Truth below = std::min(in + Truth{1} * n / layers, out);
        if (below >= ground) {
            for (int k = 0; n > 0 && k < bisections; ++k) {
                const Truth middle = (above + below) / 2;
                (middle < ground ? above : below) = middle;
            }
            return below;
        }
        if (below >= out) return -1;
        above = below;
    }
}

// Traces the same ray many times, in SIMD or one by one; all results must be equal.
double lambdaOf(const Tracer& tracer, const ViewRay& ray, bool lanes) {
    constexpr std::size_t kRays = 40;
    RayBlock rays;
    for (std::size_t n = 0; n < kRays; ++n) rays.push(ray);
    Work work(1);
    HitBlock hits;
    NullSink none;
    BlockCounts counts;
    if (lanes) {
        tracer.trace(rays, hits, none, work);
    } else {
        tracer.trace(rays, hits, counts, work);
    }
    for (std::size_t n = 1; n < kRays; ++n) EXPECT_EQ(hits.lambda[n], hits.lambda[0]);
    return hits.outcome[0] == Outcome::Hit ? hits.lambda[0] : -1;
}

TEST(SampledAnswers, LayersEndAtTheFirstAtOrBelowTheSurface) {
    MapCache cache;
    Work work(1);
    const ViewRay ray{3.5, 2.25, 4, -2};
    for (int h = 0; h <= 64; ++h) {
        const HeightField field(constantHeights(16, 16, static_cast<float>(h) / 64));
        const Truth height = static_cast<Truth>(h) / 64;
        for (const int layers : {1, 2, 8, 16}) {
            const std::string count = std::to_string(layers);
            for (const bool lanes : {false, true}) {
                SCOPED_TRACE(std::to_string(h) + "/64, layers " + count + (lanes ? ", lanes" : ", scalar"));
                const auto lambda = [&](const MethodChoice& choice) {
                    return static_cast<Truth>(lambdaOf(*makeTracer(choice, field, cache, work), ray, lanes));
                };
                EXPECT_EQ(lambda({"layers", {{"layers", count}}}), halved(height, layers, 0));
                for (const int bisections : {1, 3, 8}) {
                    EXPECT_EQ(
                        lambda({"layers-bisection", {{"layers", count}, {"bisections", std::to_string(bisections)}}}),
                        halved(height, layers, bisections))
                        << bisections;
                }
                // Level ground is a straight line, so the secant finds it exactly.
                const Truth secant = lambda({"layers-secant", {{"layers", count}}});
                const Truth met = halved(height, layers, 0);
                EXPECT_NEAR(static_cast<double>(secant), static_cast<double>(met > 0 ? 1 - height : 0), 1e-15);
            }
        }
    }
}

// Within a segment of the ray, layers have the same spacing as in the whole slab.
TEST(SampledAnswers, LayersOfAPieceKeepTheirDistance) {
    const ViewRay ray{3.5, 2.25, 4, -2};
    NullSink sink;
    for (int h = 0; h <= 32; ++h) {
        const HeightField field(constantHeights(16, 16, static_cast<float>(h) / 32));
        const Truth height = static_cast<Truth>(h) / 32;
        for (const auto& [in, out] : {std::pair(0.25, 0.75), std::pair(0.125, 0.1875), std::pair(0.5, 1.0)}) {
            const LayersTracer plain(field, {.layers = 8});
            const LayersBisectionTracer fine(field, {.layers = 8, .bisections = 3});
            const auto lambda = [](const Hit& hit) {
                return hit.outcome == Outcome::Hit ? static_cast<Truth>(hit.lambda) : Truth{-1};
            };
            EXPECT_EQ(lambda(plain.traceSegment(ray, {in, out}, sink)), halved(height, 8, 0, in, out))
                << h << " " << in;
            EXPECT_EQ(lambda(fine.traceSegment(ray, {in, out}, sink)), halved(height, 8, 3, in, out)) << h << " " << in;
        }
    }
}

// The cone of a step is interpolated between the four texels whose centres surround it.
TEST(SampledAnswers, ConesAreLookedUpBetweenTexelCentres) {
    constexpr Truth kSlope = 1e-12L;  // error in double of products of four factors
    MapCache cache;
    Work work(1);
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            const HeightField field(randomHeights(13, 9, 6), surface, address, 0.3);
            const auto map = coneMap(ConeKind::Dummer, {}, field, cache, work);
            const auto tracer = makeTracer({"cone-dummer", {}}, field, cache, work);
            const auto slope = [&](std::int64_t i, std::int64_t j) {
                return static_cast<Truth>(map->slopes(addressIndex(i, 13, address), addressIndex(j, 9, address), 0));
            };
            Random random(5);
            int steps = 0;
            for (int n = 0; n < 300; ++n) {
                const ViewRay ray = randomRay(random, field, 0.5);
                for (const Step& step : traceLogged(*tracer, ray).steps) {
                    if (step.decision != Decision::Advance) continue;
                    const Truth x = ray.s0 + Truth{step.lambdaIn} * ray.a - 0.5L;
                    const Truth y = ray.t0 + Truth{step.lambdaIn} * ray.b - 0.5L;
                    const auto i = static_cast<std::int64_t>(std::floor(x)),
                               j = static_cast<std::int64_t>(std::floor(y));
                    const Truth u = x - i, v = y - j;
                    const Truth kappa = (1 - v) * ((1 - u) * slope(i, j) + u * slope(i + 1, j)) +
                                        v * ((1 - u) * slope(i, j + 1) + u * slope(i + 1, j + 1));
                    EXPECT_NEAR(static_cast<double>(step.value), static_cast<double>(kappa),
                                static_cast<double>(kSlope * (1 + kappa)));
                    const Truth gap = 1 - Truth{step.lambdaIn} -
                                      field.at(static_cast<double>(x + 0.5L), static_cast<double>(y + 0.5L));
                    const Truth after = step.lambdaIn + gap / (1 + kappa * std::hypot(Truth{ray.a}, Truth{ray.b}));
                    EXPECT_NEAR(static_cast<double>(step.lambdaAfter), static_cast<double>(std::min(after, Truth{1})),
                                1e-9);
                    ++steps;
                }
            }
            EXPECT_GT(steps, 300);
        }
    }
}

}  // namespace
}  // namespace relief::test
