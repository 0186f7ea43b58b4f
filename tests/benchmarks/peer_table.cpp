#include "peer_table.h"

#include <algorithm>
#include <sstream>

#include "measuring/bench/bench_columns.h"
#include "measuring/bench/machine.h"
#include "measuring/quantiles.h"
#include "relief/files.h"

namespace relief::peers {

namespace {

const std::vector<BenchColumnOf<PeerRow>>& columns() {
    static const std::vector<BenchColumnOf<PeerRow>> all{
        {"what", [](const PeerRow& r) { return BenchValue(r.what); }},
        {"size", [](const PeerRow& r) { return BenchValue(r.size); }},
        {"view", [](const PeerRow& r) { return BenchValue(r.view); }},
        {"method", [](const PeerRow& r) { return BenchValue(r.method); }},
        {"threads", [](const PeerRow& r) { return BenchValue(static_cast<std::int64_t>(r.threads)); }},
        {"rate", [](const PeerRow& r) { return BenchValue(r.rate); }},
        {"spread", [](const PeerRow& r) { return BenchValue(r.spread); }},
        {"ratio", [](const PeerRow& r) { return BenchValue(r.ratio); }},
        {"ratio_spread", [](const PeerRow& r) { return BenchValue(r.ratioSpread); }},
        {"error", [](const PeerRow& r) { return BenchValue(r.error); }},
        {"cpu", [](const PeerRow&) { return BenchValue(cpuText()); }},
        {"compiler", [](const PeerRow&) { return BenchValue(compilerText()); }},
        {"commit", [](const PeerRow&) { return BenchValue(commitText()); }},
    };
    return all;
}

}  // namespace

std::vector<std::string> partsOf(const std::string& text, char separator) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) all.push_back(part);
    return all;
}

void writePeerRows(const std::string& path, const std::vector<PeerRow>& rows) {
    std::string text;
    if (path.ends_with(".json")) {
        text = columnsJson<PeerRow>(columns(), rows);
    } else {
        text = columnsHeader(columns());
        for (const PeerRow& row : rows) text += columnsLine(columns(), row);
    }
    writeTextFile(path, text);
}

void setRates(PeerRow& row, const std::vector<double>& rates) {
    row.rate = quantile(rates, 0.5);
    row.spread = relativeSpread(rates);
}

void setRatios(PeerRow& row, const std::vector<double>& rates, const std::vector<double>& fastest) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < rates.size(); ++i) ratios.push_back(rates[i] / fastest[i]);
    row.ratio = quantile(ratios, 0.5);
    row.ratioSpread = relativeSpread(ratios);
}

std::vector<double> fastestOf(const std::vector<const std::vector<double>*>& contenders) {
    std::vector<double> fastest;
    for (const auto* rates : contenders) {
        fastest.resize(rates->size());
        for (std::size_t i = 0; i < rates->size(); ++i) fastest[i] = std::max(fastest[i], (*rates)[i]);
    }
    return fastest;
}

}  // namespace relief::peers
