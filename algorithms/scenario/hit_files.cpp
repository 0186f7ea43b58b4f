#include <algorithm>
#include <array>
#include <vector>

#include "relief/memory.h"
#include "scenario/ray_files.h"
#include "scenario/text_lines.h"

namespace relief {

namespace {

// How far lambda may lie outside [0, 1]: the rounding of sums in float.
constexpr double kBeyond = 1e-5;

enum class HitColumn : std::uint8_t { S, T, Steps, Other };

std::vector<HitColumn> hitColumns(std::string_view header, const std::string& fileName) {
    constexpr std::string_view kFirst = "outcome,lambda";
    if (!header.starts_with(kFirst) || (header.size() > kFirst.size() && header[kFirst.size()] != ',')) {
        throw InputError(fileName, Message(MessageId::HitsHeader, {{"text", quoted(header)}}));
    }
    header.remove_prefix(kFirst.size());
    std::vector<HitColumn> columns;
    while (!header.empty()) {
        header.remove_prefix(1);
        const std::string_view name = header.substr(0, header.find(','));
        header.remove_prefix(name.size());
        columns.push_back(name == "s"       ? HitColumn::S
                          : name == "t"     ? HitColumn::T
                          : name == "steps" ? HitColumn::Steps
                                            : HitColumn::Other);
    }
    return columns;
}

void parseHit(std::string_view row, const std::vector<HitColumn>& columns, std::size_t line,
              const std::string& fileName, HitBlock& hits, std::size_t h) {
    const auto count = static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1;
    if (count != columns.size() + 2) {
        throw InputError(fileName, Message(MessageId::StepColumns,
                                           {{"line", line}, {"wanted", columns.size() + 2}, {"count", count}}));
    }
    const std::string_view outcome = takeCell(row);
    const std::string_view lambda = takeCell(row);
    for (const Outcome one : {Outcome::Hit, Outcome::Miss, Outcome::Limit}) {
        if (outcomeName(one) == outcome) hits.outcome[h] = one;
    }
    if (hits.outcome[h] == Outcome::Unset) {
        throw InputError(
            fileName,
            Message(MessageId::StepWord,
                    {{"line", line}, {"what", "outcome"}, {"text", quoted(outcome)}, {"known", "hit, miss, limit"}}));
    }
    const bool hit = hits.outcome[h] == Outcome::Hit;
    if (hit) {
        const double value = finiteNumber(lambda, fileName, line);
        if (!(value >= -kBeyond && value <= 1 + kBeyond)) {
            throw InputError(
                fileName, Message(MessageId::StepOutsideSlab, {{"line", line}, {"what", "lambda"}, {"value", value}}));
        }
        hits.lambda[h] = std::clamp(value, 0.0, 1.0);
    }
    for (const HitColumn column : columns) {
        const std::string_view cell = takeCell(row);
        if (column == HitColumn::Other || cell.empty()) continue;
        const double value = finiteNumber(cell, fileName, line);
        constexpr double kMostSteps = 4e9;
        if (column == HitColumn::Steps) hits.steps[h] = static_cast<std::uint32_t>(std::clamp(value, 0.0, kMostSteps));
        if (column == HitColumn::S && hit) hits.s[h] = value;
        if (column == HitColumn::T && hit) hits.t[h] = value;
    }
}

}  // namespace

HitBlock parseHits(std::string_view text, const std::string& fileName) {
    text = withoutMark(text);
    const std::vector<HitColumn> columns = hitColumns(takeLine(text), fileName);
    const std::size_t most = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    requireMemory(byteProduct({most, HitBlock::kBytes}), fileName);
    HitBlock hits(most);
    std::size_t count = 0;
    for (std::size_t line = 2; !text.empty(); ++line) {
        const std::string_view row = takeLine(text);
        if (row.empty() && text.find_first_not_of("\r\n") == std::string_view::npos) break;
        parseHit(row, columns, line, fileName, hits, count++);
    }
    hits.resize(count);
    return hits;
}

}  // namespace relief
