#include "measuring/bench/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace relief {

namespace {

using Cell = std::tuple<std::string, int, int, Surface, Address, double, double, std::uint64_t, int>;

Cell cellOf(const BenchRow& row) {
    constexpr double kRandom = -1;
    return {row.height,
            row.width,
            row.heightTexels,
            row.surface,
            row.address,
            row.reliefDepth,
            row.elevation.value_or(kRandom),
            row.seed,
            row.threads};
}

void addOnce(std::vector<std::string>& all, const std::string& text) {
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
}

std::string sizeText(const BenchRow& row) {
    return std::to_string(row.width) + "x" + std::to_string(row.heightTexels);
}

// Shortens "bricks:256x256:1" to "bricks", as the size has its own column; a seed other than 1 is kept.
std::string nameOf(const BenchRow& row) {
    const std::size_t colon = row.height.find(':');
    if (colon == std::string::npos || row.height.compare(colon + 1, sizeText(row).size(), sizeText(row)) != 0) {
        return row.height;
    }
    const std::string seed = row.height.substr(colon + 1 + sizeText(row).size());
    return row.height.substr(0, colon) + (seed == ":1" ? "" : seed);
}

// Replaces NaN by infinity, so that it never counts as better.
double orInfinite(double error) {
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

// Combines the rows of one method.
ParetoPoint pointOf(const std::vector<const BenchRow*>& rows) {
    ParetoPoint point;
    point.method = rows.front()->method;
    point.form = rows.front()->form;
    point.name = shortMethodName(point.method);
    double logSum = 0;
    std::array<double, 4> sums{};
    double most = std::numeric_limits<double>::quiet_NaN();
    int withError = 0;
    for (const BenchRow* row : rows) {
        logSum += std::log(1e9 / row->rate);
        point.spread = std::max(point.spread, row->spread);
        point.wrongOutcome += row->errors.wrongOutcome;
        point.steps += row->stepsMean / static_cast<double>(rows.size());
        if (std::isnan(row->errors.mean)) continue;
        ++withError;
        sums[0] += row->errors.mean;
        sums[1] += row->errors.p95;
        sums[2] += row->errors.p9999;
        most = std::isnan(most) ? row->errors.max : std::max(most, row->errors.max);
    }
    point.nanoseconds = std::exp(logSum / static_cast<double>(rows.size()));
    for (std::size_t e = 0; e < 3; ++e) {
        point.error[e] = withError > 0 ? sums[e] / withError : std::numeric_limits<double>::quiet_NaN();
    }
    point.error[3] = most;
    return point;
}

}  // namespace

ErrorMeasure parseErrorMeasure(const std::string& text, const std::string& option) {
    const auto found = std::find(kErrorMeasureNames.begin(), kErrorMeasureNames.end(), text);
    if (found != kErrorMeasureNames.end()) return static_cast<ErrorMeasure>(found - kErrorMeasureNames.begin());
    throw InputError(option, unknownName({"what", MessageId::WordErrorMeasure}, text, "mean, p95, p9999, max"));
}

ParetoTable paretoTable(std::span<const BenchRow> rows) {
    ParetoTable table;
    std::vector<Cell> cells;
    std::vector<std::string> names;
    std::map<std::string, std::vector<const BenchRow*>> ofMethod;
    for (const BenchRow& row : rows) {
        const Cell cell = cellOf(row);
        if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
        const std::string name = methodText(row.method) + " " + std::string(formName(row.form));
        addOnce(names, name);
        ofMethod[name].push_back(&row);
        addOnce(table.heights, nameOf(row) + " " + sizeText(row));
        addOnce(table.elevations, elevationText(row.elevation));
    }
    table.cells = cells.size();
    for (const std::string& name : names) {
        const std::vector<const BenchRow*>& own = ofMethod[name];
        if (own.size() < cells.size()) {
            table.leftOut.push_back(shortMethodName(own.front()->method));
        } else {
            table.points.push_back(pointOf(own));
        }
    }
    if (rows.empty()) return table;
    table.threads = rows.front().threads;
    table.cpu = rows.front().cpu;
    table.compiler = rows.front().compiler;
    return table;
}

bool ParetoTable::bothForms() const {
    return std::any_of(points.begin(), points.end(), [&](const ParetoPoint& p) { return p.form != points[0].form; });
}

std::vector<bool> dominatedPoints(std::span<const ParetoPoint> points, ErrorMeasure measure) {
    std::vector<bool> dominated(points.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ParetoPoint& b = points[i];
        const double errorB = orInfinite(b.errorOf(measure));
        for (const ParetoPoint& a : points) {
            const double errorA = orInfinite(a.errorOf(measure));
            if (a.form != b.form) continue;
            const bool noWorse = a.nanoseconds <= b.nanoseconds && errorA <= errorB && a.wrongOutcome <= b.wrongOutcome;
            const bool better = a.nanoseconds < b.nanoseconds || errorA < errorB || a.wrongOutcome < b.wrongOutcome;
            if (noWorse && better) dominated[i] = true;
        }
    }
    return dominated;
}

std::string shortMethodName(const MethodChoice& choice) {
    const auto& known = tracerList();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const MethodDescription& method) { return method.name == choice.name; });
    if (found == known.end()) return methodText(choice);
    MethodChoice shorter{choice.name, {}};
    for (const auto& [name, value] : choice.options) {
        const auto standard = found->defaults.find(name);
        if (standard == found->defaults.end() || standard->second != value) shorter.options[name] = value;
    }
    // The options of the inner method.
    if (found->defaults.count("inner") > 0) {
        try {
            for (const ChoiceOption& option : choiceOptions(choice)) {
                const auto given = shorter.options.find(option.description.name);
                if (given != shorter.options.end() && given->second == option.defaultValue)
                    shorter.options.erase(given);
            }
        } catch (const InputError&) {
            return methodText(shorter);  // an unknown method or option, from another version of the program
        }
    }
    return methodText(shorter);
}

std::vector<BenchRow> chosenRows(std::vector<BenchRow> rows, const std::string& height, const std::string& elevation) {
    const auto keep = [&](const char* option, const char* what, const std::string& given, const auto& textOf) {
        if (given.empty()) return;
        std::vector<std::string> known;
        for (const BenchRow& row : rows) addOnce(known, textOf(row));
        std::erase_if(rows, [&](const BenchRow& row) { return textOf(row) != given; });
        if (!rows.empty()) return;
        throw InputError(option, unknownName({"what", what}, given, commaList(known)));
    };
    // Accepts the short name, the whole one, or all but the seed, as relief bench --relief takes it.
    const auto begins = [&](const BenchRow& row) { return row.height.starts_with(height + ":"); };
    const bool whole = std::any_of(rows.begin(), rows.end(), [&](const BenchRow& row) { return row.height == height; });
    const bool sized = height.find(':') != std::string::npos && std::any_of(rows.begin(), rows.end(), begins);
    keep("--relief", "relief", height, [&](const BenchRow& row) {
        if (sized && begins(row)) return height;
        return whole ? row.height : nameOf(row);
    });
    keep("--elevation", "elevation", elevation, [](const BenchRow& row) { return elevationText(row.elevation); });
    return rows;
}

}  // namespace relief
