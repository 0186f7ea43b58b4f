// What every benchmark does with its cells: they are measured one after the other, or shared by the ranks of an MPI
// run; results are kept in FILE.part as they arrive; at the end the file is written. Without -o a table is printed on a
// terminal, CSV elsewhere.
#pragma once

#include <unistd.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "measuring/bench/bench_columns.h"
#include "options_common.h"
#include "output.h"
#include "part.h"
#include "parts_run.h"
#include "relief/image.h"
#include "team.h"

namespace relief::app {

// Functions that format one kind of row.
template <class Row>
struct BenchTexts {
    std::string (*header)();
    std::string (*json)(std::span<const Row>);
    std::string (*table)(std::span<const Row>);
};

// The unit of work, measured together in interleaved rounds: for example one map at one elevation.
template <class Row>
struct BenchCell {
    std::string name;  // unique within the sweep
    int threads = 0;   // 0: the session's number of threads
    std::function<std::vector<Row>(Work&, BenchPass)> measure;
};

struct BenchRun {
    OptionText output;
    EarlierRun earlier = EarlierRun::Refuse;
    std::optional<int> concurrent;   // cells timed at once on a host, if several ranks share the cells; default 1
    std::optional<PartNumber> part;  // measures only this part's cells; the file names the run that it belongs to
    Json what;                       // everything that rows depend on, apart from the cells' names
};

// Returns a hash of the heights, 16 hexadecimal digits.
std::string contentText(const FloatImage& heights);

// Returns an array of rows as CSV; if it is empty, `header` (with "\n") and the machine's columns.
std::string csvOfRows(const Json& rows, const std::string& header);

// Measures all cells and returns the rows of each, in order; adds the machine's columns (compiler, cpu, commit, host,
// concurrent) to rows that lack them. measure: returns the rows of one cell as an array. Returns std::nullopt on ranks
// other than 0.
struct BenchCells {
    std::vector<std::string> names;
    std::function<int(std::size_t)> threads;
    std::function<Json(std::size_t, Work&, BenchPass)> measure;
};
std::optional<PartsDone> measuredCells(const BenchRun& run, const BenchCells& cells, Session& session);
// Writes the rows to the output file, or as CSV to standard output. header: as for csvOfRows(). names: of all cells of
// the run.
void writeCells(const BenchRun& run, PartsDone done, const std::string& header, const std::vector<std::string>& names,
                Session& session);

// Measures and writes all cells. Returns the exit status.
template <class Row>
int runCells(const BenchRun& run, const BenchTexts<Row>& texts, const std::vector<BenchCell<Row>>& cells,
             Session& session) {
    if (!run.output && run.earlier != EarlierRun::Refuse) {
        throw InputError(run.earlier == EarlierRun::Resume ? "--resume" : "--anew",
                         Message(MessageId::NeedsArgument, {{"other", "--output"}}));
    }
    BenchCells all;
    for (const auto& cell : cells) all.names.push_back(cell.name);
    all.threads = [&](std::size_t cell) { return cells[cell].threads; };
    std::vector<Row> rows;
    const bool table = !run.output && launchedProcesses() < 2 && isatty(STDOUT_FILENO) == 1;
    all.measure = [&](std::size_t cell, Work& work, BenchPass pass) {
        std::vector<Row> some = cells[cell].measure(work, pass);
        Json json = Json::parse(texts.json(some));
        if (table) rows.insert(rows.end(), std::move_iterator(some.begin()), std::move_iterator(some.end()));
        return json;
    };
    std::optional<PartsDone> done = measuredCells(run, all, session);
    if (table) {
        writeStandardOutput(texts.table(rows), session.stop());
    } else if (done) {
        writeCells(run, *std::move(done), texts.header(), all.names, session);
    }
    return 0;
}

}  // namespace relief::app
