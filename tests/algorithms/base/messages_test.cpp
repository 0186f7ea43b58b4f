// Suggestions for names that resemble known ones; progress of work in several stages.
#include "relief/messages.h"

#include <gtest/gtest.h>

#include "relief/reliefs.h"
#include "relief/work.h"

namespace relief::test {
namespace {

TEST(Messages, slipsOfTheFingerAreNearNames) {
    const std::vector<std::string> names{"exact", "max-pyramid", "layers", "layers-secant", "cone", "cone-dummer"};
    for (const auto& [typed, meant] :
         std::vector<std::pair<std::string, std::string>>{{"coen", "cone"},
                                                          {"cones", "cone"},
                                                          {"Cone", "cone"},
                                                          {"con", "cone"},
                                                          {"layer", "layers"},
                                                          {"layers-secnat", "layers-secant"},
                                                          {"maxpyramid", "max-pyramid"},
                                                          {"dummer", "cone-dummer"},
                                                          {"magic", ""},
                                                          {"x", ""},
                                                          {"", ""}}) {
        EXPECT_EQ(nearestName(typed, names), meant) << typed;
    }
    EXPECT_EQ(nearestName("ab", {"a", "xy"}), "") << "all short names would be suggestions";
    EXPECT_EQ(nearestName(std::string(100'000, 'x'), names), "");
}

TEST(Messages, unknownNamesAreAnsweredByWhatIsNearAndWhatIsKnown) {
    const auto said = [](const std::string& name, const std::string& known) {
        return sentence(unknownName({"what", MessageId::WordTracer}, name, known));
    };
    EXPECT_EQ(said("coen", "exact, cone"), "there is no tracer \"coen\"; did you mean \"cone\"? Known: exact, cone");
    EXPECT_EQ(said("magic", "exact, cone"), "there is no tracer \"magic\"; known: exact, cone");
    EXPECT_EQ(said("magic", ""), "there is no tracer \"magic\"; none exist");
}

// Nested stages are not reported and do not restart the outer one.
TEST(Progress, ofSeveralStagesIsReportedAsOne) {
    std::vector<std::string> reported;
    Progress progress([&](std::string_view what, double fraction) {
        reported.push_back(std::string(what) + " " + numberText(fraction));
    });
    {
        WholeProgress whole(progress, "all", 4);
        whole.advance();
        progress.begin("stage", 10);
        progress.advance(5);
        WholeProgress inner(progress, "part", 2);
        inner.advance();
        whole.advance();
    }
    progress.begin("next", 1);
    EXPECT_EQ(reported, (std::vector<std::string>{"all 0", "all 0.25", "all 0.5", "next 0"}));
}

TEST(Progress, reliefsAreMadeRowByRowAndCanBeStopped) {
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (!recipe.anySize || recipe.name == "checker" || recipe.name == "paper-walls") continue;
        double last = 0;
        std::stop_source stop;
        Work work(1, stop.get_token(), [&](std::string_view, double fraction) { last = fraction; });
        EXPECT_EQ(makeRelief(recipe.name, 40, 70, 3, &work), makeRelief(recipe.name, 40, 70, 3)) << recipe.name;
        EXPECT_EQ(last, 1) << recipe.name;
        stop.request_stop();
        EXPECT_THROW(makeRelief(recipe.name, 40, 70, 3, &work), Cancelled) << recipe.name;
    }
}

}  // namespace
}  // namespace relief::test
