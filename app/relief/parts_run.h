// Numbered parts of a run, done by this process alone or by all ranks of an MPI run: handed out as ranks come free,
// results sent to rank 0, which alone keeps and writes them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "journal.h"
#include "schedule.h"
#include "session.h"

namespace relief::app {

struct PartsRun {
    std::string bar;  // the progress bar's name
    std::size_t parts = 0;
    std::string output;  // whose journal keeps what is done; empty: no journal
    Json work;           // all that results depend on
    EarlierRun earlier = EarlierRun::Refuse;
    bool alone = false;  // even where a launcher has started others
    // Several ranks: parts are counted first and then timed, so many at once on a host (see Schedule).
    bool timed = false;
    int concurrent = 1;
    std::function<int(std::size_t)> threads = [](std::size_t) { return 0; };  // of a part; 0: the session's
    std::function<Json(Task, Work&)> measure;
    std::function<Json(Json counts, const Json& times)> combine;  // of timed runs
    // Whether a journal's result has this run's shape; a part whose has not is done again. Empty: all have.
    std::function<bool(const Json& result)> readable;
    // On rank 0, or alone: does what is to be done with a whole result, and gives what is kept of it.
    std::function<Json(std::size_t part, Json result)> received;
};

struct PartsDone {
    std::vector<Json> results;         // in order
    std::unique_ptr<Journal> journal;  // to be finished when the output is written; null: there is none
};

// Empty on ranks other than 0, whose work is done then. Rank 0 says at the end how many parts each rank did. Throws
// Cancelled (said where there is a journal, with how to go on, and by rank 0 of several), and alone InputError,
// WorkError and whatever `measure` throws. Of several ranks the one that fails says why and throws RunEnded; at its end
// all others end as well.
std::optional<PartsDone> doParts(const PartsRun& run, Session& session);

}  // namespace relief::app
