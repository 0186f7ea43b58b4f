#include <algorithm>
#include <cmath>

#include "measuring/bench/bench_tracers.h"
#include "measuring/text_table.h"

namespace relief {

namespace {

constexpr int kDigits = 3;  // significant digits in text tables

std::string sizeText(const BenchRow& row) {
    return std::to_string(row.width) + "x" + std::to_string(row.heightTexels);
}

bool sameBlock(const BenchRow& a, const BenchRow& b) {
    return a.height == b.height && a.width == b.width && a.heightTexels == b.heightTexels && a.elevation == b.elevation;
}

std::string blockTitle(const BenchRow& row) {
    return row.height + ", " + sizeText(row) + ", " + std::string(surfaceName(row.surface)) + ", " +
           std::string(addressName(row.address)) + ", relief depth " + numberText(row.reliefDepth) + ", elevation " +
           elevationText(row.elevation) + (row.elevation ? " degrees" : "") + "\n";
}

TableRow tableRow(const BenchRow& row) {
    const auto number = [](double value) { return std::isnan(value) ? std::string("-") : readable(value, kDigits); };
    const TracerErrors& e = row.errors;
    return {methodText(row.method),
            std::string(formName(row.form)),
            number(row.rate / 1e6),
            number(row.spread * 100),
            number(e.mean),
            number(e.p95),
            number(e.p9999),
            number(e.max),
            std::to_string(e.wrongOutcome),
            std::to_string(e.overshoots),
            number(row.stepsMean),
            number(row.readsMean),
            sentence(bytesText(row.memoryBytes, kDigits)),
            number(row.buildSeconds * 1000)};
}

}  // namespace

const std::vector<BenchColumn>& benchColumns() {
    using V = BenchValue;
    using R = BenchRow;
    static const std::vector<BenchColumn> columns{
        {"height", [](const R& r) -> V { return r.height; }},
        {"size", [](const R& r) -> V { return sizeText(r); }},
        {"surface", [](const R& r) -> V { return std::string(surfaceName(r.surface)); }},
        {"address", [](const R& r) -> V { return std::string(addressName(r.address)); }},
        {"relief_depth", [](const R& r) -> V { return r.reliefDepth; }},
        {"method", [](const R& r) -> V { return r.method.name; }},
        {"form", [](const R& r) -> V { return std::string(formName(r.form)); }},
        {"options", [](const R& r) -> V { return optionsText(r.method, true); }},
        {"elevation", [](const R& r) -> V { return r.elevation ? V(*r.elevation) : V(std::string("random")); }},
        {"seed", [](const R& r) -> V { return r.seed; }},
        {"threads", [](const R& r) -> V { return std::int64_t{r.threads}; }},
        {"rate", [](const R& r) -> V { return r.rate; }},
        {"spread", [](const R& r) -> V { return r.spread; }},
        {"error_mean", [](const R& r) -> V { return r.errors.mean; }},
        {"error_p95", [](const R& r) -> V { return r.errors.p95; }},
        {"error_p9999", [](const R& r) -> V { return r.errors.p9999; }},
        {"error_max", [](const R& r) -> V { return r.errors.max; }},
        {"wrong_outcome", [](const R& r) -> V { return r.errors.wrongOutcome; }},
        {"overshoots", [](const R& r) -> V { return r.errors.overshoots; }},
        {"steps_mean", [](const R& r) -> V { return r.stepsMean; }},
        {"steps_p95", [](const R& r) -> V { return r.stepsP95; }},
        {"steps_max", [](const R& r) -> V { return r.stepsMax; }},
        {"reads_mean", [](const R& r) -> V { return r.readsMean; }},
        {"memory_bytes", [](const R& r) -> V { return r.memoryBytes; }},
        {"build_seconds", [](const R& r) -> V { return r.buildSeconds; }},
        {"compiler", [](const R& r) -> V { return r.compiler; }},
        {"cpu", [](const R& r) -> V { return r.cpu; }},
        {"commit", [](const R& r) -> V { return r.commit; }},
    };
    return columns;
}

std::string benchCsvHeader() {
    return columnsHeader(benchColumns());
}

std::string benchCsvLine(const BenchRow& row) {
    return columnsLine(benchColumns(), row);
}

std::string benchJson(std::span<const BenchRow> rows) {
    return columnsJson(benchColumns(), rows);
}

std::string benchText(std::span<const BenchRow> rows) {
    std::string out;
    std::size_t first = 0;
    while (first < rows.size()) {
        std::size_t last = first;
        std::vector<TableRow> block{{"", "form", "Mrays/s", "+-%", "error", "95%", "99.99%", "max", "wrong", "overshot",
                                     "steps", "reads", "maps", "build ms"}};
        for (; last < rows.size() && sameBlock(rows[first], rows[last]); ++last) block.push_back(tableRow(rows[last]));
        out += (first == 0 ? "" : "\n") + blockTitle(rows[first]) + textTable(block);
        first = last;
    }
    if (rows.empty()) return out;
    return out + "\nMrays/s: millions of rays per second on " + std::to_string(rows.front().threads) +
           " threads, median of the rounds; +-%: (p75 - p25) / median.\nerror, 95%, 99.99%, max: mean, percentiles "
           "and maximum, texels; wrong, overshot: number of rays;\nsteps, reads: mean per ray. " +
           rows.front().cpu + ", " + rows.front().compiler + ", " + rows.front().commit + "\n";
}

}  // namespace relief
