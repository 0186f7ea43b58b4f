#include <algorithm>
#include <vector>

#include "relief/memory.h"
#include "scenario/ray_files.h"
#include "scenario/text_lines.h"

namespace relief {

namespace {

// How far lambda may lie outside [0, 1]: the rounding of sums in float.
constexpr double kBeyond = 1e-5;

enum class HitColumn : std::uint8_t { S, T, Steps, Other };

constexpr std::string_view kFirstColumns = "outcome,lambda";

std::vector<HitColumn> hitColumns(std::string_view header, const std::string& fileName) {
    const auto names = columnsAfter(header, kFirstColumns);
    if (!names) throw InputError(fileName, Message(MessageId::HitsHeader, {{"text", quoted(header)}}));
    std::vector<HitColumn> columns;
    for (const std::string_view name : *names) {
        columns.push_back(name == "s"       ? HitColumn::S
                          : name == "t"     ? HitColumn::T
                          : name == "steps" ? HitColumn::Steps
                                            : HitColumn::Other);
    }
    return columns;
}

void parseHit(std::string_view row, const std::vector<HitColumn>& columns, std::size_t line,
              const std::string& fileName, HitBlock& hits, std::size_t h) {
    requireCells(row, columns.size() + 2, fileName, line);
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

bool isHitsText(std::string_view text) {
    return withoutMark(text).starts_with(kFirstColumns);
}

HitBlock parseHits(std::string_view text, const std::string& fileName) {
    text = withoutMark(text);
    const std::vector<HitColumn> columns = hitColumns(takeLine(text), fileName);
    const std::size_t most = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    requireMemory(byteProduct({most, HitBlock::kBytes}), fileName);
    HitBlock hits(most);
    std::size_t count = 0;
    forEachRow(text,
               [&](std::string_view row, std::size_t line) { parseHit(row, columns, line, fileName, hits, count++); });
    hits.resize(count);
    return hits;
}

}  // namespace relief
