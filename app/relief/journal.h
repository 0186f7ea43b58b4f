// FILE.part: what a run of many parts has done so far, kept as it comes, so that the same command goes on from there
// after it was stopped or killed.
//
// A line of JSON about the whole, {"work": ..., "host": ..., "process": ..., "since": ...}; then a line for each part
// that is done, {"part": N, "result": ...}, and of what an MPI run has counted and not yet timed, {"counted": N,
// "result": ...}. A last line that was cut short is not read, and its part is done again. One process writes it: the
// file is created exclusively and names that process, and a run that goes on from it takes its place at one stroke, so
// that a second run with the same output refuses instead of mixing its lines in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "json_line.h"

namespace relief::app {

// What becomes of a journal that an earlier run has left: the run is refused, or goes on with it (--resume), or throws
// it away (--anew).
enum class EarlierRun : std::uint8_t { Refuse, Resume, Replace };

class Journal {
  public:
    // work: all that results depend on; Resume refuses the journal of another work. Where there is no file, one is
    // begun whatever `earlier` says. Throws InputError (a journal is there, its process is alive on this host, or it
    // is of another work) and WorkError (cannot be written).
    Journal(const std::string& output, const Json& work, std::size_t parts, EarlierRun earlier);
    // Removes a file that holds no result.
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    const std::string& path() const { return path_; }
    // What the earlier run has done, by part: whole parts, and what was counted of others. Given once, not kept here.
    struct Earlier {
        std::map<std::size_t, Json> results, counts;
    };
    Earlier takeEarlier() { return std::exchange(earlier_, {}); }
    // The host of the process that began the resumed run, where it is not this one: whether that process has
    // ended could not be seen. Else empty.
    const std::string& otherHost() const { return otherHost_; }

    // Of a part that is not there yet: all of it, or what is counted (Schedule). Throw WorkError.
    void keep(std::size_t part, const Json& result);
    void keepCounts(std::size_t part, const Json& counts);
    // The output is written: the file goes.
    void finish();
    // Whether it holds anything, be it what was counted and not yet timed.
    bool keepsSome() const { return anything_; }

  private:
    std::string firstLine(const Json& work) const;
    void refuseTheLiving(const Json& head);
    std::string takenOver(const Json& work, EarlierRun earlier);
    // Device and inode: which file it is, whatever its name.
    using FileNumber = std::pair<std::uint64_t, std::uint64_t>;
    void takePlace(const FileNumber& before, const std::string& text);
    [[noreturn]] void refuseTheSecond() const;
    void remove();
    void write(const std::string& text);

    std::string path_;
    std::string otherHost_;
    int descriptor_ = -1;
    FileNumber own_;  // of the file that this run writes
    std::size_t parts_;
    Earlier earlier_;
    bool anything_ = false;  // that would be lost with the file
};

}  // namespace relief::app
