// Properties of every listed tracer, or of every one with the exact guarantee, for any height map.
#include <cstdlib>

#include <gtest/gtest.h>

#include "fields.h"
#include "reference.h"

namespace relief::test {
namespace {

// Difference from closed forms: a few roundings of numbers up to 1 (2^-53 each).
constexpr double kRounding = 1e-15;
// Log and reference are compared in heights: rounding of positions up to 1,000 texels times slopes up to 1.
constexpr double kHeightRounding = 1e-12;

// Returns all choices; or, while a method is being developed, only those of the method named in the environment.
std::vector<MethodChoice> chosenOf(std::vector<MethodChoice> choices) {
    if (const char* const only = std::getenv("RELIEF_TRACER")) {
        const std::string name = findTracer(only).name;
        std::erase_if(choices, [&](const MethodChoice& choice) { return choice.name != name; });
    }
    return choices;
}

class Laws : public testing::Test {
  protected:
    std::unique_ptr<Tracer> make(const MethodChoice& choice, const HeightField& field) {
        return makeTracer(choice, field, cache_, work_);
    }
    template <class Body>
    void forEach(const std::vector<MethodChoice>& choices, const Body& body) {
        ASSERT_FALSE(choices.empty());
        const std::vector<MethodChoice> chosen = chosenOf(choices);
        if (chosen.empty()) GTEST_SKIP() << "the method named by RELIEF_TRACER is not exact";
        for (const MethodChoice& choice : chosen) {
            SCOPED_TRACE(describe(choice));
            for (const Surface surface : allSurfaces()) {
                for (const Address address : allAddresses()) {
                    if (supports(choice, surface, address)) body(choice, surface, address);
                }
            }
        }
    }
    template <class Body>
    void forEachExact(const Body& body) {
        forEach(choicesThatPromise(Guarantee::Exact), body);
    }

    MapCache cache_;
    Work work_{1};
};

TEST_F(Laws, flatFieldIsTheClosedForm) {
    forEachExact([&](const MethodChoice& choice, Surface surface, Address address) {
        for (const float h : {0.0F, 0.25F, 0.7F, 1.0F}) {
            const HeightField field(constantHeights(13, 7, h), surface, address, 0.2);
            const auto tracer = make(choice, field);
            Random random(7);
            for (int i = 0; i < 200; ++i) {
                ViewRay ray = randomRay(random, field, 5);
                if (address == Address::Border) ray = {6.5, 3.5, ray.a * 0.1, ray.b * 0.1};
                const Hit hit = traceLogged(*tracer, ray).hit;
                ASSERT_EQ(hit.outcome, Outcome::Hit) << describe(field) << " ray " << describe(ray);
                EXPECT_NEAR(hit.lambda, 1 - static_cast<double>(h), kRounding) << describe(ray);
                EXPECT_EQ(hit.s, ray.s0 + hit.lambda * ray.a);
                EXPECT_EQ(hit.t, ray.t0 + hit.lambda * ray.b);
            }
        }
    });
}

TEST_F(Laws, mirroredFieldMirrorsTheHit) {
    const Heights heights = randomHeights(11, 6, 3);
    FloatImage mirrored(11, 6);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 11; ++x) mirrored(10 - x, y) = (*heights)(x, y);
    }
    const Heights image = share(std::move(mirrored));
    forEachExact([&](const MethodChoice& choice, Surface surface, Address address) {
        const HeightField field(heights, surface, address, 0.5);
        const HeightField other(image, surface, address, 0.5);
        const auto one = make(choice, field);
        const auto two = make(choice, other);
        Random random(11);
        for (int i = 0; i < 2000; ++i) {
            const ViewRay ray = randomRay(random, field, 3);
            const Hit a = traceLogged(*one, ray).hit;
            const Hit b = traceLogged(*two, {11 - ray.s0, ray.t0, -ray.a, ray.b}).hit;
            ASSERT_EQ(a.outcome, b.outcome) << describe(field) << " ray " << describe(ray);
            // 11 - s0 is rounded; a tangent patch turns that rounding error into its square root.
            if (a.outcome == Outcome::Hit) {
                EXPECT_NEAR(a.lambda, b.lambda, 1e-7) << describe(ray);
            }
        }
    });
}

bool coarseVoxels(const MethodChoice& choice) {
    const auto& defaults = findTracer(choice.name).defaults;
    const auto footprint = defaults.find("footprint");
    return footprint != defaults.end() && footprint->second != "1";
}

TEST_F(Laws, wholeTexelShiftsCommuteUnderRepeat) {
    const Heights heights = randomHeights(13, 9, 5);
    FloatImage shifted(13, 9);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 13; ++x) shifted((x + 4) % 13, (y + 7) % 9) = (*heights)(x, y);
    }
    const Heights image = share(std::move(shifted));
    for (const MethodChoice& choice : chosenOf(allChoices())) {
        SCOPED_TRACE(describe(choice));
        for (const Surface surface : allSurfaces()) {
            if (!supports(choice, surface, Address::Repeat)) continue;
            const auto one = make(choice, HeightField(heights, surface));
            const auto two = make(choice, HeightField(image, surface));
            // The segments of an inner method, the texels of a base level and the footprints of voxels are aligned with
            // the picture's corner, so shifting the picture changes results that are not exact.
            if (one->guarantee() != Guarantee::Exact && (one->pyramid() || coarseVoxels(choice))) continue;
            Random random(13);
            for (int i = 0; i < 2000; ++i) {
                // Multiples of 1/8: the sums and products below are exact, and so must the results be.
                const ViewRay ray{random.below(104) / 8.0, random.below(72) / 8.0, random.below(400) / 8.0 - 25.0,
                                  random.below(400) / 8.0 - 25.0};
                const Hit a = traceLogged(*one, ray).hit;
                const Hit b = traceLogged(*two, {ray.s0 + 4, ray.t0 + 7, ray.a, ray.b}).hit;
                ASSERT_EQ(a.outcome, b.outcome);
                // Maps are float: a slope measured at sampled points may be rounded to a neighbouring value.
                const bool measured = one->guarantee() == Guarantee::Approximate && one->bytes() > 0;
                EXPECT_NEAR(a.lambda, b.lambda, measured ? 1e-6 : 1e-13)
                    << "ray " << describe(ray) << " over the picture and over the shifted one; a method that computes "
                    << "its next sample from heights amplifies the rounding of s0 + lambda a";
            }
        }
    }
}

// At whole periods' distance the fraction of a texel keeps its value, so the results must be the same.
TEST_F(Laws, wholePeriodsChangeNothing) {
    const Heights heights = randomHeights(13, 9, 5);
    for (const MethodChoice& choice : chosenOf(allChoices())) {
        SCOPED_TRACE(describe(choice));
        for (const Surface surface : allSurfaces()) {
            if (!supports(choice, surface, Address::Repeat)) continue;
            const auto tracer = make(choice, HeightField(heights, surface));
            Random random(17);
            for (int i = 0; i < 2000; ++i) {
                const ViewRay ray{random.below(13 * 1024) / 1024.0, random.below(9 * 1024) / 1024.0,
                                  random.between(-30, 30), random.between(-30, 30)};
                const ViewRay far{ray.s0 + 13.0 * 76923, ray.t0 - 9.0 * 111111, ray.a, ray.b};
                const Hit a = traceLogged(*tracer, ray).hit;
                const Hit b = traceLogged(*tracer, far).hit;
                ASSERT_EQ(a.outcome, b.outcome);
                ASSERT_EQ(a.lambda, b.lambda) << describe(ray);
                EXPECT_EQ(b.s, far.s0 + b.lambda * far.a);
            }
        }
    }
}

// Every logged interval that was excluded lies above the surface, checked by dense sampling with independent code.
TEST_F(Laws, loggedExclusionsLieAboveTheSurface) {
    forEachExact([&](const MethodChoice& choice, Surface surface, Address address) {
        const HeightField field(randomHeights(21, 12, 23), surface, address, 0.4);
        const auto tracer = make(choice, field);
        Random random(29);
        for (int i = 0; i < 400; ++i) {
            const ViewRay ray = randomRay(random, field, 2);
            const Logged logged = traceLogged(*tracer, ray);
            const reference::Answer truth = reference::trace(field, ray);
            const double end = truth.hit ? static_cast<double>(truth.lambda) : 1.0;
            double reached = 0;
            for (const Step& step : logged.steps) {
                if (step.decision == Decision::Start) continue;
                EXPECT_LE(step.lambdaIn, step.lambdaOut + kHeightRounding);
                EXPECT_NEAR(step.lambdaIn, reached, kHeightRounding)
                    << "a gap in the log, " << decisionName(step.decision) << ", ray " << describe(ray);
                reached = step.lambdaAfter;
                const bool excluded = step.decision == Decision::Skip || step.decision == Decision::Advance ||
                                      step.decision == Decision::Test;
                if (excluded) {
                    EXPECT_LE(step.lambdaOut, end + kHeightRounding) << describe(ray);
                }
                // Otherwise a cell on the rim may go on for ever.
                if (step.decision == Decision::Hit && address == Address::Repeat) {
                    EXPECT_LE((step.lambdaOut - step.lambdaIn) * std::max(std::abs(ray.a), std::abs(ray.b)), 1.000001)
                        << "a hit is found within a cell, ray " << describe(ray);
                }
            }
        }
    });
}

TEST_F(Laws, sinksAndThreadsGiveIdenticalBits) {
    forEach(allChoices(), [&](const MethodChoice& choice, Surface surface, Address address) {
        const HeightField field(randomHeights(37, 19, 31), surface, address, 0.3);
        const auto tracer = make(choice, field);
        const RayBlock rays = randomRays(41, field, 5000, 1);
        HitBlock plain;
        HitBlock counted;
        HitBlock logged;
        NullSink null;
        BlockCounts counts;
        StepLog log;
        Work many(4);
        tracer->trace(rays, plain, null, work_);
        tracer->trace(rays, counted, counts, many);
        tracer->trace(rays, logged, log, work_);
        ASSERT_EQ(log.rays(), rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(sameBits(plain[i], counted[i])) << describe(rays[i]);
            ASSERT_TRUE(sameBits(plain[i], logged[i])) << describe(rays[i]);
            ASSERT_EQ(counted.steps[i], logged.steps[i]);
            ASSERT_EQ(counted.reads[i], logged.reads[i]);
            ASSERT_EQ(log.begin[i + 1] - log.begin[i], logged.steps[i]);
        }
        EXPECT_EQ(counts.steps, log.steps.size());
    });
}

TEST_F(Laws, stepsStayWithinTheirBound) {
    forEach(allChoices(), [&](const MethodChoice& choice, Surface surface, Address address) {
        for (const auto& [w, h] : std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {5, 3}, {64, 2}, {1024, 1}}) {
            const HeightField field(randomHeights(w, h, 43), surface, address, 1);
            const auto tracer = make(choice, field);
            Random random(47);
            for (int i = 0; i < 300; ++i) {
                const ViewRay ray = randomRay(random, field, 0.05);
                const Logged logged = traceLogged(*tracer, ray);
                ASSERT_LE(static_cast<double>(logged.steps.size()), tracer->stepBound(ray)) << describe(ray);
                ASSERT_NE(logged.hit.outcome, Outcome::Limit);
            }
        }
    });
}

// Raising the surface never moves the hit to a later point.
TEST_F(Laws, raisingTheFieldNeverDelaysTheHit) {
    const Heights low = randomHeights(17, 17, 53);
    FloatImage raised = *low;
    Random lift(59);
    for (float& h : raised.pixels()) h = std::min(1.0F, h + static_cast<float>(0.2 * lift.unit()));
    const Heights high = share(std::move(raised));
    forEachExact([&](const MethodChoice& choice, Surface surface, Address address) {
        const HeightField field(low, surface, address, 0.5);
        const auto below = make(choice, field);
        const auto above = make(choice, HeightField(high, surface, address, 0.5));
        Random random(61);
        for (int i = 0; i < 2000; ++i) {
            const ViewRay ray = randomRay(random, field, 2);
            const Hit a = traceLogged(*below, ray).hit;
            const Hit b = traceLogged(*above, ray).hit;
            if (a.outcome == Outcome::Hit) {
                ASSERT_EQ(b.outcome, Outcome::Hit);
                ASSERT_LE(b.lambda, a.lambda + kRounding);
            }
        }
    });
}

}  // namespace
}  // namespace relief::test
