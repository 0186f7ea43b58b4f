// The first error of a method on a ray: reliefs made for each kind of error, and properties tested on random ones.
#include "measuring/compare/duel.h"

#include <set>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/map_cache.h"
#include "scenario/step_sentence.h"

namespace relief::test {
namespace {

DuelRun runOf(const MethodChoice& method, const HeightField& field, const ViewRay& ray, MapCache& cache) {
    Work work(1);
    RayBlock rays;
    rays.push(ray);
    HitBlock hits;
    StepLog log;
    makeTracer(method, field, cache, work)->trace(rays, hits, log, work);
    return {method.name, hits[0], log.steps};
}

DuelRun runOf(const MethodChoice& method, const HeightField& field, const ViewRay& ray) {
    MapCache cache;
    return runOf(method, field, ray, cache);
}

Hit exactHit(const HeightField& field, const ViewRay& ray) {
    return runOf({"exact", {}}, field, ray).hit;
}

// Ground at height `low` with a wall of height `high`, one column of texels wide, at i = `at`.
HeightField wall(int size, int at, float low, float high, Surface surface = Surface::Columns) {
    FloatImage heights(size, size, low);
    for (int j = 0; j < size; ++j) heights(at, j) = high;
    return HeightField(share(std::move(heights)), surface);
}

struct Judged {
    DuelRun run;
    Hit exact;
    Judgement judgement;
};
Judged judged(const MethodChoice& method, const HeightField& field, const ViewRay& ray) {
    Judged out{runOf(method, field, ray), exactHit(field, ray), {}};
    out.judgement = judge(out.run, out.exact, ray, field);
    return out;
}

TEST(Duel, AWallBetweenTwoLayersIsAMissedSpike) {
    const HeightField field = wall(64, 20, 0.1F, 0.8F);
    const ViewRay ray{1.5, 30.5, 48, 0};
    // Layers at s = 1.5, 13.5, 25.5, ...: the wall at 20 lies between the second and the third.
    const Judged found = judged({"layers", {{"layers", "4"}}}, field, ray);
    EXPECT_EQ(found.judgement.kind, Departure::MissedSpike);
    const Step& step = found.run.steps.at(found.judgement.step);
    EXPECT_EQ(step.lambdaIn, 0.25);
    EXPECT_EQ(step.lambdaOut, 0.5);
    EXPECT_LT(found.judgement.from, found.exact.lambda);
    EXPECT_GT(found.judgement.to, found.exact.lambda);
    EXPECT_EQ(found.judgement.overshoot, found.judgement.step);
    EXPECT_EQ(judged({"layers", {{"layers", "4096"}}}, field, ray).judgement.kind, Departure::NotRefined);
    EXPECT_EQ(judged({"max-pyramid", {}}, field, ray).judgement.kind, Departure::None);
}

TEST(Duel, AnAnswerBeforeTheSurfaceIsStoppedEarly) {
    // The ray enters above the wall and passes its edge: from the height at the entry the method computes lambda = 0.2.
    const HeightField field = wall(64, 20, 0.1F, 0.8F);
    const ViewRay ray{20.5, 30.5, 40, 0};
    const Judged found = judged({"offset", {}}, field, ray);
    EXPECT_EQ(found.judgement.kind, Departure::StoppedEarly);
    EXPECT_LT(found.run.hit.lambda, found.exact.lambda);
    EXPECT_NEAR(found.judgement.texels, (found.exact.lambda - found.run.hit.lambda) * 40, 1e-9);
    EXPECT_FALSE(found.judgement.overshoot);
    // A run that gives up.
    DuelRun gaveUp = runOf({"exact", {}}, field, ray);
    gaveUp.steps.resize(3);
    gaveUp.steps.back().decision = Decision::Limit;
    gaveUp.hit = Hit::none(Outcome::Limit);
    const Judgement judgement = judge(gaveUp, found.exact, ray, field);
    EXPECT_EQ(judgement.kind, Departure::StoppedEarly);
    EXPECT_EQ(judgement.step, 2U);
    EXPECT_TRUE(std::isinf(judgement.texels));
}

// The parallax offset reads one height, so no sentence may name other points as examined.
TEST(Duel, OneHeightBehindAWallIsTakenAsFlat) {
    const HeightField field = wall(64, 20, 0.1F, 0.8F);
    for (const double s0 : {1.5, 8.5}) {
        const Judged found = judged({"offset", {}}, field, {s0, 30.5, 40, 0});
        ASSERT_GT(found.run.hit.lambda, found.exact.lambda);
        EXPECT_EQ(found.judgement.kind, Departure::TakenAsFlat) << s0;
        const Message message = judgementSentence(found.run, found.judgement, found.exact);
        EXPECT_EQ(message.id, MessageId::DuelSaysTakenAsFlat);
    }
}

// A relaxed cone does not promise to be empty, only that the ray enters the surface in it at most once.
TEST(Duel, ARelaxedConeIsNotBlamedForAPromiseItNeverMade) {
    constexpr std::uint64_t kSeed = 5;
    const HeightField field(randomHeights(24, 24, kSeed), Surface::Bilinear, Address::Repeat, 0.3);
    Random random(kSeed);
    Work work(1);
    MapCache cache;
    int unsafe = 0;
    int cones = 0;
    for (const char* const halvings : {"0", "8"}) {
        const auto tracer =
            makeTracer({"relaxed-cone", {{"radius", "2"}, {"bisections", halvings}}}, field, cache, work);
        for (int n = 0; n < 400; ++n) {
            const ViewRay ray{random.unit() * 24, random.unit() * 24, random.unit() * 60 - 30, random.unit() * 60 - 30};
            RayBlock rays;
            rays.push(ray);
            HitBlock hits;
            StepLog log;
            tracer->trace(rays, hits, log, work);
            const DuelRun run{"relaxed-cone", hits[0], log.steps};
            const Hit exact = exactHit(field, ray);
            for (const Step& step : run.steps) {
                const auto* const cone = step.as<subject::Cone>();
                if (cone == nullptr) continue;
                ++cones;
                EXPECT_TRUE(cone->relaxed);
                EXPECT_NE(mapPromise(step, {nullptr, ray, exact}), MapPromise::Broken);
            }
            const Judgement judgement = judge(run, exact, ray, field);
            if (judgement.kind != Departure::UnsafeMap) continue;
            ++unsafe;
            EXPECT_EQ(judgementSentence(run, judgement, exact).id, MessageId::DuelSaysUnsafeRelaxed);
            // What the sentence says: the ray has come out of the surface again.
            const double to = judgement.to;
            EXPECT_LT(field.at(ray.s0 + to * ray.a, ray.t0 + to * ray.b), 1 - to);
        }
    }
    EXPECT_GT(unsafe, 0) << kSeed;
    EXPECT_GT(cones, unsafe);
}

TEST(Duel, AMapThatPromisesTooMuchIsUnsafe) {
    // Distances of a relief without the wall, used for one with the wall: the behaviour of an outdated or unsafe map.
    const HeightField field = wall(64, 20, 0.1F, 0.8F);
    const HeightField ground(constantHeights(64, 64, 0.1F), Surface::Columns);
    const ViewRay ray{1.5, 30.5, 48, 0};
    const DuelRun run = runOf({"distance-conservative", {}}, ground, ray);
    const Judgement judgement = judge(run, exactHit(field, ray), ray, field);
    EXPECT_EQ(judgement.kind, Departure::UnsafeMap);
    EXPECT_EQ(run.steps.at(judgement.step).decision, Decision::Advance);
    // A maximum that is too small is the same kind of error.
    const DuelRun pyramid = runOf({"max-pyramid", {}}, ground, ray);
    const Judgement skipped = judge(pyramid, exactHit(field, ray), ray, field);
    EXPECT_NE(skipped.kind, Departure::None);
    EXPECT_NE(skipped.kind, Departure::StoppedEarly);
}

TEST(Duel, ASecantThatIsNotTheSurfaceLeaks) {
    // The ray meets the wall's side late in the layer; the secant between the layer's ends crosses it earlier.
    const HeightField field = wall(64, 17, 0.1F, 0.8F);
    const ViewRay ray{1.8, 30.5, 62, 0};
    const Judged found = judged({"layers-secant", {{"layers", "4"}}}, field, ray);
    ASSERT_EQ(found.run.hit.outcome, Outcome::Hit);
    EXPECT_EQ(found.judgement.kind, Departure::InterpolationLeak);
    EXPECT_EQ(found.run.steps.at(found.judgement.step).decision, Decision::Refine);
    EXPECT_LE(found.judgement.from, found.exact.lambda);
    EXPECT_GE(found.judgement.to, found.exact.lambda);
    // Without refinement the error is only that there is none.
    EXPECT_EQ(judged({"layers", {{"layers", "4"}}}, field, ray).judgement.kind, Departure::NotRefined);
}

TEST(Duel, LockStepKeepsAllAtTheSamePlace) {
    const HeightField field = wall(64, 20, 0.1F, 0.8F);
    const ViewRay ray{1.5, 30.5, 48, 0};
    const std::vector<DuelRun> runs{runOf({"max-pyramid", {}}, field, ray),
                                    runOf({"layers", {{"layers", "4"}}}, field, ray), DuelRun{}};
    const LockStep steps = lockStep(runs);
    EXPECT_EQ(steps.moments.front(), (std::vector<std::size_t>{0, 0, 0}));
    EXPECT_EQ(steps.moments.back(), (std::vector<std::size_t>{runs[0].steps.size() - 1, runs[1].steps.size() - 1, 0}));
    for (std::size_t m = 1; m < steps.moments.size(); ++m) {
        std::size_t moved = 0;
        for (std::size_t r = 0; r < runs.size(); ++r) {
            ASSERT_LE(steps.moments[m][r], steps.moments[m - 1][r] + 1);
            ASSERT_GE(steps.moments[m][r], steps.moments[m - 1][r]);
            moved += steps.moments[m][r] - steps.moments[m - 1][r];
        }
        EXPECT_GE(moved, 1U);
    }
    std::vector<Judgement> judgements;
    for (const DuelRun& run : runs) judgements.push_back(judge(run, exactHit(field, ray), ray, field));
    judgements[2] = {};
    const auto first = firstToDepart(steps, judgements);
    ASSERT_TRUE(first);
    EXPECT_EQ(*first, 1U);
    EXPECT_EQ(steps.moments[steps.momentOf(1, judgements[1].step)][1], judgements[1].step);
    judgements[1] = {};
    EXPECT_FALSE(firstToDepart(steps, judgements));
}

// For every method: a result equal to the exact one is not judged; any other is judged at a step of the log, and
// described in a sentence.
TEST(Duel, EveryDepartureIsNamed) {
    constexpr std::uint64_t kSeed = 20261;
    std::array<int, 7> seen{};
    MapCache cache;
    for (const Surface surface : allSurfaces()) {
        const HeightField field(randomHeights(24, 24, kSeed), surface, Address::Repeat, 0.3);
        Random random(kSeed);
        for (int n = 0; n < 40; ++n) {
            const ViewRay ray{random.unit() * 24, random.unit() * 24, random.unit() * 60 - 30, random.unit() * 60 - 30};
            const Hit exact = exactHit(field, ray);
            for (const MethodChoice& method : allChoices()) {
                if (!supports(method, surface, Address::Repeat)) continue;
                const DuelRun run = runOf(method, field, ray, cache);
                const Judgement judgement = judge(run, exact, ray, field);
                ++seen[static_cast<std::size_t>(judgement.kind)];
                ASSERT_EQ(judgement.kind == Departure::None, judgement.texels <= kSameAnswer) << method.name;
                ASSERT_LT(judgement.step, run.steps.size());
                const std::string text = sentence(judgementSentence(run, judgement, exact));
                EXPECT_EQ(text.find('{'), std::string::npos) << text;
                if (judgement.kind == Departure::None || judgement.kind == Departure::StoppedEarly) continue;
                EXPECT_LE(judgement.from, exact.lambda) << method.name << " " << n;
                EXPECT_GE(std::max(judgement.to, run.hit.lambda), exact.lambda) << method.name << " " << n << text;
                // True also for the maxima of a coarser level, which describe another relief.
                const bool stored = run.steps[judgement.step].trustsMap() || method.options.contains("base");
                EXPECT_TRUE(stored || judgement.kind != Departure::UnsafeMap) << text;
            }
        }
    }
    // All kinds occur, so that the tests above cover them all.
    for (std::size_t kind = 0; kind < seen.size(); ++kind) EXPECT_GT(seen[kind], 0) << kind << ", seed " << kSeed;
}

TEST(Duel, everyDepartureHasATitleOfItsOwn) {
    std::set<std::string> titles;
    for (const Language language : {Language::English, Language::Ukrainian}) {
        Judgement judgement;
        for (int kind = 0; kind <= static_cast<int>(Departure::TakenAsFlat); ++kind) {
            judgement.kind = static_cast<Departure>(kind);
            titles.insert(sentence(departureTitle(judgement), language));
        }
        judgement.withinRounding = true;
        titles.insert(sentence(departureTitle(judgement), language));
    }
    EXPECT_EQ(titles.size(), 16U);
}

}  // namespace
}  // namespace relief::test
