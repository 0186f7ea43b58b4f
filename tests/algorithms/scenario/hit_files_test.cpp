// Files of hits of other tracers: only what they must hold is needed, and what is wrong is named with its line.
#include <cmath>

#include <gtest/gtest.h>

#include "scenario/ray_files.h"

namespace relief::test {

TEST(HitFiles, OurOwnAreReadBack) {
    HitBlock hits(3);
    hits.set(0, Hit::at({1, 2, 3, 4}, 0.1));
    hits.set(1, Hit::none(Outcome::Miss));
    hits.set(2, Hit::none(Outcome::Limit));
    hits.steps = {7, 1, 40};
    std::string text = std::string(kHitsHeader) + "\n";
    appendHitLines(text, hits, 0, hits.size());
    const HitBlock read = parseHits(text, "hits.csv");
    EXPECT_EQ(read.outcome, hits.outcome);
    EXPECT_EQ(read.steps, hits.steps);
    EXPECT_EQ(read.lambda[0], 0.1);
    EXPECT_EQ(read.s[0], hits.s[0]);
    EXPECT_TRUE(std::isnan(read.lambda[1]) && std::isnan(read.t[2]));
}

TEST(HitFiles, TwoColumnsAreEnough) {
    const HitBlock read = parseHits("\xEF\xBB\xBFoutcome,lambda,color\r\nhit,1.000001,red\r\nmiss,,\r\n\n", "hits.csv");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read.lambda[0], 1);  // a sum in float
    EXPECT_TRUE(std::isnan(read.s[0]));
    EXPECT_EQ(read.steps[0], 0U);
    EXPECT_EQ(parseHits("outcome,lambda\n", "hits.csv").size(), 0U);
}

TEST(HitFiles, TheLastLineNeedsNoEnd) {
    const HitBlock read = parseHits("outcome,lambda\nhit,0.5\nhit,0.25", "hits.csv");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read.outcome[1], Outcome::Hit);
    EXPECT_EQ(read.lambda[1], 0.25);
}

TEST(HitFiles, WhatIsWrongIsNamedWithItsLine) {
    const auto said = [](const std::string& text) -> std::string {
        try {
            parseHits(text, "hits.csv");
        } catch (const InputError& error) {
            return error.text(Language::English);
        }
        return "";
    };
    EXPECT_NE(said("lambda,outcome\n").find("line 1"), std::string::npos);
    EXPECT_NE(said("outcome,lambdas\n").find("line 1"), std::string::npos);
    EXPECT_NE(said("outcome,lambda\nhit,0.5\nhit\n").find("line 3"), std::string::npos);
    EXPECT_NE(said("outcome,lambda\nhit,\n").find("line 2"), std::string::npos);
    EXPECT_NE(said("outcome,lambda\nhit,nan\n").find("line 2"), std::string::npos);
    EXPECT_NE(said("outcome,lambda\nhit,-0.1\n").find("lambda"), std::string::npos);
    EXPECT_NE(said("outcome,lambda\nHit,0.1\n").find("hit, miss, limit"), std::string::npos);
    EXPECT_NE(said("outcome,lambda,s\nhit,0.1,x\n").find("line 2"), std::string::npos);
}

}  // namespace relief::test
