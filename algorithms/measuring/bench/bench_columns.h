// Tables of measurements in files: the columns of a row type are described once, for CSV and JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace relief {

// What a benchmark measures in one call. Counts: everything that does not depend on the machine's speed; rates remain
// 0. Times: only rates and times; all else remains 0. Both passes give the same rows in the same order.
enum class BenchPass : std::uint8_t { Both, Counts, Times };

// A value of a row: text, a whole number (seeds go up to 2^64 - 1), or a real number (NaN: no value).
using BenchValue = std::variant<std::string, std::int64_t, std::uint64_t, double>;

template <class Row>
struct BenchColumnOf {
    std::string_view name;
    BenchValue (*get)(const Row&);
};

// Returns the value as a CSV field: fields with commas or quotes are quoted; NaN is empty.
std::string benchField(const BenchValue& value);

// A field of a CSV record, without its quotes.
struct CsvField {
    std::string text;
    bool quoted = false;
};

// Takes the first CSV record off the text and returns it without its "\n"; line breaks between quotes are part of it.
// Returns std::nullopt if no complete record is left.
std::optional<std::string_view> takeRecord(std::string_view& text);

// Splits a CSV record, given without its line break, into its fields: the inverse of benchField().
std::vector<CsvField> csvFields(std::string_view record);

// Returns the rows of a table, `names.size()` values each, as a JSON array of objects; NaN becomes null. Ends with
// "\n".
std::string jsonTable(std::span<const std::string_view> names, std::span<const BenchValue> values);

// Returns the row as a line of CSV, with "\n".
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

// Returns the rows as a JSON array of objects with the same values; NaN becomes null.
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
