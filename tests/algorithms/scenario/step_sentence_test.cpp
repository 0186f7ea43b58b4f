#include "scenario/step_sentence.h"

#include <set>

#include <gtest/gtest.h>

#include "relief/tracers.h"

namespace relief {
namespace {

Step step(Decision decision) {
    Step s;
    s.decision = decision;
    s.phase = decision == Decision::Start || decision == Decision::Advance ? Phase::Start : Phase::Search;
    s.level = 3;
    s.i = 1;
    s.lambdaIn = 0.112;
    s.lambdaOut = 0.18;
    s.value = 0.7;
    s.lambdaAfter = 0.18;
    return s;
}

void expectSaid(const Message& message) {
    for (const Language language : {Language::English, Language::Ukrainian}) {
        const std::string text = sentence(message, language);
        EXPECT_FALSE(text.empty());
        EXPECT_EQ(text.find('{'), std::string::npos) << text;
    }
    EXPECT_NE(sentence(message), sentence(message, Language::Ukrainian));
}

// Returns the sentences about the steps that the method logs for a ray.
std::vector<std::string> said(const MethodChoice& method, const ViewRay& ray) {
    // One row of eight texels with a wall from s = 4 on; columns, so that heights are the texels' own.
    auto heights = std::make_shared<FloatImage>(8, 1);
    for (int x = 0; x < 8; ++x) (*heights)(x, 0) = x < 4 ? 0.25F : 0.75F;
    Work work;
    MapCache cache;
    const auto tracer = makeTracer(method, HeightField(heights, Surface::Columns, Address::Clamp, 0.25), cache, work);
    RayBlock rays;
    rays.push(ray);
    HitBlock hits;
    StepLog log;
    tracer->trace(rays, hits, log, work);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < log.steps.size(); ++k) {
        sentences.push_back(sentence(stepSentence(log.steps, k, ray)));
    }
    return sentences;
}

TEST(StepSentence, saysWhatSamplingMethodsDid) {
    const ViewRay ray{0.5, 0.5, 8, 0};
    const auto layers = said({"layers", {{"layers", "4"}}}, ray);
    ASSERT_EQ(layers.size(), 4U);
    EXPECT_EQ(layers[0], "Start: the ray enters the slab through its top plane, in texel (0,0).");
    EXPECT_EQ(layers[2],
              "Layer 1 of 4: the ray is at height 0.750, still above the surface at 0.250; the next layer follows.");
    EXPECT_EQ(layers[3],
              "Layer 2 of 4: the ray is at height 0.500, no longer above the surface at 0.750. Hit, placed at height "
              "0.500, at (4.50, 0.50).");
    const auto offset = said({"offset", {}}, ray);
    ASSERT_EQ(offset.size(), 2U);
    EXPECT_EQ(offset[1],
              "One height is sampled, where the ray enters: 0.250. The ray advances straight to height 0.250, at "
              "(6.50, 0.50), without testing the heights in between.");
    const auto secant = said({"layers-secant", {{"layers", "4"}}}, ray);
    ASSERT_EQ(secant.size(), 5U);
    EXPECT_EQ(secant[3],
              "Between heights 0.750 and 0.500 the ray goes below the surface; a straight line between the two layers "
              "gives the intersection at height 0.583.");
    const auto halved = said({"layers-bisection", {{"layers", "4"}, {"bisections", "2"}}}, ray);
    ASSERT_EQ(halved.size(), 6U);
    EXPECT_EQ(halved[3],
              "Half way, at height 0.625, the surface is at 0.250 and the ray is still above it, so the intersection "
              "lies between 0.625 and 0.500.");
    EXPECT_EQ(halved[4],
              "Half way, at height 0.562, the surface is at 0.750 and the ray is no longer above it, so the "
              "intersection lies between 0.625 and 0.562.");
}

TEST(StepSentence, saysTheSkipOfTheSketch) {
    EXPECT_EQ(sentence(stepSentence(step(Decision::Skip), {})),
              "Level 3, texel (1,0): maximum 0.70; the ray leaves the texel at height 0.82. No hit is possible here: "
              "skipped.");
}

// The only formula of [MIP18], with the numbers of the step.
TEST(StepSentence, aDescentDoublesItsCoordinates) {
    Step down = step(Decision::Descend);
    down.subject = subject::Texel{3, 1, 0, 0.7, {}};
    EXPECT_EQ(sentence(stepSentence(down, {})).find("V(i+1)"), std::string::npos) << "no pyramid below it";
    down.subject = subject::Texel{3, 1, 0, 0.7, subject::LevelPoint{1.125, 0.25}};
    EXPECT_EQ(
        sentence(stepSentence(down, {})),
        "Level 3, texel (1,0): maximum 0.70; the ray would leave the texel at height 0.82. A hit is possible here, so "
        "the search goes down a level, where coordinates double: V(i+1) = 2 V(i) = 2 × (1.125, 0.250) = (2.25, 0.50).");
    expectSaid(stepSentence(down, {}));
    // As methods fill in the record: the coordinates lie in the texel, and their doubled values in the next child.
    auto heights = std::make_shared<FloatImage>(16, 8);
    for (int x = 0; x < 16; ++x) {
        for (int y = 0; y < 8; ++y) (*heights)(x, y) = static_cast<float>((7 * x + 3 * y) % 11) / 11;
    }
    Work work;
    MapCache cache;
    for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
        const HeightField field(heights, Surface::Columns, address, 0.25);
        for (const char* name : {"max-pyramid", "max-pyramid-paper"}) {
            RayBlock rays;
            rays.push({3.3, 2.6, 21, -9});
            HitBlock hits;
            StepLog log;
            makeTracer({name, {}}, field, cache, work)->trace(rays, hits, log, work);
            int descents = 0;
            for (std::size_t n = 0; n + 1 < log.steps.size(); ++n) {
                const Step& at = log.steps[n];
                if (at.decision != Decision::Descend) continue;
                const auto ray = at.as<subject::Texel>()->ray;
                ASSERT_TRUE(ray);
                const auto inside = [](double v, std::int64_t texel) {
                    constexpr double kRounding = 1e-9;
                    return v >= static_cast<double>(texel) - kRounding &&
                           v <= static_cast<double>(texel + 1) + kRounding;
                };
                EXPECT_TRUE(inside(ray->x, at.i) && inside(ray->y, at.j));
                const Step& child = log.steps[n + 1];
                ASSERT_EQ(child.level, at.level - 1);
                EXPECT_TRUE(inside(2 * ray->x, child.i) && inside(2 * ray->y, child.j));
                ++descents;
            }
            EXPECT_GT(descents, 2) << name;
        }
    }
}

TEST(StepSentence, anAscentGivesThePapersReason) {
    Step up = step(Decision::Ascend);
    up.lambdaIn = up.lambdaOut;
    up.subject = subject::Texel{3, 1, 0, 0.7, {}};
    const std::string reason = sentence(stepSentence(up, {}));
    EXPECT_NE(reason.find("Its point of height 0.70 is not on the projection of the ray"), std::string::npos) << reason;
    const ViewRay ray{0, 0, 10, 0};
    EXPECT_EQ(sentence(stepSentence(up, {nullptr, ray, Hit::at(ray, 0.4)})), reason) << "the hit comes later";
    const std::string broken = sentence(stepSentence(up, {nullptr, ray, Hit::at(ray, 0.1)}));
    EXPECT_NE(broken.find("although the ray has already met the surface, at height 0.900"), std::string::npos);
    EXPECT_EQ(broken.find("not on the projection"), std::string::npos);
}

TEST(StepSentence, closeNumbersReadDifferently) {
    Step close = step(Decision::Skip);
    close.value = 0.70011;
    close.lambdaOut = 1 - 0.70014;
    EXPECT_EQ(sentence(stepSentence(close, {})),
              "Level 3, texel (1,0): maximum 0.70011; the ray leaves the texel at height 0.70014. No hit is possible "
              "here: skipped.");
    EXPECT_EQ(distinguishingDecimals(0.5, 0.5), 2);
    EXPECT_EQ(distinguishingDecimals(0.5, 0.5 + 1e-12), 6);
    EXPECT_EQ(fixedText(-1e-9, 2), "0.00");
}

TEST(StepSentence, everyDecisionAboutEverythingInBothLanguagesWithNoValueLeftOpen) {
    const std::array<Subject, 7> subjects{subject::Texel{3, 1, 0, 0.7},
                                          subject::Quad{1, 2, 0.5, 0.5, 0.7},
                                          subject::Voxel{1, 0, 2, 4, 16, 0.7},
                                          subject::Sphere{1, 2, 0.9, 0.7},
                                          subject::Cone{1, 2, 0.5, 0.7, 1, 8},
                                          subject::Layer{9, 50, 0.7},
                                          subject::Point{0.7}};
    const Step top = step(Decision::Start);
    for (std::size_t d = 0; d < kDecisionNames.size(); ++d) {
        for (const Subject& subject : subjects) {
            for (const Phase phase : {Phase::Start, Phase::Search, Phase::Refine}) {
                for (const bool known : {false, true}) {
                    Step s = step(static_cast<Decision>(d));
                    s.phase = phase;
                    s.subject = subject;
                    StepContext context;
                    if (known) {
                        context.before = &top;
                        context.ray = ViewRay{1, 2, 3, 4};
                    }
                    expectSaid(stepSentence(s, context));
                    for (const double met : {0.05, 0.15, 0.9}) {
                        context.exact = Hit::at(ViewRay{1, 2, 3, 4}, met);
                        expectSaid(stepSentence(s, context));
                    }
                }
            }
        }
    }
}

TEST(StepSentence, tellsTheKindsOfHitApart) {
    Step hit = step(Decision::Hit);
    hit.level = 0;
    hit.lambdaAfter = 0.613;
    StepContext context;
    context.ray = ViewRay{200, 77, 2, 1};
    EXPECT_EQ(sentence(stepSentence(hit, context)),
              "Level 0, texel (1,0): the ray meets the surface at height 0.387, at (201.23, 77.61): hit.");
    Step before = step(Decision::Advance);
    before.subject = subject::Texel{3, 0, 0, 0.387};
    before.value = 0.387;
    context.before = &before;
    EXPECT_NE(sentence(stepSentence(hit, context)).find("nothing can hide it"), std::string::npos);
    before.value = 0.7;
    EXPECT_EQ(sentence(stepSentence(hit, context)).find("nothing can hide it"), std::string::npos) << "it is lower";
    before.value = 0.387;
    before.subject = subject::Texel{0, 0, 0, 0.387};  // traversal of every cell uses no highest point
    EXPECT_EQ(sentence(stepSentence(hit, context)).find("nothing can hide it"), std::string::npos);
}

// The text presents a map's promise as a promise; if the surface violates it, the text says so.
TEST(StepSentence, resultsAreComparedWithTheFirstHit) {
    const ViewRay ray{0, 0, 3, 4};
    const Hit hit = Hit::at(ray, 0.5);
    const Hit off = Hit::at(ray, 0.7);
    const Hit miss = Hit::none(Outcome::Miss), limit = Hit::none(Outcome::Limit);
    const auto id = [&](const Hit& answer, const Hit& exact) { return answerSentence(answer, exact, ray).id; };
    EXPECT_EQ(id(hit, hit), MessageId::AnswerExact);
    EXPECT_EQ(id(off, hit), MessageId::AnswerOff);
    EXPECT_EQ(id(miss, hit), MessageId::AnswerWrongMiss);
    EXPECT_EQ(id(limit, hit), MessageId::AnswerWrongMiss);
    EXPECT_EQ(id(hit, miss), MessageId::AnswerWrongHit);
    EXPECT_EQ(id(miss, miss), MessageId::AnswerRightMiss);
    EXPECT_EQ(id(hit, limit), MessageId::AnswerUnknown);
    EXPECT_EQ(id(hit, Hit::none(Outcome::Unset)), MessageId::AnswerUnknown);
    // Five texels per unit of lambda.
    const std::string text = sentence(answerSentence(off, hit, ray), Language::English);
    EXPECT_NE(text.find(" 1 "), std::string::npos) << text;
    EXPECT_NE(text.find("0.500"), std::string::npos) << text;
    std::set<std::string> titles;
    for (std::size_t n = 0; n < kDecisionNames.size(); ++n) {
        titles.insert(sentence(decisionTitle(static_cast<Decision>(n)), Language::English));
    }
    EXPECT_EQ(titles.size(), kDecisionNames.size());
}

TEST(StepSentence, aBrokenPromiseIsMentioned) {
    Step s = step(Decision::Advance);
    s.phase = Phase::Search;
    s.lambdaIn = s.lambdaOut = 0.1;
    s.lambdaAfter = 0.3;
    const ViewRay ray{0, 0, 10, 0};
    const auto said = [&](double met) { return sentence(stepSentence(s, {nullptr, ray, Hit::at(ray, met)})); };
    s.subject = subject::Sphere{1, 0, 0.9, 2.5};
    EXPECT_EQ(said(0.4),
              "At height 0.900 the map guarantees 2.50 texels of free space around the ray's point; the ray advances "
              "by that distance, to height 0.700.");
    EXPECT_NE(said(0.2).find("The map is wrong: the ray meets the surface at height 0.800."), std::string::npos);
    EXPECT_NE(said(0.05).find("already behind the surface"), std::string::npos);
    const auto claim = [&](const Hit& exact) { return mapPromise(s, {nullptr, ray, exact}); };
    EXPECT_EQ(claim(Hit()), MapPromise::Kept) << "no exact hit is known";
    EXPECT_EQ(claim(Hit::at(ray, 0.4)), MapPromise::Kept);
    EXPECT_EQ(claim(Hit::at(ray, 0.2)), MapPromise::Broken);
    EXPECT_EQ(claim(Hit::at(ray, 0.05)), MapPromise::Behind);
    EXPECT_EQ(mapPromise(step(Decision::Skip), {nullptr, ray, Hit::at(ray, 0.2)}), MapPromise::None);
    s.subject = subject::Cone{1, 0, 0.5, 0.25, 0, 1};
    EXPECT_EQ(said(0.4).find("map is wrong"), std::string::npos);
    EXPECT_NE(said(0.2).find("The map is wrong"), std::string::npos);
}

// A refined distance reaches through surface that no ray of its kind meets: space that is not free.
TEST(StepSentence, aRefinedDistanceIsNotCalledFreeSpace) {
    for (const bool voxel : {false, true}) {
        Step s = step(Decision::Advance);
        s.phase = Phase::Search;
        const auto said = [&](bool refined) {
            if (voxel) {
                s.subject = subject::Voxel{1, 0, 2, 4, 16, 0.7, refined};
            } else {
                s.subject = subject::Sphere{1, 2, 0.9, 0.7, refined};
            }
            return sentence(stepSentence(s, {}));
        };
        EXPECT_NE(said(false).find("free space"), std::string::npos);
        EXPECT_EQ(said(true).find("free"), std::string::npos);
        EXPECT_NE(said(true).find("meets no surface within 0.70 texels"), std::string::npos) << said(true);
    }
    // The tracers say which distances they read.
    auto heights = std::make_shared<FloatImage>(8, 8, 0.25F);
    for (int y = 0; y < 8; ++y) (*heights)(4, y) = 1;
    const HeightField field(heights, Surface::Columns, Address::Border, 0.5);
    Work work;
    MapCache cache;
    for (const auto& [name, refined] :
         std::initializer_list<std::pair<const char*, bool>>{{"distance", false},
                                                             {"distance-conservative", false},
                                                             {"distance-refined", true},
                                                             {"distance-refined-sampled", true}}) {
        RayBlock rays;
        rays.push({0.5, 3.5, 2, 0});
        HitBlock hits;
        StepLog log;
        makeTracer({name, {}}, field, cache, work)->trace(rays, hits, log, work);
        int advances = 0;
        for (const Step& s : log.steps) {
            if (!s.trustsMap()) continue;
            ++advances;
            EXPECT_EQ(stepSentence(s, {}).id, refined ? MessageId::StepRefined : MessageId::StepSphere) << name;
        }
        EXPECT_GT(advances, 0) << name;
    }
}

// Under repeat the texels after an edge begin anew; the sentence tells why.
TEST(StepSentence, anEdgeOfTheRepeatedPictureIsMentioned) {
    const ViewRay ray{1, 1, 10, 0};
    std::vector<Step> steps(3, step(Decision::Skip));
    steps[2].periodX = 1;
    const auto crossed = [&](std::size_t n) {
        return sentence(stepSentence(steps, n, ray)).find("crossed an edge of the picture") != std::string::npos;
    };
    EXPECT_FALSE(crossed(0));
    EXPECT_FALSE(crossed(1));
    EXPECT_TRUE(crossed(2));
    EXPECT_EQ(sentence(stepSentence(steps, 2, ray)).find(sentence(stepSentence(steps, 1, ray))), 0U);
}

TEST(StepSentence, tellsTheKindsOfMissApart) {
    Step miss = step(Decision::Miss);
    EXPECT_EQ(sentence(stepSentence(miss, {})), "The ray leaves the map at height 0.820 without a hit: miss.");
    miss.lambdaOut = 0;
    EXPECT_EQ(sentence(stepSentence(miss, {})), "The ray enters outside the picture: miss.");
}

}  // namespace
}  // namespace relief
