#include "bench_output.h"

#include <bit>
#include <cmath>
#include <cstdio>

#include "measuring/bench_columns.h"
#include "measuring/machine.h"
#include "measuring/measured_method.h"

namespace relief::app {

namespace {

// Of the bar, a cell.
constexpr std::int64_t kPermille = 1000;

BenchValue valueOf(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_integer()) return value.get<std::int64_t>();
    return value.is_number() ? value.get<double>() : std::nan("");
}

BenchPass passOf(Pass pass) {
    if (pass == Pass::Counts) return BenchPass::Counts;
    return pass == Pass::Times ? BenchPass::Times : BenchPass::Both;
}

// Columns at the end, where they are not there yet: of the machine, and how many cells it timed at once.
void addMachine(Json& rows, int concurrent) {
    for (Json& row : rows) {
        for (const auto& [name, text] : {std::pair<const char*, std::string (*)()>{"compiler", compilerText},
                                         {"cpu", cpuText},
                                         {"commit", commitText},
                                         {"host", hostName}}) {
            if (!row.contains(name)) row[name] = text();
        }
        if (!row.contains("concurrent")) row["concurrent"] = concurrent;
    }
}

// The rows that were counted, with what was timed, and where.
Json withTimes(Json counts, const Json& times) {
    for (std::size_t row = 0; row < counts.size(); ++row) {
        for (const char* const name :
             {"rate", "spread", "build_seconds", "threads", "compiler", "cpu", "host", "concurrent"}) {
            if (counts[row].contains(name)) counts[row][name] = times.at(row).at(name);
        }
    }
    return counts;
}

// Rows that the first version measured have no form: it measured the fastest there was.
void addForm(Json& rows) {
    for (Json& row : rows) {
        if (!row.contains("error_mean") || row.contains("form")) continue;
        Json whole = Json::object();
        for (const auto& [name, value] : row.items()) {
            whole[name] = value;
            if (name != "method") continue;
            const std::string options = row.value("options", std::string());
            whole["form"] = formName(methodForm(
                splitMethodChoice(value.get<std::string>() + (options.empty() ? "" : ":" + options), "form")));
        }
        row = std::move(whole);
    }
}

}  // namespace

std::string contentText(const FloatImage& heights) {
    // FNV-1a over the bits.
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const float height : heights.pixels()) {
        hash ^= std::bit_cast<std::uint32_t>(height);
        hash *= 0x100000001b3ULL;
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string csvOfRows(const Json& rows, const std::string& header) {
    if (rows.empty()) return header;
    std::string text;
    for (const auto& [name, value] : rows.front().items()) text += (text.empty() ? "" : ",") + name;
    text += "\n";
    for (const Json& row : rows) {
        std::string line;
        bool first = true;
        for (const auto& [name, value] : row.items()) {
            if (!first) line += ',';
            line += benchField(valueOf(value));
            first = false;
        }
        text += line + "\n";
    }
    return text;
}

std::optional<PartsDone> measuredCells(const BenchRun& run, const BenchCells& cells, Session& session) {
    PartsRun parts;
    parts.bar = "bench";
    parts.parts = cells.names.size();
    parts.output = run.output.value_or("");
    parts.work = {{"options", run.what}, {"cells", cells.names}};
    parts.earlier = run.earlier;
    parts.timed = true;
    parts.concurrent = run.concurrent;
    parts.threads = cells.threads;
    parts.measure = [&](const Task& task, Work& work) {
        Json rows = cells.measure(task.part, work, passOf(task.pass));
        addMachine(rows, run.concurrent);
        return rows;
    };
    parts.combine = withTimes;
    return doParts(parts, session);
}

void writeCells(const BenchRun& run, PartsDone done, const std::string& header, Session& session) {
    Json rows = Json::array();
    for (Json& cell : done.results) rows.insert(rows.end(), cell.begin(), cell.end());
    addForm(rows);
    if (!run.output) return writeStandardOutput(csvOfRows(rows, header), session.stop());
    TextOutput file(*run.output, session.stop());
    file.write(fileEnding(*run.output) == "json" ? rows.dump(1) + "\n" : csvOfRows(rows, header));
    file.commit();
    done.journal->finish();
}

}  // namespace relief::app
