#include <cmath>

#include "measuring/bench/bench_columns.h"
#include "measuring/bench/bench_filters.h"
#include "measuring/bench/machine.h"
#include "measuring/text_table.h"

namespace relief {

namespace {

constexpr int kDigits = 3;  // significant digits in text tables

using Value = BenchValue;
using Column = BenchColumnOf<FilterBenchRow>;

// Returns the option's value as given, or its default; "-" if the filter has no such option.
std::string option(const FilterBenchRow& row, const std::string& name) {
    const FilterDescription& filter = findFilter(row.filter.name);
    const auto usual = filter.defaults.find(name);
    if (usual == filter.defaults.end()) return "-";
    const auto given = row.filter.options.find(name);
    return given == row.filter.options.end() ? usual->second : given->second;
}

// The options that have their own columns.
constexpr std::array<std::string_view, 5> kOwnColumns{"weights", "levels", "source", "resolution", "implementation"};

std::string shortText(const FilterBenchRow& row) {
    FilterChoice choice = row.filter;
    for (const std::string_view name : kOwnColumns) choice.options.erase(std::string(name));
    return filterText(choice);
}

// Returns how weights are computed: pixel shapes are always read from a map, whatever the option says; formulas are
// evaluated with SIMD if a SIMD version exists for them.
std::string implementation(const FilterBenchRow& row) {
    const std::string weights = option(row, "weights");
    if (weights == "box" || weights == "lcd" || weights == "crt") return "map";
    const std::string source = weights == "texel-distance" ? "direct" : option(row, "source");
    const bool lanes = option(row, "implementation") == "lanes" && option(row, "levels") == "pyramid";
    return source == "direct" && lanes ? "lanes" : source;
}

std::string mapSize(const FilterBenchRow& row) {
    const std::string source = implementation(row);
    return source == "map" || source == "table" ? option(row, "resolution") : "-";
}

const std::vector<Column>& columns() {
    using R = FilterBenchRow;
    static const std::vector<Column> all{
        {"filter", [](const R& r) -> Value { return shortText(r); }},
        {"weights", [](const R& r) -> Value { return option(r, "weights"); }},
        {"levels", [](const R& r) -> Value { return option(r, "levels"); }},
        {"pixel_model", [](const R& r) -> Value { return std::string(pixelModelName(r.pixelModel)); }},
        {"implementation", [](const R& r) -> Value { return implementation(r); }},
        {"map_size", [](const R& r) -> Value { return mapSize(r); }},
        {"scene", [](const R& r) -> Value { return r.scene; }},
        {"elevation", [](const R& r) -> Value { return r.elevation; }},
        {"threads", [](const R& r) -> Value { return std::int64_t{r.threads}; }},
        {"rate", [](const R& r) -> Value { return r.rate; }},
        {"spread", [](const R& r) -> Value { return r.spread; }},
        {"rmse", [](const R& r) -> Value { return r.rmse; }},
        {"psnr", [](const R& r) -> Value { return r.psnr; }},
        {"flip", [](const R& r) -> Value { return r.flip; }},
        {"texels_read", [](const R& r) -> Value { return r.texelsRead; }},
        {"tested", [](const R& r) -> Value { return r.tested; }},
        {"hidden", [](const R& r) -> Value { return r.hidden; }},
        {"skipped", [](const R& r) -> Value { return r.skipped; }},
    };
    return all;
}

bool sameBlock(const FilterBenchRow& a, const FilterBenchRow& b) {
    return a.scene == b.scene && a.elevation == b.elevation;
}

// Returns one line per filter, with the errors for each pixel model next to each other.
TableRow tableRow(std::span<const FilterBenchRow> models) {
    const auto number = [](double value) { return std::isnan(value) ? std::string("-") : readable(value, kDigits); };
    const FilterBenchRow& first = models.front();
    TableRow row{filterText(first.filter), number(first.rate / 1e6), number(first.spread * 100)};
    for (const FilterBenchRow& model : models) {
        row.push_back(number(model.rmse * 1000));
        row.push_back(number(model.flip * 1000));
    }
    for (const double value : {first.texelsRead, first.tested, first.hidden, first.skipped}) {
        row.push_back(number(value));
    }
    return row;
}

}  // namespace

std::string filterBenchCsvHeader() {
    return columnsHeader(columns());
}

std::string filterBenchCsvLine(const FilterBenchRow& row) {
    return columnsLine(columns(), row);
}

std::string filterBenchJson(std::span<const FilterBenchRow> rows) {
    return columnsJson(columns(), rows);
}

std::string filterBenchText(std::span<const FilterBenchRow> rows) {
    std::string out;
    std::size_t first = 0;
    while (first < rows.size()) {
        std::size_t models = 1;
        while (first + models < rows.size() && rows[first + models].filter == rows[first].filter &&
               sameBlock(rows[first], rows[first + models])) {
            ++models;
        }
        TableRow head{"", "Mpixels/s", "+-%"};
        for (std::size_t m = 0; m < models; ++m) {
            const std::string name(pixelModelName(rows[first + m].pixelModel));
            head.push_back("rmse " + name);
            head.push_back("flip " + name);
        }
        for (const char* name : {"texels", "tested", "hidden", "skipped"}) head.emplace_back(name);
        std::vector<TableRow> block{head};
        std::size_t last = first;
        for (; last < rows.size() && sameBlock(rows[first], rows[last]); last += models) {
            block.push_back(tableRow(rows.subspan(last, models)));
        }
        out += (first == 0 ? "" : "\n") + rows[first].scene + ", elevation " + numberText(rows[first].elevation) +
               " degrees\n" + textTable(block);
        first = last;
    }
    if (rows.empty()) return out;
    return out + "\nMpixels/s: millions of pixels per second on " + std::to_string(rows.front().threads) +
           " threads, median of the rounds; +-%: (p75 - p25) / median.\nrmse (linear light), flip: difference from the "
           "supersampled picture of that pixel model, times 1000.\ntexels: texels sampled per pixel; tested, hidden, "
           "skipped: of these traced back, hidden, not traced back. " +
           cpuText() + ", " + compilerText() + ", " + commitText() + "\n";
}

}  // namespace relief
