// Hits decided in rational arithmetic: constructed tangencies and corners, whose answer is known without any rounding,
// and the tracers' answers on random and on awkward rays.
#include "measuring/compare/rational_hit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "algorithms/relief/reference.h"
#include "measuring/compare/duel.h"
#include "measuring/verify/stress_cases.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 39;
// A lambda is the entry of the cell and a root in it, both rounded.
constexpr double kLambdaRounding = 0x1p-51;

int constructedCases() {
    return std::getenv("RELIEF_LONG") != nullptr ? 1'000'000 : 2'000;
}

Hit traced(const char* method, const HeightField& field, const ViewRay& ray) {
    MapCache cache;
    Work work(1);
    RayBlock rays;
    rays.push(ray);
    HitBlock hits;
    NullSink sink;
    makeTracer({method, {}}, field, cache, work)->trace(rays, hits, sink, work);
    return hits[0];
}

// A patch of four nodes that a ray touches in one point without crossing it.
struct Tangency {
    FloatImage heights{2, 2};
    ViewRay ray;
    double lambda = 0;
};

// Returns a tangency all of whose numbers have so few bits that doubles compute it exactly; std::nullopt if the random
// numbers would need heights outside [0, 1].
std::optional<Tangency> tangency(Random& random) {
    const auto signedPower = [&] { return std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, random.below(3)); };
    const double a = signedPower(), b = signedPower();
    const double u = (1 + random.below(15)) / 16.0, v = (1 + random.below(15)) / 16.0;
    const double lambda = (1 + random.below(63)) / 64.0;
    // f(x) = twist a b x^2 from the point of contact: below 0 on both sides.
    const double twist = -(1 + random.below(32)) / 32.0 * (a * b > 0 ? 1 : -1);
    const double dx = (random.below(65) - 32) / 32.0;
    const double dy = -(1 + dx * a + twist * (u * b + v * a)) / b;
    const double h00 = 1 - lambda - dx * u - dy * v - twist * u * v;
    const double corners[] = {h00, h00 + dx, h00 + dy, h00 + dx + dy + twist};
    Tangency out;
    for (int n = 0; n < 4; ++n) {
        const auto stored = static_cast<float>(corners[n]);
        if (!(corners[n] >= 0 && corners[n] <= 1) || static_cast<double>(stored) != corners[n]) return std::nullopt;
        out.heights(n % 2, n / 2) = stored;
    }
    out.ray = {0.5 + u - lambda * a, 0.5 + v - lambda * b, a, b};
    out.lambda = lambda;
    return out;
}

// A touch is a hit; without the last bit of one height there is none there, and with one bit more it is earlier.
TEST(RationalHit, ATouchIsAHitForTheTracersToo) {
    std::cout << "seed " << kSeed << '\n';
    Random random(kSeed);
    int touched = 0, passed = 0;
    for (int n = 0; touched < constructedCases() && n < 400 * constructedCases(); ++n) {
        const auto made = tangency(random);
        if (!made) continue;
        const HeightField field(share(made->heights), Surface::Bilinear, Address::Clamp);
        const auto exact = rationalHit(field, made->ray);
        ASSERT_TRUE(exact && exact->hit);
        ASSERT_LE(exact->lambda, made->lambda) << describe(made->ray);
        if (exact->lambda < made->lambda) continue;  // the surface around the patch is hit before
        ++touched;
        ASSERT_EQ(exact->clearance, 0);
        for (const char* method : {"exact", "max-pyramid"}) {
            ASSERT_NEAR(traced(method, field, made->ray).lambda, made->lambda, kLambdaRounding)
                << method << " " << describe(made->ray);
        }
        for (const float toward : {0.0F, 1.0F}) {
            FloatImage changed = made->heights;
            float& highest = *std::max_element(changed.pixels().begin(), changed.pixels().end());
            if (highest == toward) continue;
            highest = std::nextafter(highest, toward);
            const HeightField other(share(std::move(changed)), Surface::Bilinear, Address::Clamp);
            const auto decided = rationalHit(other, made->ray);
            ASSERT_TRUE(decided && decided->hit);
            ASSERT_GT(decided->clearance, 0) << describe(made->ray);
            ASSERT_TRUE(toward == 0 ? decided->lambda > made->lambda : decided->lambda <= made->lambda);
            const Hit hit = traced("exact", other, made->ray);
            ASSERT_NE(judgeHit(other, made->ray, hit, *decided), RationalVerdict::Wrong) << describe(made->ray);
            passed += toward == 0 ? 1 : 0;
        }
    }
    EXPECT_EQ(touched, constructedCases());
    EXPECT_GT(passed, touched / 2);
    std::cout << touched << " tangencies, " << passed << " of them missed by one bit\n";
}

// A tracer that reports no hit of a ray which touches the surface is right; where the surface is clearly higher it is
// not.
DuelRun missedRun() {
    DuelRun run{"other", Hit::none(Outcome::Miss), {Step{}}};
    run.steps.back().decision = Decision::Miss;
    run.steps.back().lambdaAfter = 1;
    return run;
}
TEST(RationalHit, SettlesDuelsAboutTouches) {
    Random random(kSeed);
    int settled = 0;
    for (int n = 0; settled < 20 && n < 10'000; ++n) {
        const auto made = tangency(random);
        if (!made) continue;
        const HeightField field(share(made->heights), Surface::Bilinear, Address::Clamp);
        const Hit exact = traced("exact", field, made->ray);
        if (exact.lambda < made->lambda - kLambdaRounding) continue;
        const Judgement touching = judge(missedRun(), exact, made->ray, field);
        EXPECT_TRUE(touching.withinRounding) << describe(made->ray);
        EXPECT_EQ(touching.kind, Departure::None);
        ++settled;
        // Where the surface is clearly higher, to report a miss is an error.
        FloatImage above = made->heights;
        for (float& h : above.pixels()) h = std::min(1.0F, h + 0x1p-6F);
        const HeightField higher(share(std::move(above)), Surface::Bilinear, Address::Clamp);
        const Judgement judgement = judge(missedRun(), traced("exact", higher, made->ray), made->ray, higher);
        EXPECT_FALSE(judgement.withinRounding) << describe(made->ray);
        EXPECT_NE(judgement.kind, Departure::None) << describe(made->ray);
    }
    EXPECT_GE(settled, 20);
}

// Through the corner where four columns meet, the ray goes on in the opposite one.
TEST(RationalHit, ColumnsTouchedInACornerAreNoHit) {
    Random random(kSeed);
    for (int n = 0; n < constructedCases(); ++n) {
        const double run = std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, random.below(4));
        const double other = random.below(2) == 0 ? run : -run;
        FloatImage heights(4, 4);
        for (float& h : heights.pixels()) h = static_cast<float>(random.below(65)) / 64.0F;
        const HeightField field(share(std::move(heights)), Surface::Columns,
                                random.below(2) == 0 ? Address::Repeat : Address::Clamp);
        const ViewRay ray{1.0 + random.below(3), 1.0 + random.below(3), run, other};
        const auto exact = rationalHit(field, ray);
        ASSERT_TRUE(exact && exact->hit);
        for (const char* method : {"exact", "max-pyramid"}) {
            ASSERT_EQ(traced(method, field, ray).lambda, exact->lambda) << method << " " << describe(ray);
        }
    }
}

TEST(RationalHit, AgreesWithLongDoubleWhereThatIsCertain) {
    Random random(kSeed);
    std::size_t rays = 0, uncertain = 0;
    for (int map = 0; map < 30; ++map) {
        const Heights heights = randomHeights(1 + random.below(40), 1 + random.below(40), random.bits());
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(heights, surface, address, 0.3);
                for (int n = 0; n < 10; ++n, ++rays) {
                    const ViewRay ray = randomRay(random, field, 2);
                    const auto exact = rationalHit(field, ray);
                    ASSERT_TRUE(exact) << describe(ray);
                    const reference::Answer truth = reference::trace(field, ray);
                    constexpr long double kTangent = 1e-15L;
                    if (truth.clearance < kTangent) {
                        ++uncertain;
                        continue;
                    }
                    ASSERT_EQ(truth.hit, exact->hit) << describe(field) << describe(ray);
                    if (!truth.hit) continue;
                    ASSERT_NEAR(static_cast<double>(truth.lambda), exact->lambda, 1e-13) << describe(ray);
                    ASSERT_EQ(judgeHit(field, ray, traced("exact", field, ray), *exact), RationalVerdict::Same);
                }
            }
        }
    }
    EXPECT_LE(uncertain, rays / 1000);
    std::cout << rays << " rays, " << uncertain << " undecided in long double\n";
}

TEST(RationalHit, JudgesAnswers) {
    FloatImage heights(8, 1, 0.0F);
    heights(3, 0) = 0.8F;
    const HeightField field(share(std::move(heights)), Surface::Bilinear, Address::Repeat);
    const ViewRay ray{0.5, 0.5, 6, 0};
    const auto exact = rationalHit(field, ray);
    ASSERT_TRUE(exact && exact->hit);
    const auto judged = [&](const Hit& hit) { return judgeHit(field, ray, hit, *exact); };
    EXPECT_EQ(judged(Hit::at(ray, exact->lambda)), RationalVerdict::Same);
    EXPECT_EQ(judged(Hit::at(ray, exact->lambda + 1e-8)), RationalVerdict::Wrong);
    EXPECT_EQ(judged(Hit::at(ray, exact->lambda - 1e-8)), RationalVerdict::Wrong);
    EXPECT_EQ(judged(Hit::at(ray, 1)), RationalVerdict::Wrong) << "behind the peak, on the surface";
    EXPECT_EQ(judged(Hit::none(Outcome::Miss)), RationalVerdict::Wrong);
    EXPECT_EQ(rationalGap(field, ray, 1), 0);
    EXPECT_NEAR(rationalGap(field, ray, 0.5), 0.8 - 0.5, 1e-7);
}

// Rays through many corners, on which each rounding may choose another side (found by relief stress --oracle).
TEST(RationalHit, CornersExplainOtherSides) {
    const HeightField city(share(makeRelief("city", 13, 9, 511839)), Surface::Columns, Address::Repeat, 0.02);
    const ViewRay ray{3, 6, 335.7440347778818, 503.61605216682267};
    const auto exact = rationalHit(city, ray);
    ASSERT_TRUE(exact && exact->hit);
    EXPECT_EQ(judgeHit(city, ray, traced("exact", city, ray), *exact), RationalVerdict::Rounding);
    EXPECT_EQ(judgeHit(city, ray, Hit::at(ray, 0.05), *exact), RationalVerdict::Wrong) << "above all columns";
    EXPECT_EQ(judgeHit(city, ray, Hit::at(ray, 0.5), *exact), RationalVerdict::Wrong) << "behind a hit";
    EXPECT_EQ(judgeHit(city, ray, Hit::none(Outcome::Miss), *exact), RationalVerdict::Wrong);
}

TEST(RationalHit, RefusesWhatItCannotCount) {
    const HeightField field(randomHeights(4, 4, kSeed));
    EXPECT_FALSE(rationalHit(field, {0, 0, kMaxRun, 0}));
    EXPECT_FALSE(rationalHit(field, {0, 0, std::nan(""), 0}));
    EXPECT_FALSE(rationalHit(field, {1e300, 0, 1, 1}));
    EXPECT_TRUE(rationalHit(field, {-1e15, 0.25, 5e-324, -0.0}));
}

}  // namespace
}  // namespace relief::test
