// The advice for hand-made measurements, checked against independent implementations of the definitions in recommend.h.
#include <algorithm>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "measuring/advise/recommend_trials.h"

namespace relief::test {
namespace {

AdviceTrial trial(const std::string& name, double cost, std::int64_t bytes, Verdict verdict = Verdict::Kept,
                  double beyond = 0) {
    AdviceTrial one;
    one.facts.method.name = name;
    one.facts.cost = one.facts.secondsPerRay = cost;
    one.facts.bytes = bytes;
    one.facts.verdict = verdict;
    one.facts.beyond = beyond;
    return one;
}

AdviceOptions options(Heights heights = randomHeights(8, 8, 1)) {
    return AdviceOptions(HeightField(std::move(heights)));
}

// The names of the chosen method, the cheapest, the next best, and the best without a map.
struct Names {
    std::string chosen, cheapest, next, withoutMap;
    bool operator==(const Names&) const = default;
};
Names names(const Advice& advice) {
    const auto name = [&](std::size_t f) { return advice.forms.at(f).method.name; };
    return {name(advice.chosen), name(advice.cheapest), name(advice.next),
            advice.withoutMap ? name(*advice.withoutMap) : ""};
}
void PrintTo(const Names& n, std::ostream* out) {
    *out << "chosen " << n.chosen << ", cheapest " << n.cheapest << ", next " << n.next << ", without a map "
         << n.withoutMap;
}

// Ties are measured from the best form, so a chain of ties leads no further.
TEST(Advice, TiesDoNotAddUp) {
    const double tie = 1 + kAdviceTie;
    const std::vector<AdviceTrial> chain{trial("large", 1, 300), trial("middle", tie, 200),
                                         trial("small", tie * tie, 100)};
    EXPECT_EQ(names(adviceOf(options(), chain)), (Names{"middle", "large", "middle", ""}));
}

TEST(Advice, IsTheLeanestOfThoseThatAreAsGood) {
    EXPECT_EQ(names(adviceOf(options(),
                             {trial("slow", 1.1, 0), trial("fast", 1, 100), trial("out", 0.1, 10, Verdict::Error)})),
              (Names{"fast", "fast", "slow", "slow"}));
    // With equal map sizes the one that is built faster is chosen; with equal build times the cheapest.
    auto late = trial("late", 1, 100), soon = trial("soon", 1.01, 100);
    late.facts.buildSeconds = 2;
    soon.facts.buildSeconds = 1;
    EXPECT_EQ(names(adviceOf(options(), {late, soon})).chosen, "soon");
    soon.facts.buildSeconds = 2;
    EXPECT_EQ(names(adviceOf(options(), {soon, late})), (Names{"late", "late", "soon", ""}));
    // Slower methods keep the bounds but are not as good; methods that violate them are not considered.
    EXPECT_EQ(names(adviceOf(options(), {trial("out", 1, 0, Verdict::Memory), trial("slower", 1, 0, Verdict::Slow),
                                         trial("kept", 1, 50)})),
              (Names{"kept", "kept", "slower", "slower"}));
}

TEST(Advice, OfNoneThatKeepsTheBoundsIsTheNearest) {
    auto within = options();
    const std::vector<AdviceTrial> all{trial("worse", 1, 0, Verdict::Error, 0.5),
                                       trial("near", 2, 0, Verdict::Error, 0.01),
                                       trial("unknown", 0.1, 0, Verdict::Memory, AdvisedForm::kUnknown)};
    const Advice advice = adviceOf(within, all);
    EXPECT_FALSE(advice.keepsBounds);
    EXPECT_EQ(names(advice), (Names{"near", "near", "near", ""}));
    // With a step budget, methods that satisfy it come first.
    within.maxSteps = 10;
    auto long_ = all;
    long_[0].facts.overSteps = 0;
    long_[1].facts.overSteps = 0.9;
    EXPECT_EQ(names(adviceOf(within, long_)).chosen, "worse");
    // Methods without any error are compared by the rays that exceed the step budget.
    auto longest = trial("longest", 1, 0, Verdict::Steps), longer = trial("longer", 2, 0, Verdict::Steps);
    longest.facts.overSteps = 0.9;
    longer.facts.overSteps = 0.3;
    EXPECT_EQ(names(adviceOf(within, {longest, longer})).chosen, "longer");
}

TEST(Advice, OfAFlatMapNeedsNoMap) {
    const std::vector<AdviceTrial> all{trial("map", 1, 100), trial("plain", 1.5, 0), trial("exact", 3, 0)};
    const Advice flat = adviceOf(options(constantHeights(8, 8, 0.5F)), all);
    EXPECT_TRUE(flat.relief.flat);
    EXPECT_EQ(names(flat), (Names{"plain", "plain", "plain", "plain"}));
    EXPECT_EQ(flat.forms[flat.exact].method.name, "exact");
    const Advice rough = adviceOf(options(), all);
    EXPECT_FALSE(rough.relief.flat);
    EXPECT_EQ(names(rough), (Names{"map", "map", "plain", "plain"}));
    // If no method without a map keeps the bounds, the choice is the same as for any map.
    const std::vector<AdviceTrial> maps{trial("large", 1, 100), trial("small", 1, 50),
                                        trial("plain", 2, 0, Verdict::Steps)};
    EXPECT_EQ(names(adviceOf(options(constantHeights(8, 8, 0.5F)), maps)), (Names{"small", "large", "small", ""}));
}

// If the heights change after every few pictures, the build time of a map must pay off within those pictures.
TEST(Advice, WeighsBuildingAgainstRays) {
    auto map = trial("map", 1e-6, 100), plain = trial("plain", 2e-6, 0);
    map.facts.buildSeconds = 5;
    const Advice advice = adviceOf(options(), {map, plain});
    EXPECT_EQ(names(advice).chosen, "map");
    ASSERT_TRUE(advice.rebuilt);
    EXPECT_EQ(advice.forms[*advice.rebuilt].method.name, "plain");
    EXPECT_DOUBLE_EQ(advice.paysAfterRays, 5 / 1e-6);
    plain.facts.buildSeconds = 0.25;  // building its map takes time as well
    EXPECT_DOUBLE_EQ(adviceOf(options(), {map, plain}).paysAfterRays, 4.75 / 1e-6);
    plain.facts.buildSeconds = 0;
    map.facts.buildSeconds = 1e-3;
    EXPECT_FALSE(adviceOf(options(), {map, plain}).rebuilt);
}

// The definitions hold for random tables with similar costs.
TEST(Advice, KeepsItsDefinitionsOnDrawnTables) {
    Random random(31);
    for (int table = 0; table < 2000; ++table) {
        std::vector<AdviceTrial> all;
        const int count = 1 + random.below(7);
        for (int n = 0; n < count; ++n) {
            const auto verdict = static_cast<Verdict>(random.below(3) == 0 ? random.below(7) : 0);
            all.push_back(trial(std::to_string(n), 1 + 0.01 * random.below(8), 100 * random.below(4), verdict,
                                0.1 * random.below(5)));
        }
        const Advice advice = adviceOf(options(), all);
        double best = std::numeric_limits<double>::infinity();
        for (const AdviceTrial& one : all) {
            if (one.facts.verdict == Verdict::Kept) best = std::min(best, one.facts.cost);
        }
        if (std::isinf(best)) continue;
        const AdvisedForm& chosen = advice.best();
        EXPECT_EQ(chosen.verdict, Verdict::Kept);
        EXPECT_LE(chosen.cost, best * (1 + kAdviceTie));
        EXPECT_EQ(advice.forms[advice.cheapest].cost, best);
        EXPECT_EQ(advice.forms[advice.cheapest].verdict, Verdict::Kept);
        std::int64_t fewest = chosen.bytes;
        for (const AdviceTrial& one : all) {
            const bool asGood = one.facts.verdict == Verdict::Kept && one.facts.cost <= best * (1 + kAdviceTie);
            if (asGood) fewest = std::min(fewest, one.facts.bytes);
        }
        EXPECT_EQ(chosen.bytes, fewest);
        EXPECT_EQ(advice.forms.size(), all.size());
    }
}

TEST(Advice, TakesLongerForLargerMaps) {
    EXPECT_EQ(adviceSeconds(HeightField(constantHeights(8, 8, 0.5F))), 4);
    EXPECT_EQ(adviceSeconds(HeightField(constantHeights(1024, 1024, 0.5F))), 4);
    EXPECT_EQ(adviceSeconds(HeightField(constantHeights(4096, 1024, 0.5F))), 8);
    EXPECT_EQ(adviceSeconds(HeightField(constantHeights(8192, 4096, 0.5F))), 16);
    EXPECT_EQ(options().seconds, 4);
}

TEST(Advice, PieceIsTheMiddleOfTheMap) {
    const HeightField field(randomHeights(20, 9, 3), Surface::Columns, Address::Border, 0.2);
    const HeightField piece = middlePiece(field, 10);
    EXPECT_EQ(piece.width(), 10);
    EXPECT_EQ(piece.height(), 9);
    EXPECT_EQ(piece.surface(), Surface::Columns);
    EXPECT_EQ(piece.address(), Address::Border);
    EXPECT_DOUBLE_EQ(piece.slabTexels(), field.slabTexels());
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 10; ++x) EXPECT_EQ(piece.texel(x, y), field.texel(x + 5, y));
    }
    const HeightField small = middlePiece(field, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) EXPECT_EQ(small.texel(x, y), field.texel(x + 8, y + 3));
    }
}

}  // namespace
}  // namespace relief::test
