#include <cmath>

#include "measuring/bench_columns.h"
#include "measuring/bench_rows.h"
#include "measuring/machine.h"
#include "measuring/text_table.h"

namespace relief {

namespace {

constexpr int kDigits = 3;  // of what people read

using Value = BenchValue;
using Column = BenchColumnOf<RowBenchRow>;

const std::vector<Column>& columns() {
    using R = RowBenchRow;
    static const std::vector<Column> all{
        {"variant", [](const R& r) -> Value { return r.variant; }},
        {"width", [](const R& r) -> Value { return r.width; }},
        {"elevation", [](const R& r) -> Value { return r.elevation; }},
        {"precision", [](const R& r) -> Value { return std::string(precisionName(r.precision)); }},
        {"streams", [](const R& r) -> Value { return r.streams; }},
        {"span", [](const R& r) -> Value { return r.span; }},
        {"anchor", [](const R& r) -> Value { return r.anchor; }},
        {"threads", [](const R& r) -> Value { return std::int64_t{r.threads}; }},
        {"mul", [](const R& r) -> Value { return r.counts.mul; }},
        {"add", [](const R& r) -> Value { return r.counts.add; }},
        {"div", [](const R& r) -> Value { return r.counts.div; }},
        {"rate", [](const R& r) -> Value { return r.rate; }},
        {"spread", [](const R& r) -> Value { return r.spread; }},
        {"error_max", [](const R& r) -> Value { return r.errorMax; }},
    };
    return all;
}

bool sameBlock(const RowBenchRow& a, const RowBenchRow& b) {
    return a.width == b.width && a.elevation == b.elevation && a.precision == b.precision;
}

TableRow tableRow(const RowBenchRow& row) {
    const auto number = [](double value) { return std::isnan(value) ? std::string("-") : readable(value, kDigits); };
    const auto count = [](std::int64_t value, std::int64_t none) {
        return value == none ? std::string("-") : std::to_string(value);
    };
    return {row.variant,
            count(row.streams, 1),
            count(row.span, 1),
            count(row.anchor, 0),
            std::to_string(row.threads),
            number(row.counts.mul),
            number(row.counts.add),
            number(row.counts.div),
            number(row.rate / 1e6),
            number(row.spread * 100),
            number(row.errorMax)};
}

}  // namespace

std::string_view precisionName(RowPrecision precision) {
    return precision == RowPrecision::Float ? "float" : "double";
}

std::string rowBenchCsvHeader() {
    return columnsHeader(columns());
}

std::string rowBenchCsvLine(const RowBenchRow& row) {
    return columnsLine(columns(), row);
}

std::string rowBenchJson(std::span<const RowBenchRow> rows) {
    return columnsJson(columns(), rows);
}

std::string rowBenchText(std::span<const RowBenchRow> rows) {
    std::string out;
    std::size_t first = 0;
    while (first < rows.size()) {
        std::size_t last = first;
        std::vector<TableRow> block{
            {"", "streams", "span", "anchor", "threads", "mul", "add", "div", "Mpixels/s", "+-%", "error"}};
        for (; last < rows.size() && sameBlock(rows[first], rows[last]); ++last) block.push_back(tableRow(rows[last]));
        out += (first == 0 ? "" : "\n") + std::to_string(rows[first].width) + " pixels a row, elevation " +
               numberText(rows[first].elevation) + " degrees, " + std::string(precisionName(rows[first].precision)) +
               "\n" + textTable(block);
        first = last;
    }
    if (rows.empty()) return out;
    return out +
           "\nmul, add, div: of a pixel, u and v together, restarts in them; derivatives: of its ellipse. Mpixels/s: "
           "millions of pixels\na second, median; +-: (p75 - p25) / median. error: the largest, texels; of "
           "derivatives, "
           "in the ellipse's half extents.\n" +
           cpuText() + ", " + compilerText() + ", " + commitText() + "\n";
}

}  // namespace relief
