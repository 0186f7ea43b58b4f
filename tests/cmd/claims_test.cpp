// The papers' claims as they are printed; tests/benchmarks/claims.cpp measures them.
#include <set>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class ClaimsTest : public CommandTest {};
INSTANTIATE_TEST_SUITE_P(Places, ClaimsTest, testing::ValuesIn(places()), placeName);

TEST_P(ClaimsTest, TheTableThatShipsInBothLanguagesAndAsJson) {
    const auto table = nlohmann::json::parse(runFine({"claims", "--json"}));
    ASSERT_TRUE(table.contains("claims"));
    ASSERT_GT(table["claims"].size(), 20U);
    const std::string english = runFine({"claims", "--language", "en"});
    const std::string ukrainian = runFine({"claims", "--language", "uk"});
    EXPECT_NE(english, ukrainian);
    EXPECT_EQ(lines(english).size(), lines(ukrainian).size());
    // After the two lines of the head there is a line per claim, which ends in the verdict.
    const auto rows = lines(english);
    ASSERT_EQ(rows.size(), table["claims"].size() + 2);
    std::multiset<std::string> said, expected;
    for (const auto& claim : table["claims"]) expected.insert(claim["verdict"].get<std::string>());
    for (std::size_t n = 2; n < rows.size(); ++n) said.insert(rows[n].substr(rows[n].rfind(" | ") + 3));
    EXPECT_EQ(said, expected);
    runFine({"claims", "-o", path("claims.json")});
    EXPECT_EQ(nlohmann::json::parse(read("claims.json")), table);
    runFine({"claims", "-o", path("claims.txt"), "--language", "en"});
    EXPECT_EQ(read("claims.txt"), english);
}

TEST_P(ClaimsTest, OptionsOfMeasuringNeedMeasuring) {
    for (const char* option : {"--size", "--rays", "--rounds"}) {
        expectRefusal({"claims", option, "64"}, 2, {option, "--measure"});
    }
    expectRefusal({"claims", "--measure", "--size", "8"}, 2, {"--size", "16"});
    expectRefusal({"claims", "-o", path("claims.csv")}, 2, {"claims.csv"});
}

}  // namespace relief::test
