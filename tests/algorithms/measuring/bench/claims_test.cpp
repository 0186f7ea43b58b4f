// The table of the papers' claims: the shipped one is complete, and measuring again fills in every sentence.
#include "measuring/bench/claims.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "relief/errors.h"

namespace relief::test {
namespace {

std::size_t lineCount(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void expectWhole(const ClaimsTable& table) {
    std::set<std::string> ids;
    for (const MeasuredClaim& claim : table.claims) EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    for (const Claim& claim : paperClaims()) EXPECT_TRUE(ids.contains(std::string(claim.id))) << claim.id;
    EXPECT_EQ(ids.size(), paperClaims().size());
    for (const Language language : {Language::English, Language::Ukrainian}) {
        const std::string text = claimsText(table, language);
        EXPECT_EQ(text.find('{'), std::string::npos) << text;
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
        EXPECT_EQ(lineCount(text), 2 + paperClaims().size());
    }
}

TEST(Claims, TheShippedTableIsWhole) {
    const ClaimsTable& table = shippedClaims();
    EXPECT_GE(table.claims.size(), 20U);
    EXPECT_EQ(table.date.size(), 10U) << table.date;
    EXPECT_FALSE(table.cpu.empty());
    expectWhole(table);
    // Results that no paper states are not attributed to one.
    EXPECT_EQ(claimsText(table, Language::English).find("25%"), std::string::npos);
}

TEST(Claims, MeasuringAgainFillsEverySentence) {
    ClaimsOptions options;
    options.size = 32;
    options.rays = 200;
    options.rounds = 1;
    Work work;
    const ClaimsTable table = measureClaims(options, work);
    expectWhole(table);
    const auto verdict = [&](const std::string& id) {
        return std::find_if(table.claims.begin(), table.claims.end(),
                            [&](const MeasuredClaim& c) { return c.id == id; })
            ->verdict;
    };
    // Claims whose result does not depend on the number of rays.
    for (const char* id : {"no-loss", "example", "direct-counts", "row-constant", "unchanged", "highest"}) {
        EXPECT_EQ(verdict(id), ClaimVerdict::Confirmed) << id;
    }
    EXPECT_EQ(verdict("two-a-level"), ClaimVerdict::Refuted);
    const ClaimsTable again = parseClaims(claimsJson(table), "claims.json");
    EXPECT_EQ(claimsJson(again), claimsJson(table));
    EXPECT_EQ(claimsText(again, Language::English), claimsText(table, Language::English));
    for (const char* wrong : {"", "[]", "{}", "{\"claims\": 3}"}) {
        EXPECT_THROW(parseClaims(wrong, "wrong.json"), InputError) << wrong;
    }
}

}  // namespace
}  // namespace relief::test
