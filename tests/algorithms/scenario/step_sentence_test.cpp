#include "scenario/step_sentence.h"

#include <gtest/gtest.h>

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

TEST(StepSentence, saysTheSkipOfTheSketch) {
    EXPECT_EQ(sentence(stepSentence(step(Decision::Skip), {})),
              "Level 3, texel (1,0): maximum 0.70, the ray leaves it at 0.82: nothing here, skipped.");
}

TEST(StepSentence, closeNumbersReadDifferently) {
    Step close = step(Decision::Skip);
    close.value = 0.70011;
    close.lambdaOut = 1 - 0.70014;
    EXPECT_EQ(sentence(stepSentence(close, {})),
              "Level 3, texel (1,0): maximum 0.70011, the ray leaves it at 0.70014: nothing here, skipped.");
    EXPECT_EQ(tellingDecimals(0.5, 0.5), 2);
    EXPECT_EQ(tellingDecimals(0.5, 0.5 + 1e-12), 6);
    EXPECT_EQ(fixedText(-1e-9, 2), "0.00");
}

TEST(StepSentence, everyDecisionInBothLanguagesWithNoValueLeftOpen) {
    for (std::size_t d = 0; d < kDecisionNames.size(); ++d) {
        for (const bool hierarchy : {false, true}) {
            for (const std::optional<ViewRay>& ray :
                 {std::optional<ViewRay>{}, std::optional<ViewRay>{ViewRay{1, 2, 3, 4}}}) {
                for (const Phase phase : {Phase::Start, Phase::Search, Phase::Refine}) {
                    for (const auto before : {std::optional<Decision>{}, std::optional{Decision::Start}}) {
                        Step s = step(static_cast<Decision>(d));
                        s.phase = phase;
                        const Message message = stepSentence(s, {hierarchy, before, ray});
                        for (const Language language : {Language::English, Language::Ukrainian}) {
                            const std::string text = sentence(message, language);
                            EXPECT_FALSE(text.empty());
                            EXPECT_EQ(text.find('{'), std::string::npos) << text;
                        }
                        EXPECT_NE(sentence(message), sentence(message, Language::Ukrainian));
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
    context.before = Decision::Advance;
    EXPECT_NE(sentence(stepSentence(hit, context)).find("nothing can hide it"), std::string::npos);
    context.hierarchy = false;  // a walk over every cell knows no highest point
    EXPECT_EQ(sentence(stepSentence(hit, context)).find("nothing can hide it"), std::string::npos);
}

TEST(StepSentence, tellsTheKindsOfMissApart) {
    Step miss = step(Decision::Miss);
    EXPECT_EQ(sentence(stepSentence(miss, {})), "The ray leaves the map at height 0.820 without a hit: miss.");
    miss.lambdaOut = 0;
    EXPECT_EQ(sentence(stepSentence(miss, {})), "The ray enters outside the picture: miss.");
}

}  // namespace
}  // namespace relief
