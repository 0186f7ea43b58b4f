// FILE.part: the results of a run of many parts, saved as they arrive, so that the same command can resume after it was
// stopped or killed.
//
// The first line is a JSON object that describes the run, {"work": ..., "host": ..., "process": ..., "since": ...}.
// Then follows a line for each finished part, {"part": N, "result": ...}, and, in an MPI run, for each part that is
// counted but not yet timed, {"counted": N, "result": ...}. A truncated last line is ignored, and its part is done
// again. Only one process writes the file: it is created exclusively and names that process. A run that resumes
// replaces it atomically, so that a second run with the same output refuses to start instead of mixing in its own
// lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "base/part_file.h"
#include "json_line.h"

namespace relief::app {

class Journal {
  public:
    // Creates the journal `output`.part, or resumes it. work: everything that results depend on; Resume refuses the
    // journal of other work. If no journal exists, one is created for every value of `earlier`. Throws InputError (a
    // journal exists and `earlier` is Refuse, its process is alive on this host, or it is of other work) and WorkError
    // (it cannot be written).
    Journal(const std::string& output, const Json& work, std::size_t parts, EarlierRun earlier);
    // Removes the file if it holds no result.
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    const std::string& path() const { return path_; }
    // Results of the earlier run by part: finished parts (results), and counts of parts not yet timed (counts).
    // takeEarlier() moves them out.
    struct Earlier {
        std::map<std::size_t, Json> results, counts;
    };
    Earlier takeEarlier() { return std::exchange(earlier_, {}); }
    // Returns the host of the process that began the resumed run if it is not this host, where it cannot be checked
    // whether that process has ended. Empty otherwise.
    const std::string& otherHost() const { return otherHost_; }

    // Append the result of a part that is not yet saved: the whole of it, or its counts (see Schedule). Throw
    // WorkError.
    void keep(std::size_t part, const Json& result);
    void keepCounts(std::size_t part, const Json& counts);
    // Removes the file, once the output is written.
    void finish();
    // Returns true if the journal holds any result, including counts that are not yet timed.
    bool hasResults() const { return hasResults_; }

  private:
    std::string firstLine(const Json& work) const;
    void refuseIfAlive(const Json& head);
    std::string adoptEarlier(const Json& work, EarlierRun earlier);
    // Device and inode, which identify a file whatever its name.
    using FileNumber = std::pair<std::uint64_t, std::uint64_t>;
    void replaceJournal(const FileNumber& before, const std::string& text);
    [[noreturn]] void refuseSecondRun() const;
    void remove();
    void write(const std::string& text);

    std::string path_;
    std::string otherHost_;
    int descriptor_ = -1;
    FileNumber own_;  // the file that this run writes
    std::size_t parts_;
    Earlier earlier_;
    bool hasResults_ = false;  // the file holds at least one result
};

}  // namespace relief::app
