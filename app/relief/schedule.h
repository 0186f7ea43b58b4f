// Which rank does which part next, where several processes share numbered parts. Knows nothing of messages or clocks.
//
// Without timed passes a part is done whole, by whoever comes first. With them each part is done twice: what does not
// depend on the machine's speed (truth, errors, steps) is shared among all ranks; then, when no rank of a host has any
// of that left to do, the host times one part at a time (or `concurrent`) while its other ranks wait.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relief::app {

// Of a part: all of it, or what is counted, or what is timed.
enum class Pass : std::uint8_t { Whole, Counts, Times };

struct Task {
    std::size_t part = 0;
    Pass pass = Pass::Whole;
    bool operator==(const Task&) const = default;
};

class Schedule {
  public:
    // hosts: of each rank. concurrent: parts that a host times at once, at least 1.
    Schedule(std::size_t parts, bool timed, std::vector<std::string> hosts, int concurrent);

    // What an earlier run has done: a part whole, or what is counted of it. Before the first next().
    void skip(Task task);
    // Handed out to this rank, which does nothing else until done(); nothing: there is none for it now.
    std::optional<Task> next(int rank);
    void done(int rank);
    // All parts are done.
    bool over() const;

  private:
    struct Host {
        int counting = 0;  // ranks at work on a pass that is not timed
        int timing = 0;
    };
    std::vector<bool> counted_, finished_;              // handed out or skipped
    std::size_t firstCounted_ = 0, firstFinished_ = 0;  // all before are
    std::size_t left_ = 0;                              // parts that are not done
    bool timed_;
    int concurrent_;
    std::vector<std::string> hosts_;
    std::map<std::string, Host> busy_;
    std::vector<std::optional<Task>> at_;  // of each rank
};

}  // namespace relief::app
