// The variants that are compared with the scenario's own: never the same one, and a suitable opponent.
#include "scenario/variation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "relief/reliefs.h"
#include "relief/tracers.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

constexpr CompareSubject kAll[]{CompareSubject::Methods, CompareSubject::Filters, CompareSubject::Mappings,
                                CompareSubject::Heights};

Scenario comparing(CompareSubject subject) {
    Scenario scenario;
    scenario.pictures.recipe = "bricks";
    scenario.comparison.subject = subject;
    return scenario;
}

bool allDiffer(const Scenario& scenario) {
    const std::vector<MethodChoice> all = comparedOf(scenario);
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (sameVariation(scenario.comparison.subject, all[a], all[b])) return false;
        }
    }
    return true;
}

TEST(Variation, WhatIsAddedIsNotThereYet) {
    for (const CompareSubject subject : kAll) {
        for (const std::string& name : variationNames(subject)) {
            Scenario scenario = comparing(subject);
            scenario.surface = Surface::Columns;
            scenario = varied(scenario, subject, {name, {}});
            for (std::size_t n = 1; n < kMostCompared; ++n) {
                const auto next = nextVariation(scenario);
                ASSERT_TRUE(next) << name;
                othersOf(scenario.comparison).push_back(*next);
                checkVariation(subject, *next, "test");
                if (subject == CompareSubject::Methods) {
                    EXPECT_TRUE(supports(*next, scenario.surface, scenario.address)) << next->name;
                }
            }
            EXPECT_TRUE(allDiffer(scenario)) << name;
            checkScenario(scenario, "test");
            EXPECT_EQ(parseScenario(scenarioText(scenario), "s.json"), scenario) << name;
        }
    }
}

TEST(Variation, TheScenariosOwnIsItself) {
    for (const CompareSubject subject : kAll) {
        for (const std::string& name : variationNames(subject)) {
            const Scenario scenario = varied(comparing(subject), subject, {name, {}});
            EXPECT_EQ(varied(scenario, subject, ownVariation(scenario, subject)), scenario) << name;
            // Explicit default values make no difference.
            MethodChoice full{name, describedVariation(subject, {name, {}}).defaults};
            EXPECT_TRUE(sameVariation(subject, full, {name, {}})) << variationText(subject, full);
        }
    }
    EXPECT_FALSE(sameVariation(CompareSubject::Methods, {"layers", {{"layers", "7"}}}, {"layers", {}}));
}

TEST(Variation, TheSameNameGetsAnOptionOfItsOwn) {
    for (const CompareSubject subject : kAll) {
        for (const std::string& name : variationNames(subject)) {
            Scenario scenario = varied(comparing(subject), subject, {name, {}});
            const auto other = variedOption(scenario, name);
            if (!other) {
                EXPECT_LE(describedVariation(subject, {name, {}}).options.size(), 1U) << name;
                continue;
            }
            checkVariation(subject, *other, "test");
            othersOf(scenario.comparison) = {*other};
            EXPECT_TRUE(allDiffer(scenario)) << name;
        }
    }
}

// If A becomes equal to B, B takes A's former value, or the next one if that is listed as well.
TEST(Variation, AChangeToWhatIsThereSwaps) {
    Scenario before = comparing(CompareSubject::Filters);
    before.comparison.others = {{"layers", {}}, {"offset", {}}};
    before.comparison.filters = {{"trilinear", {}}};
    Scenario after = before;
    after.method = {"layers", {}};
    after.filter.name = "trilinear";
    after = keptApart(before, after);
    EXPECT_EQ(after.comparison.others, (std::vector<MethodChoice>{before.method, {"offset", {}}}));
    EXPECT_EQ(after.comparison.filters, (std::vector<MethodChoice>{{"bilinear", {}}}));
    EXPECT_EQ(after.comparison.subject, CompareSubject::Filters);
    before.comparison.others.push_back(before.method);
    after = before;
    after.method = {"layers", {}};
    after = keptApart(before, after);
    after.comparison.subject = CompareSubject::Methods;
    EXPECT_TRUE(allDiffer(after));
    // While a slider of A passes B's value, nothing else changes.
    before.method = {"layers", {{"layers", "8"}}};
    after = before;
    after.method.options["layers"] = describedVariation(CompareSubject::Methods, before.method).defaults.at("layers");
    EXPECT_EQ(keptApart(before, after), after);
}

TEST(Variation, OpponentsAreSuitable) {
    const auto exact = [](const MethodChoice& method) {
        return findTracer(method.name).guarantee == Guarantee::Exact && !method.options.contains("base");
    };
    for (const MethodDescription& method : tracerList()) {
        for (const Surface surface : method.surfaces) {
            Scenario scenario = comparing(CompareSubject::Filters);
            scenario.surface = surface;
            scenario.method = {method.name, {}};
            for (const std::vector<MethodChoice>& others :
                 {std::vector<MethodChoice>{}, {scenario.method}, {{"exact", {}}, {"layers", {}}}, {{"flat", {}}}}) {
                scenario.comparison.others = others;
                const std::vector<MethodChoice> rivals = rivalsOf(scenario);
                ASSERT_FALSE(rivals.empty());
                for (const MethodChoice& rival : rivals) {
                    EXPECT_FALSE(sameVariation(CompareSubject::Methods, rival, scenario.method)) << method.name;
                    EXPECT_TRUE(supports(rival, surface, scenario.address)) << rival.name;
                }
                EXPECT_FALSE(exact(rivalOf(scenario)) && exact(scenario.method)) << method.name;
            }
        }
    }
    Scenario scenario = comparing(CompareSubject::Methods);
    scenario.method = {"layers", {}};
    EXPECT_EQ(rivalOf(scenario).name, "exact");
    scenario.method = {"max-pyramid", {{"base", "2"}}};
    EXPECT_EQ(rivalOf(scenario).name, "exact");
    scenario.method = {"exact", {}};
    EXPECT_EQ(rivalOf(scenario).name, "layers");
}

TEST(Variation, HeightsAreRoundedToBits) {
    const auto heights = std::make_shared<const FloatImage>(makeRelief("fractal", 32, 32, 5));
    EXPECT_EQ(variedHeights(heights, {kAsRead, {}}), heights);
    for (const int bits : {1, 4, 8, 16}) {
        const auto rounded = variedHeights(heights, {kQuantised, {{kBits, std::to_string(bits)}}});
        const double units = std::pow(2.0, bits) - 1;
        for (std::size_t i = 0; i < heights->pixels().size(); ++i) {
            const double unit = rounded->pixels()[i] * units;
            EXPECT_NEAR(unit, std::round(unit), 1e-2);
            EXPECT_NEAR(rounded->pixels()[i], heights->pixels()[i], 0.5001 / units);
        }
    }
}

TEST(Variation, TheTruthOfFiltersHasNoFewerSamplesThanAnyOfThem) {
    Scenario scenario = comparing(CompareSubject::Filters);
    EXPECT_EQ(referenceVariation(scenario).options.at(kSamples), "8");
    scenario.comparison.filters = {{"supersample", {{kSamples, "16"}, {kPixelModel, "gaussian"}}}};
    EXPECT_EQ(referenceVariation(scenario).options.at(kSamples), "16");
    EXPECT_EQ(referenceVariation(scenario).options.at(kPixelModel), "gaussian");
    // Other filters have no model of a pixel.
    scenario.comparison.filters = {{"supersample", {{kSamples, "4"}, {kPixelModel, "gaussian"}}}, {"trilinear", {}}};
    EXPECT_EQ(referenceVariation(scenario).options.at(kSamples), "8");
    EXPECT_EQ(referenceVariation(scenario).options.at(kPixelModel), "gaussian");
}

}  // namespace
}  // namespace relief::test
