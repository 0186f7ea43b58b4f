// Decides which rank does which part next when several processes share numbered parts. It is independent of messages
// and clocks.
//
// Without timed passes a part is done whole by the first free rank. With them each part is done twice. The counting
// pass, whose results do not depend on the machine's speed (truth, errors, steps), is shared among all ranks. When no
// rank of a host has counting work left, the host times one part at a time (or `concurrent` parts) while its other
// ranks wait.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relief::app {

// What is done of a part: all of it, its counts, or its times.
enum class Pass : std::uint8_t { Whole, Counts, Times };

struct Task {
    std::size_t part = 0;
    Pass pass = Pass::Whole;
    bool operator==(const Task&) const = default;
};

class Schedule {
  public:
    // hosts: the host name of each rank. concurrent: number of parts that a host times at once, at least 1.
    Schedule(std::size_t parts, bool timed, std::vector<std::string> hosts, int concurrent);

    // Marks work that an earlier run has done: a whole part, or the counts of one. To be called before the first
    // next().
    void skip(Task task);
    // Assigns a task to this rank, which must call done() before it gets another. std::nullopt: there is none at
    // present; unless over(), one may become available later.
    std::optional<Task> next(int rank);
    void done(int rank);
    // Returns true when all parts are done.
    bool over() const;

  private:
    struct Host {
        int counting = 0;  // ranks working on a pass that is not timed
        int timing = 0;
    };
    std::vector<bool> counted_, finished_;              // handed out or skipped
    std::size_t firstCounted_ = 0, firstFinished_ = 0;  // all parts before this one are
    std::size_t left_ = 0;                              // number of parts that are not done
    bool timed_;
    int concurrent_;
    std::vector<std::string> hosts_;
    std::map<std::string, Host> busy_;
    std::vector<std::optional<Task>> at_;  // current task of each rank
};

}  // namespace relief::app
