// Tables of measurements as files have them: the columns of a row described once, written as CSV and as JSON.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace relief {

// What of a benchmark is measured in one call. Counts: all that does not depend on the machine's speed; rates are left
// 0. Times: rates and times alone, the rest left 0. Rows are the same, in the same order.
enum class BenchPass : std::uint8_t { Both, Counts, Times };

// A value of a row: a word, a whole number (seeds go up to 2^64 - 1), a number (NaN: there is none).
using BenchValue = std::variant<std::string, std::int64_t, std::uint64_t, double>;

template <class Row>
struct BenchColumnOf {
    std::string_view name;
    BenchValue (*get)(const Row&);
};

// As a field of CSV: fields with commas or quotes are quoted; no number: empty.
std::string benchField(const BenchValue& value);

// The rows of a table, `names.size()` values each, as a JSON array of objects; NaN becomes null. With "\n".
std::string jsonTable(std::span<const std::string_view> names, std::span<const BenchValue> values);

// With "\n".
template <class Row>
std::string columnsHeader(const std::vector<BenchColumnOf<Row>>& columns) {
    std::string out;
    for (const auto& column : columns) out.append(out.empty() ? "" : ",").append(column.name);
    return out + "\n";
}

template <class Row>
std::string columnsLine(const std::vector<BenchColumnOf<Row>>& columns, const Row& row) {
    std::string out;
    for (const auto& column : columns) {
        if (&column != &columns.front()) out += ',';
        out += benchField(column.get(row));
    }
    return out + "\n";
}

// An array of objects with the same values; no number: null.
template <class Row>
std::string columnsJson(const std::vector<BenchColumnOf<Row>>& columns, std::span<const Row> rows) {
    std::vector<std::string_view> names;
    for (const auto& column : columns) names.push_back(column.name);
    std::vector<BenchValue> values;
    for (const Row& row : rows) {
        for (const auto& column : columns) values.push_back(column.get(row));
    }
    return jsonTable(names, values);
}

}  // namespace relief
