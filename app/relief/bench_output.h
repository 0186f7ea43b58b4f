// What every benchmark does with its cells: measured one after the other, or shared by the ranks of an MPI run, kept in
// FILE.part as they come; then the file. Without -o a table on a terminal, CSV elsewhere.
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

// How one kind of row is written.
template <class Row>
struct BenchTexts {
    std::string (*header)();
    std::string (*json)(std::span<const Row>);
    std::string (*table)(std::span<const Row>);
};

// What is measured together, in interleaved rounds: a map and an elevation, say.
template <class Row>
struct BenchCell {
    std::string name;  // tells it from all others of the sweep
    int threads = 0;   // 0: those of the session
    std::function<std::vector<Row>(Work&, BenchPass)> measure;
};

struct BenchRun {
    OptionText output;
    EarlierRun earlier = EarlierRun::Refuse;
    std::optional<int> concurrent;   // cells that a host times at once, where several ranks share them; default 1
    std::optional<PartNumber> part;  // these cells alone; the file names the run that they are a part of
    Json what;                       // all that rows depend on beside the cells' names
};

// Sixteen letters that tell these heights from others.
std::string contentText(const FloatImage& heights);

// An array of rows as CSV; where there is no row, `header` (with "\n") and the machine's columns.
std::string csvOfRows(const Json& rows, const std::string& header);

// All cells: the rows of each, in order, with the machine's columns (compiler, cpu, commit, host, concurrent) where
// they have none. measure: the rows of one, as an array. Empty on ranks other than 0.
struct BenchCells {
    std::vector<std::string> names;
    std::function<int(std::size_t)> threads;
    std::function<Json(std::size_t, Work&, BenchPass)> measure;
};
std::optional<PartsDone> measuredCells(const BenchRun& run, const BenchCells& cells, Session& session);
// To the file, or to standard output as CSV. header: as csvOfRows takes it; names: of all cells of the run.
void writeCells(const BenchRun& run, PartsDone done, const std::string& header, const std::vector<std::string>& names,
                Session& session);

// Returns the exit status.
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
