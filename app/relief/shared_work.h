// Work in numbered parts, whose results are kept in a file as they come (FILE.part): a run that was killed goes on from
// there, and processes that were started together (launch.h) share the parts, each taking the next one as it comes
// free.
//
// The file: a line of JSON about the whole, then a line for each part that is done, {"part": N, "by": rank,
// "result": ...}. A part
// in work is held by a lock on its byte of the file, far beyond its end, which the system releases when the process
// ends, however it does: then another process takes it. Lines are appended whole, under a lock of their own; one that
// was cut short by a crash is not read, and its part is done again. One process alone needs no locks and works where
// the file system has none.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "launch.h"

namespace relief::app {

using Json = nlohmann::ordered_json;

class SharedWork {
  public:
    // what: all that results depend on; Resume refuses a file that was kept by another work. Where there is no file,
    // one is begun whatever `earlier` says. Rank 0 makes it, the others wait for it.
    // Throws InputError (a file is there, other work), WorkError (cannot be written, no locks for several processes,
    // rank 0 does not come), Cancelled.
    SharedWork(const std::string& output, const Json& what, std::size_t parts, EarlierRun earlier, Launch launch,
               std::stop_token stop);
    // Removes a file that holds no result.
    ~SharedWork();
    SharedWork(const SharedWork&) = delete;
    SharedWork& operator=(const SharedWork&) = delete;

    std::size_t parts() const { return results_.size(); }
    std::size_t done() const { return done_; }
    const Launch& launch() const { return launch_; }
    const std::string& path() const { return path_; }  // FILE.part
    // Why the work goes on without locks, as an errno; 0: it has them.
    int lockError() const;

    // The next part that nobody has done or is doing, held from now on; waits while others do the last ones; nothing
    // when all are done. Throws Cancelled.
    std::optional<std::size_t> take();
    // Of the part held.
    void put(std::size_t part, const Json& result);

    // After the last take(): results of all parts in order, given to one process only, which then calls finish();
    // nothing where another has finished.
    std::optional<std::vector<Json>> collect();
    // The output is written: the file goes when every process has seen that.
    void finish();

  private:
    class File;

    void begin(const Json& what, EarlierRun earlier);
    std::string keptLines(const Json& what) const;
    void join(const Json& what);
    void refresh();
    void append(const Json& line);
    void pause() const;

    std::string path_;
    Launch launch_;
    std::stop_token stop_;
    std::unique_ptr<File> file_;
    std::string unread_;  // the beginning of a line whose end is not there yet
    std::vector<std::optional<Json>> results_;
    std::size_t done_ = 0;
    int arrived_ = 0;  // processes
    bool finished_ = false;
};

}  // namespace relief::app
