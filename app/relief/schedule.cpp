#include "schedule.h"

#include <algorithm>

namespace relief::app {

Schedule::Schedule(std::size_t parts, bool timed, std::vector<std::string> hosts, int concurrent)
    : counted_(parts, !timed),
      finished_(parts, false),
      left_(parts),
      timed_(timed),
      concurrent_(std::max(concurrent, 1)),
      hosts_(std::move(hosts)),
      at_(hosts_.size()) {}

void Schedule::skip(Task task) {
    counted_[task.part] = true;
    if (task.pass == Pass::Counts || finished_[task.part]) return;
    finished_[task.part] = true;
    --left_;
}

std::optional<Task> Schedule::next(int rank) {
    const auto at = static_cast<std::size_t>(rank);
    Host& host = busy_[hosts_[at]];
    while (firstCounted_ < counted_.size() && counted_[firstCounted_]) ++firstCounted_;
    while (firstFinished_ < finished_.size() && finished_[firstFinished_]) ++firstFinished_;
    if (firstCounted_ < counted_.size()) {
        counted_[firstCounted_] = true;
        ++host.counting;
        return at_[at] = Task{firstCounted_, Pass::Counts};
    }
    if (firstFinished_ == finished_.size()) return std::nullopt;
    if (timed_ && (host.counting > 0 || host.timing >= concurrent_)) return std::nullopt;
    finished_[firstFinished_] = true;
    ++(timed_ ? host.timing : host.counting);
    return at_[at] = Task{firstFinished_, timed_ ? Pass::Times : Pass::Whole};
}

void Schedule::done(int rank) {
    const auto at = static_cast<std::size_t>(rank);
    if (!at_[at]) return;
    const Pass pass = at_[at]->pass;
    Host& host = busy_[hosts_[at]];
    --(pass == Pass::Times ? host.timing : host.counting);
    if (pass != Pass::Counts) --left_;
    at_[at].reset();
}

bool Schedule::over() const {
    return left_ == 0;
}

}  // namespace relief::app
