// The sums over the cases of a stress run, and the lines that record cases, tested with hand-made cases.
#include "measuring/verify/stress_record.h"

#include <limits>

#include <gtest/gtest.h>

namespace relief::test {
namespace {

StressViolation violation(const std::string& kind, const std::string& detail) {
    return {{"bits", detail}, "exact", "at-limit", "noise", "relief trace --ray 1,2", kind};
}

StressCase caseOf(std::uint64_t number, const std::string& map, const std::string& size) {
    StressCase one;
    one.number = number;
    one.map = map;
    one.size = size;
    return one;
}

StressMethodCoverage coverage(std::map<std::string, std::uint64_t> rays, std::set<std::string> forms,
                              std::uint64_t logs, double worst, const std::string& where) {
    return {std::move(rays), std::move(forms), logs, worst, where};
}

TEST(StressRecord, CasesAddUp) {
    StressCase one = caseOf(0, "noise", "8x8"), two = caseOf(1, "noise", "1x7"), three = caseOf(2, "pit", "8x8");
    one.methods["exact"] = coverage({{"far", 3}, {"near", 1}}, {""}, 2, 0.5, "far over noise");
    two.methods["exact"] = coverage({{"far", 4}}, {"a=1"}, 5, 0.75, "near over noise");
    three.methods["exact"] = coverage({{"flat", 7}}, {""}, 1, 0.75, "flat over pit");
    three.methods["layers"] = coverage({{"flat", 2}}, {""}, 0, 0, "");
    one.parts["frames"] = {{{"far", 2}}, 1};
    three.parts["frames"] = {{{"far", 1}, {"near", 4}}, 2};
    one.violationCount = 3;
    three.violationCount = 4;
    StressTally tally;
    for (const StressCase& added : {one, two, three}) tally.add(added);
    const StressReport& report = tally.report();
    EXPECT_EQ(report.cases, 3U);
    EXPECT_EQ(report.maps, (std::map<std::string, std::uint64_t>{{"noise", 2}, {"pit", 1}}));
    EXPECT_EQ(report.sizes, (std::set<std::string>{"8x8", "1x7"}));
    EXPECT_EQ(report.violationCount, 7U);
    EXPECT_TRUE(report.violations.empty());
    const StressMethodCoverage& exact = report.methods.at("exact");
    EXPECT_EQ(exact.rays, (std::map<std::string, std::uint64_t>{{"far", 7}, {"near", 1}, {"flat", 7}}));
    EXPECT_EQ(exact.total(), 15U);
    EXPECT_EQ(exact.forms, (std::set<std::string>{"", "a=1"}));
    EXPECT_EQ(exact.logs, 8U);
    EXPECT_EQ(exact.worstBound, 0.75);
    EXPECT_EQ(exact.worstWhere, "near over noise") << "the first of two that are as bad";
    EXPECT_EQ(report.methods.at("layers").total(), 2U);
    EXPECT_EQ(report.parts.at("frames").tried, (std::map<std::string, std::uint64_t>{{"far", 3}, {"near", 4}}));
    EXPECT_EQ(report.parts.at("frames").refused, 3U);
    EXPECT_EQ(report.parts.at("frames").total(), 7U);
}

// At most five violations of a kind are listed, up to the total limit, in order of occurrence.
TEST(StressRecord, FewOfEachKindAreListed) {
    constexpr std::size_t kAlike = 5, kListed = 8;
    StressTally tally(kListed);
    for (std::uint64_t n = 0; n < kAlike + 2; ++n) {
        EXPECT_EQ(tally.lists("one"), n < kAlike) << n;
        StressCase added = caseOf(n, "noise", "8x8");
        added.violations.push_back(violation("one", std::to_string(n)));
        tally.add(added);
    }
    EXPECT_FALSE(tally.full());
    EXPECT_TRUE(tally.lists("two"));
    StressCase last = caseOf(9, "noise", "8x8");
    for (const char* kind : {"two", "three", "four", "five"}) last.violations.push_back(violation(kind, kind));
    tally.add(last);
    EXPECT_TRUE(tally.full());
    std::vector<std::string> listed;
    for (const StressViolation& one : tally.report().violations) listed.push_back(one.fault.detail);
    EXPECT_EQ(listed, (std::vector<std::string>{"0", "1", "2", "3", "4", "two", "three", "four"}));
}

// Every member is read back, numbers with all bits.
TEST(StressRecord, ACaseIsReadBackFromItsLine) {
    StressCase one = caseOf(std::uint64_t{1} << 63, "fine \"checker\"\n", "65536x1");
    one.violationCount = 12345678901234567890U;
    const double worst = 0.1 + 0.2, endless = std::numeric_limits<double>::infinity();
    one.methods["exact"] = coverage({{"far", 18446744073709551615U}}, {"", "layers=3"}, 4, worst, "far over noise");
    one.methods["layers"] = coverage({}, {}, 0, endless, "");
    one.parts["rows"] = {{{"affine", 3}}, 2};
    one.violations = {violation("tracers exact bits", "\xd1\x80\xd0\xb5\xd0\xbb\xd1\x8c\xd1\x94\xd1\x84"),
                      violation("", "")};
    const std::string line = stressCaseLine(one);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    for (const char letter : line.substr(0, line.size() - 1)) EXPECT_TRUE(letter >= ' ' && letter <= '~') << letter;
    const auto read = parseStressCase(line);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->number, one.number);
    EXPECT_EQ(read->map, one.map);
    EXPECT_EQ(read->size, one.size);
    EXPECT_EQ(read->violationCount, one.violationCount);
    ASSERT_EQ(read->methods.size(), 2U);
    EXPECT_EQ(read->methods.at("exact").rays, one.methods.at("exact").rays);
    EXPECT_EQ(read->methods.at("exact").forms, one.methods.at("exact").forms);
    EXPECT_EQ(read->methods.at("exact").logs, 4U);
    EXPECT_EQ(read->methods.at("exact").worstBound, worst);
    EXPECT_EQ(read->methods.at("exact").worstWhere, "far over noise");
    EXPECT_EQ(read->methods.at("layers").worstBound, endless);
    EXPECT_EQ(read->parts.at("rows").tried, one.parts.at("rows").tried);
    EXPECT_EQ(read->parts.at("rows").refused, 2U);
    ASSERT_EQ(read->violations.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
        const StressViolation &found = read->violations[n], &expected = one.violations[n];
        EXPECT_EQ(found.fault.check, expected.fault.check);
        EXPECT_EQ(found.fault.detail, expected.fault.detail);
        EXPECT_EQ(found.method, expected.method);
        EXPECT_EQ(found.rays, expected.rays);
        EXPECT_EQ(found.map, expected.map);
        EXPECT_EQ(found.command, expected.command);
        EXPECT_EQ(found.kind, expected.kind);
    }
    EXPECT_EQ(stressCaseLine(*read), line);
}

TEST(StressRecord, WhatIsNoCaseIsNone) {
    const std::string line = stressCaseLine(caseOf(3, "noise", "8x8"));
    ASSERT_TRUE(parseStressCase(line));
    for (const char* text : {"", "\n", "{}", "[]", "7", "null", "{\"run\":{}}"}) EXPECT_FALSE(parseStressCase(text));
    EXPECT_FALSE(parseStressCase(std::string_view(line).substr(0, line.size() / 2)));
    for (const char* name : {"case", "map", "size", "violations", "methods", "parts", "listed"}) {
        std::string without = line;
        const std::size_t at = without.find("\"" + std::string(name) + "\"");
        ASSERT_NE(at, std::string::npos) << name;
        without[at + 1] = 'X';
        EXPECT_FALSE(parseStressCase(without)) << name;
    }
}

}  // namespace
}  // namespace relief::test
