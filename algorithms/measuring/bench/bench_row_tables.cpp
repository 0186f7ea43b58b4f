#include <cmath>

#include "measuring/bench/bench_columns.h"
#include "measuring/bench/bench_rows.h"
#include "measuring/bench/machine.h"
#include "measuring/text_table.h"

namespace relief {

namespace {

constexpr int kDigits = 3;  // significant digits in text tables

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
        {"rows", [](const R& r) -> Value { return r.rows; }},
    };
    return all;
}

bool sameBlock(const RowBenchRow& a, const RowBenchRow& b) {
    return a.width == b.width && a.rows == b.rows && a.elevation == b.elevation && a.precision == b.precision;
}

// Returns operation counts as the papers print them, "10/10/4/1".
std::string paperCounts(const std::string& variant) {
    for (const RowMethodDescription& method : rowMethodList()) {
        if (method.name != variant || method.paper.empty()) continue;
        std::string text = method.paper;
        std::erase(text, ' ');
        return text;
    }
    return "-";
}

// [PERSP]: evaluating rows with several threads is weak if rows are few and long. For equal width, precision and
// elevation, compares the block of fewest rows with that of most rows.
std::string fewRowsText(std::span<const RowBenchRow> rows) {
    std::string out;
    for (const RowBenchRow& few : rows) {
        if (few.variant != "rows-parallel") continue;
        const RowBenchRow* many = nullptr;
        bool fewest = true;
        for (const RowBenchRow& other : rows) {
            const bool same = other.variant == few.variant && other.width == few.width &&
                              other.elevation == few.elevation && other.precision == few.precision &&
                              other.streams == few.streams;
            if (!same) continue;
            if (other.rows < few.rows) fewest = false;
            if (other.rows > few.rows && (many == nullptr || other.rows > many->rows)) many = &other;
        }
        if (!fewest || many == nullptr) continue;
        out += "Rows in parallel on " + std::to_string(few.threads) + " threads, " + std::to_string(few.width) +
               " pixels per row, " + std::string(precisionName(few.precision)) + ": " + std::to_string(few.rows) +
               (few.rows == 1 ? " row " : " rows ") + readable(few.rate / 1e6, kDigits) + ", " +
               std::to_string(many->rows) + " rows " + readable(many->rate / 1e6, kDigits) + " Mpixels/s, " +
               readable(many->rate / few.rate, kDigits) +
               " times the rate. One thread computes each row, so with fewer rows than " +
               "threads some threads are idle.\n";
    }
    return out.empty() ? out : "\n" + out;
}

TableRow tableRow(const RowBenchRow& row) {
    const auto number = [](double value) { return std::isnan(value) ? std::string("-") : readable(value, kDigits); };
    const auto count = [](std::int64_t value, std::int64_t none) {
        return value == none ? std::string("-") : std::to_string(value);
    };
    return {row.variant,
            paperCounts(row.variant),
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
            {"", "paper", "streams", "span", "anchor", "threads", "mul", "add", "div", "Mpixels/s", "+-%", "error"}};
        for (; last < rows.size() && sameBlock(rows[first], rows[last]); ++last) block.push_back(tableRow(rows[last]));
        out += (first == 0 ? "" : "\n") + std::to_string(rows[first].width) + " pixels per row, elevation " +
               numberText(rows[first].elevation) + " degrees, " + std::string(precisionName(rows[first].precision)) +
               ", blocks of " + std::to_string(rows[first].rows) + (rows[first].rows == 1 ? " row" : " rows") + "\n" +
               textTable(block);
        first = last;
    }
    if (rows.empty()) return out;
    return out + fewRowsText(rows) +
           "\npaper: mul/add/div per pixel for u and v as counted in [PERSP], mul/add/div/sub for the four "
           "derivatives as counted in [TEX].\nmul, add, div: operations per pixel for u and v together, with restarts, "
           "or for the footprint's ellipse.\nMpixels/s: millions of pixels per second, median; +-%: (p75 - p25) / "
           "median.\n"
           "error: the largest, texels; for derivatives, of the ellipse's half extents.\n" +
           cpuText() + ", " + compilerText() + ", " + commitText() + "\n";
}

}  // namespace relief
