// What all tables of measurements share: CSV fields and JSON objects.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "measuring/bench/bench_columns.h"

using namespace relief;

namespace {

struct Row {
    std::string name;
    std::uint64_t seed;
    double rate;
};

const std::vector<BenchColumnOf<Row>>& columns() {
    static const std::vector<BenchColumnOf<Row>> all{{"name", [](const Row& r) -> BenchValue { return r.name; }},
                                                     {"seed", [](const Row& r) -> BenchValue { return r.seed; }},
                                                     {"rate", [](const Row& r) -> BenchValue { return r.rate; }}};
    return all;
}

TEST(BenchColumns, fieldsAreQuotedWhereTheyMustBe) {
    const Row row{"a \"b\", c", std::numeric_limits<std::uint64_t>::max(), std::numeric_limits<double>::quiet_NaN()};
    EXPECT_EQ(columnsHeader(columns()), "name,seed,rate\n");
    EXPECT_EQ(columnsLine(columns(), row), "\"a \"\"b\"\", c\",18446744073709551615,\n");
}

TEST(BenchColumns, jsonHoldsSeedsWholeNoNumbersAsNullAndAnyFileName) {
    const std::vector<Row> rows{{"a\xff", std::numeric_limits<std::uint64_t>::max(), std::nan("")}};
    const auto json = nlohmann::json::parse(columnsJson(columns(), std::span<const Row>(rows)));
    EXPECT_EQ(json[0]["seed"].get<std::uint64_t>(), std::numeric_limits<std::uint64_t>::max());
    EXPECT_TRUE(json[0]["rate"].is_null());
    EXPECT_EQ(json[0]["name"].get<std::string>(), "a\xef\xbf\xbd");
}

}  // namespace
