// Does the numbered parts of a run in this process alone or in all ranks of an MPI run. Parts are handed out as ranks
// become free; results are sent to rank 0, the only one that keeps and writes them.
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
    std::string output;  // the journal of this file keeps what is done; empty: no journal
    Json work;           // everything that results depend on
    EarlierRun earlier = EarlierRun::Refuse;
    bool alone = false;  // ignores other processes of the same launch
    // With several ranks, parts are first counted and then timed, `concurrent` of them at a time on a host (see
    // Schedule).
    bool timed = false;
    int concurrent = 1;
    // for a part; 0: the session's number of threads
    std::function<int(std::size_t)> threads = [](std::size_t) { return 0; };
    std::function<Json(Task, Work&)> measure;
    std::function<Json(Json counts, const Json& times)> combine;  // joins counts and times of timed runs
    // Called on rank 0, or in a single process, as soon as no other run can have this output, before `readable`.
    // resumed: the journal holds results of an earlier run. Null: nothing to do.
    std::function<void(bool resumed)> started;
    // Returns true if a result of a journal has this run's form; parts with other results are done again. Null: all
    // have.
    std::function<bool(const Json& result)> readable;
    // Called on rank 0, or in a single process, with each complete result; returns what is kept of it. Null: all of it.
    std::function<Json(std::size_t part, Json result)> received;
};

struct PartsDone {
    std::vector<Json> results;         // in the order of the parts
    std::unique_ptr<Journal> journal;  // to be finished after the output is written; null: no journal
};

// Does all parts and returns the results. Returns std::nullopt on ranks other than 0, whose work is then done. At the
// end rank 0 prints how many parts each rank did. Throws Cancelled; before that it prints how to resume if there is a
// journal, and rank 0 of several ranks always prints a note. A single process also throws InputError, WorkError and any
// exception of `measure`. With several ranks the failing rank prints the error and throws RunEnded; when it ends, so do
// all others.
std::optional<PartsDone> doParts(const PartsRun& run, Session& session);

}  // namespace relief::app
