// The cases of a stress run as they add up to its report, and as lines of JSON that parts of a run leave for others.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "measuring/verify/stress.h"

namespace relief {

// Adds up cases. Not for several threads at once.
class StressTally {
  public:
    // listed: StressOptions::listed.
    explicit StressTally(std::size_t listed = StressOptions{}.listed) : listed_(listed) {}

    // Whether fewer violations of the kind than are listed of one have come.
    bool lists(const std::string& kind) const;
    // Whether as many violations are listed as there is room for.
    bool full() const { return report_.violations.size() == listed_; }
    // In the order of their numbers.
    void add(const StressCase& one);
    // Of the cases so far; seconds 0, not interrupted.
    const StressReport& report() const { return report_; }

  private:
    std::size_t listed_;
    StressReport report_;
    std::map<std::string, std::size_t> alike_;
};

// One line of JSON with "\n", printable ASCII.
std::string stressCaseLine(const StressCase& one);
// The same case, to the last bit of its numbers; empty where the text is no such line.
std::optional<StressCase> parseStressCase(std::string_view line);

}  // namespace relief
