#include "bench_output.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "base/part_file.h"
#include "measuring/bench/bench_columns.h"
#include "measuring/bench/machine.h"
#include "measuring/bench/measured_method.h"

namespace relief::app {

namespace {

// A column at the end of every table that describes the machine or how many cells it timed at once.
struct MachineColumn {
    const char* name;
    std::string (*text)();  // null: the value is set per run
};
constexpr MachineColumn kMachineColumns[] = {
    {"compiler", compilerText}, {"cpu", cpuText}, {"commit", commitText}, {"host", hostName}, {"concurrent", nullptr}};

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

// Adds the machine's columns where they are missing. concurrent: null if unknown, as for a part of a run, since other
// parts may run on the same machine.
void addMachine(Json& rows, const Json& concurrent) {
    for (Json& row : rows) {
        for (const auto& [name, text] : kMachineColumns) {
            if (!row.contains(name)) row[name] = text != nullptr ? Json(text()) : concurrent;
        }
    }
}

bool areRows(const Json& result) {
    return result.is_array() &&
           std::all_of(result.begin(), result.end(), [](const Json& row) { return row.is_object() && !row.empty(); });
}

// Returns the counted rows, with the times and the machine's columns taken from `times`.
Json withTimes(Json counts, const Json& times) {
    std::vector<const char*> timed{"rate", "spread", "build_seconds", "threads"};
    for (const MachineColumn& column : kMachineColumns) timed.push_back(column.name);
    for (std::size_t row = 0; row < counts.size(); ++row) {
        for (const char* const name : timed) {
            if (counts[row].contains(name)) counts[row][name] = times.at(row).at(name);
        }
    }
    return counts;
}

// Rows of the first version have no form: that version measured the fastest available one.
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
    ContentHash hash;
    for (const float height : heights.pixels()) hash.add(std::bit_cast<std::uint32_t>(height));
    return hash.text();
}

std::string csvOfRows(const Json& rows, const std::string& header) {
    if (rows.empty()) {
        std::string whole = header.substr(0, header.find('\n'));
        const std::vector<std::string> names = splitText(whole, ',');
        for (const MachineColumn& column : kMachineColumns) {
            if (std::find(names.begin(), names.end(), column.name) == names.end())
                whole.append(",").append(column.name);
        }
        return whole + "\n";
    }
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

namespace {

// Returns the indices of the cells to measure: all `cells`, or those that belong to the run's part.
std::vector<std::size_t> chosenCells(const BenchRun& run, std::size_t cells) {
    std::vector<std::size_t> chosen;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        if (!run.part || run.part->has(cell)) chosen.push_back(cell);
    }
    return chosen;
}

// Returns the first line of a part's table.
std::string tableLine(const BenchRun& run, const std::vector<Json>& results, const std::vector<std::string>& names) {
    Part part;
    static_cast<PartNumber&>(part) = *run.part;
    part.run = runJson(run.what.value("kind", ""), run.what, names);
    // columns with text and with non-integers, which CSV does not distinguish from integers
    std::set<std::string> words, reals;
    Json counts = Json::array();
    const std::vector<std::size_t> chosen = chosenCells(run, names.size());
    for (std::size_t n = 0; n < chosen.size(); ++n) {
        counts.push_back({chosen[n], results[n].size()});
        for (const Json& row : results[n]) {
            for (const auto& [name, value] : row.items()) {
                if (value.is_string()) words.insert(name);
                if (value.is_number_float()) reals.insert(name);
            }
        }
    }
    part.more = {{"rows", counts}, {"words", words}, {"reals", reals}};
    return "# " + partLine(part) + "\n";
}

}  // namespace

std::optional<PartsDone> measuredCells(const BenchRun& run, const BenchCells& cells, Session& session) {
    const std::vector<std::size_t> chosen = chosenCells(run, cells.names.size());
    PartsRun parts;
    parts.bar = "bench";
    parts.parts = chosen.size();
    parts.output = run.output.value_or("");
    parts.work = {{"options", run.what}, {"cells", cells.names}};
    if (run.part) parts.work["part"] = {run.part->part, run.part->of};
    parts.earlier = run.earlier;
    parts.alone = run.part.has_value();
    parts.timed = true;
    parts.concurrent = run.concurrent.value_or(1);
    // No more cells can run at once than there are ranks.
    const int most = run.part ? run.concurrent.value_or(1) : std::max(launchedProcesses(), 1);
    const Json concurrent = run.concurrent ? Json(std::min(*run.concurrent, most)) : run.part ? Json() : Json(1);
    parts.threads = [&](std::size_t at) { return cells.threads(chosen[at]); };
    parts.measure = [&](const Task& task, Work& work) {
        Json rows = cells.measure(chosen[task.part], work, passOf(task.pass));
        addMachine(rows, concurrent);
        return rows;
    };
    parts.combine = withTimes;
    parts.readable = areRows;
    return doParts(parts, session);
}

void writeCells(const BenchRun& run, PartsDone done, const std::string& header, const std::vector<std::string>& names,
                Session& session) {
    Json rows = Json::array();
    for (Json& cell : done.results) {
        addForm(cell);
        for (Json& row : cell) {
            // Rows measured by older versions lack the machine's columns.
            for (const MachineColumn& column : kMachineColumns) {
                if (!row.contains(column.name)) row[column.name] = nullptr;
            }
            rows.push_back(row);
        }
    }
    if (!run.output) return writeStandardOutput(csvOfRows(rows, header), session.stop());
    TextOutput file(*run.output, session.stop());
    if (run.part) file.write(tableLine(run, done.results, names));
    file.write(fileEnding(*run.output) == "json" ? rows.dump(1) + "\n" : csvOfRows(rows, header));
    file.commit();
    done.journal->finish();
}

}  // namespace relief::app
