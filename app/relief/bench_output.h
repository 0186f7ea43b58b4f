// What every benchmark does with its cells: measured one after the other, or shared by the processes that a launcher
// started, kept in FILE.part as they come; then the file. Without -o a table on a terminal, CSV elsewhere.
#pragma once

#include <unistd.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "images/image.h"
#include "options_common.h"
#include "output.h"
#include "shared_work.h"

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
    std::function<std::vector<Row>(Work&)> measure;
};

struct BenchRun {
    OptionText output;
    EarlierRun earlier = EarlierRun::Refuse;
    Json what;  // all that rows depend on beside the cells' names
};

// Sixteen letters that tell these heights from others.
std::string contentText(const FloatImage& heights);

// An array of rows as CSV; `header`, with "\n", is taken where there is no row. Columns compiler, cpu and commit are
// added where they are not there.
std::string csvOfRows(const Json& rows, const std::string& header);
void addMachine(Json& rows);

// Measures cell after cell with a Work of its own, telling the session's bar of them as of one piece of work.
// what: the bar's name. measure(cell, work).
void overCells(std::string_view what, std::size_t cells, Session& session,
               const std::function<int(std::size_t)>& threads, const std::function<std::size_t()>& next,
               const std::function<std::size_t()>& done, const std::function<void(std::size_t, Work&)>& measure);
// overCells() over the parts of shared work. Tells how many an earlier run has done, and, where it is interrupted, what
// is kept and how to go on.
void overParts(std::string_view what, SharedWork& shared, Session& session,
               const std::function<int(std::size_t)>& threads, const std::function<void(std::size_t, Work&)>& measure);
// Cells to a file. names: of the cells; measure: the rows of one.
void sweepTo(const BenchRun& run, const std::vector<std::string>& names, const std::string& header, Session& session,
             const std::function<int(std::size_t)>& threads, const std::function<Json(std::size_t, Work&)>& measure);

inline constexpr std::size_t kNoCell = static_cast<std::size_t>(-1);

// Returns the exit status.
template <class Row>
int runCells(const BenchRun& run, const BenchTexts<Row>& texts, const std::vector<BenchCell<Row>>& cells,
             Session& session) {
    const auto threads = [&](std::size_t cell) { return cells[cell].threads; };
    if (run.output) {
        std::vector<std::string> names;
        for (const auto& cell : cells) names.push_back(cell.name);
        sweepTo(run, names, texts.header(), session, threads, [&](std::size_t cell, Work& work) {
            const std::vector<Row> rows = cells[cell].measure(work);
            return Json::parse(texts.json(rows));
        });
        return 0;
    }
    if (launched().size > 1) throw InputError("mpirun", Message(MessageId::NeedsArgument, {{"other", "--output"}}));
    if (run.earlier != EarlierRun::Refuse) {
        throw InputError(run.earlier == EarlierRun::Resume ? "--resume" : "--anew",
                         Message(MessageId::NeedsArgument, {{"other", "--output"}}));
    }
    std::vector<Row> rows;
    std::size_t at = 0;
    overCells(
        "bench", cells.size(), session, threads, [&] { return at < cells.size() ? at : kNoCell; }, [&] { return at; },
        [&](std::size_t cell, Work& work) {
            for (Row& row : cells[cell].measure(work)) rows.push_back(std::move(row));
            ++at;
        });
    session.eraseBar();
    if (isatty(STDOUT_FILENO) == 1) {
        writeStandardOutput(texts.table(rows), session.stop());
    } else {
        Json all = Json::parse(texts.json(rows));
        addMachine(all);
        writeStandardOutput(csvOfRows(all, texts.header()), session.stop());
    }
    return 0;
}

}  // namespace relief::app
