// Any-hit queries against an independent truth, and their general properties.
#include <iostream>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "algorithms/relief/reference.h"
#include "relief/visibility/any_hit.h"

namespace relief::test {
namespace {

// Height difference below which the truth in long double and the query in double may decide differently.
constexpr long double kTangentHeight = 1e-12L;

// Returns the largest height of the surface above the segment, from sorted crossings and three samples per cell.
long double highestAbove(const HeightField& field, const AnyRay& ray) {
    using Real = long double;
    const Real shift = field.surface() == Surface::Bilinear ? 0.5L : 0.0L;
    Real first = 0;
    Real end = 1;
    if (field.address() == Address::Border) {
        const auto clip = [&](Real x, Real d, Real size) {
            if (d == 0) {
                if (x < 0 || x > size) end = -1;
                return;
            }
            first = std::max(first, std::min(-x / d, (size - x) / d));
            end = std::min(end, std::max(-x / d, (size - x) / d));
        };
        clip(ray.s, ray.ds, field.width());
        clip(ray.t, ray.dt, field.height());
    }
    Real highest = -1e30L;
    if (!(first < end)) return highest;
    std::vector<Real> crossings{first};
    reference::addCrossings(crossings, ray.s - shift, ray.ds, end);
    reference::addCrossings(crossings, ray.t - shift, ray.dt, end);
    crossings.push_back(end);
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
        const Real in = std::max(crossings[n], first);
        const Real out = crossings[n + 1];
        if (!(in < out)) continue;
        const Real middle = (in + out) / 2;
        const auto ci = static_cast<long long>(std::floor(ray.s + middle * ray.ds - shift));
        const auto cj = static_cast<long long>(std::floor(ray.t + middle * ray.dt - shift));
        const auto gap = [&](Real mu) {
            return reference::surfaceAt(field, ray.s + mu * ray.ds, ray.t + mu * ray.dt, ci, cj) -
                   (ray.z + mu * ray.dz);
        };
        const Real half = (out - in) / 2;
        const Real q = (gap(in) - 2 * gap(middle) + gap(out)) / (2 * half * half);
        const Real p = (gap(middle) - gap(in)) / half - q * half;
        highest = std::max({highest, gap(in), gap(out)});
        if (q < 0 && -p / (2 * q) > 0 && -p / (2 * q) < 2 * half) highest = std::max(highest, gap(in - p / (2 * q)));
    }
    return highest;
}

AnyRay randomSegment(Random& random, const HeightField& field) {
    const double reach = random.between(0, 3) * field.width();
    const double azimuth = random.between(0, 7);
    AnyRay ray{random.between(-1, field.width() + 1.0),
               random.between(-1, field.height() + 1.0),
               random.between(-0.1, 1.1),
               reach * std::cos(azimuth),
               reach * std::sin(azimuth),
               random.between(-1, 1)};
    if (random.below(5) == 0) ray.ds = 0;
    if (random.below(5) == 0) ray.dt = 0;
    if (random.below(5) == 0) ray.dz = 0;
    if (random.below(7) == 0) ray.s = std::floor(ray.s);
    if (random.below(7) == 0) ray.t = std::floor(ray.t) + 0.5;
    return ray;
}

class AnyHit : public testing::Test {
  protected:
    template <class Body>
    void forEachQuery(const Body& body) {
        for (const MethodDescription& method : anyHitList()) {
            SCOPED_TRACE(method.name);
            ASSERT_EQ(method.kind, MethodKind::AnyHit);
            ASSERT_EQ(method.rayClass, RayClass::AnyRays);
            for (const Surface surface : allSurfaces()) {
                for (const Address address : allAddresses()) body(method.name, surface, address);
            }
        }
    }

    MapCache cache_;
    Work work_;
};

TEST_F(AnyHit, agreesWithLongDouble) {
    std::size_t rays = 0;
    std::size_t blocked = 0;
    std::size_t tangent = 0;
    forEachQuery([&](const std::string& name, Surface surface, Address address) {
        const std::vector<Heights> maps{randomHeights(31, 17, 5), randomHeights(1, 1, 6), randomHeights(1, 9, 7),
                                        share(makeRelief("city", 64, 64, 3)), share(makeRelief("hills", 96, 41, 4))};
        for (const Heights& heights : maps) {
            const HeightField field(heights, surface, address, 0.3);
            const auto query = makeAnyHit({name, {}}, field, cache_, work_);
            Random random(83);
            AnyRayBlock block(3000);
            for (std::size_t i = 0; i < block.size(); ++i) block.set(i, randomSegment(random, field));
            VisibilityBlock results;
            BlockCounts counts;
            query->query(block, results, counts, work_);
            for (std::size_t i = 0; i < block.size(); ++i) {
                const long double above = highestAbove(field, block[i]) - kVisibilityClearance;
                ++rays;
                ASSERT_LE(results.steps[i], query->stepBound(block[i]));
                if (std::abs(above) < kTangentHeight) {
                    ++tangent;
                    continue;
                }
                ASSERT_EQ(results.visibility[i], above > 0 ? Visibility::Blocked : Visibility::Clear)
                    << describe(field) << " segment " << numberText(block[i].s) << "," << numberText(block[i].t) << ","
                    << numberText(block[i].z) << "," << numberText(block[i].ds) << "," << numberText(block[i].dt) << ","
                    << numberText(block[i].dz) << " surface above it by " << static_cast<double>(above);
                blocked += above > 0 ? 1 : 0;
            }
        }
    });
    std::cout << rays << " segments, " << blocked << " blocked, " << tangent << " within rounding of touching\n";
    EXPECT_GT(blocked, rays / 10);
    EXPECT_LT(blocked, rays - rays / 10);
    EXPECT_LE(tangent, rays / 100);
}

// The point that a view ray hits is visible from the viewer's side along the same line, from slightly before the hit;
// beyond the hit the relief blocks.
TEST_F(AnyHit, aHitIsSeenBackFromTheViewer) {
    forEachQuery([&](const std::string& name, Surface surface, Address address) {
        const HeightField field(randomHeights(23, 19, 8), surface, address, 0.4);
        const auto query = makeAnyHit({name, {}}, field, cache_, work_);
        const auto tracer = makeTracer({"exact", {}}, field, cache_, work_);
        const RayBlock rays = randomRays(89, field, 4000, 2);
        HitBlock hits;
        NullSink null;
        tracer->trace(rays, hits, null, work_);
        AnyRayBlock back;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (hits.outcome[i] != Outcome::Hit) continue;
            const ViewRay ray = rays[i];
            const double lambda = std::max(0.0, hits.lambda[i] - 1e-9);
            back.push({ray.s0 + lambda * ray.a, ray.t0 + lambda * ray.b, 1 - lambda, -lambda * ray.a, -lambda * ray.b,
                       lambda});
        }
        VisibilityBlock results;
        query->query(back, results, null, work_);
        ASSERT_GT(back.size(), 500U);
        for (std::size_t i = 0; i < back.size(); ++i)
            ASSERT_EQ(results.visibility[i], Visibility::Clear) << describe(field);
    });
}

TEST_F(AnyHit, plateausAndTheOwnSurfacePointDoNotBlock) {
    forEachQuery([&](const std::string& name, Surface surface, Address address) {
        const HeightField field(constantHeights(16, 16, 0.25F), surface, address);
        const auto query = makeAnyHit({name, {}}, field, cache_, work_);
        AnyRayBlock block;
        block.push({8, 8, 0.25, 5, 3, 0});     // along the plateau
        block.push({8, 8, 0.25, 5, 3, 0.75});  // upwards from it
        block.push({8, 8, 0.25, 5, 3, -0.1});  // down into it
        block.push({8, 8, 0.2, 5, 3, 0.8});    // upwards from below it
        VisibilityBlock results;
        NullSink null;
        query->query(block, results, null, work_);
        EXPECT_EQ(results.visibility, (std::vector<Visibility>{Visibility::Clear, Visibility::Clear,
                                                               Visibility::Blocked, Visibility::Blocked}));
    });
}

TEST_F(AnyHit, sinksAndThreadsAgree) {
    forEachQuery([&](const std::string& name, Surface surface, Address address) {
        const HeightField field(randomHeights(37, 19, 31), surface, address, 0.3);
        const auto query = makeAnyHit({name, {}}, field, cache_, work_);
        Random random(97);
        AnyRayBlock block(4000);
        for (std::size_t i = 0; i < block.size(); ++i) block.set(i, randomSegment(random, field));
        VisibilityBlock plain;
        VisibilityBlock counted;
        VisibilityBlock logged;
        NullSink null;
        BlockCounts counts;
        StepLog log;
        Work many(4);
        query->query(block, plain, null, work_);
        query->query(block, counted, counts, many);
        query->query(block, logged, log, work_);
        EXPECT_EQ(plain.visibility, counted.visibility);
        EXPECT_EQ(plain.visibility, logged.visibility);
        EXPECT_EQ(counted.steps, logged.steps);
        EXPECT_EQ(counted.reads, logged.reads);
        EXPECT_EQ(counts.steps, log.steps.size());
    });
}

// The first blocking cell ends the search: with a wall next to the start it takes a few steps, however long the
// segment.
TEST_F(AnyHit, leavesEarly) {
    FloatImage wall(4096, 4);
    for (int y = 0; y < 4; ++y) wall(20, y) = 1;
    const HeightField field(share(std::move(wall)), Surface::Columns, Address::Clamp);
    const auto query = makeAnyHit({"max-pyramid-any", {}}, field, cache_, work_);
    AnyRayBlock block;
    block.push({10.5, 2.5, 0.5, 4000, 0, 0.4});
    VisibilityBlock results;
    BlockCounts counts;
    query->query(block, results, counts, work_);
    EXPECT_EQ(results.visibility[0], Visibility::Blocked);
    EXPECT_LE(results.steps[0], 24U);
}

}  // namespace
}  // namespace relief::test
