// Adds up the cases of a stress run to its report, and writes and reads them as lines of JSON, by which the parts of a
// divided run pass on their results.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "measuring/verify/stress.h"

namespace relief {

// Adds up cases. Not thread-safe.
class StressTally {
  public:
    // listed: StressOptions::listed.
    explicit StressTally(std::size_t listed = StressOptions{}.listed) : listed_(listed) {}

    // Returns true if another violation of this kind would be listed.
    bool lists(const std::string& kind) const;
    // Returns true if no further violation can be listed.
    bool full() const { return report_.violations.size() == listed_; }
    // Adds a case; they must be added in the order of their numbers.
    void add(const StressCase& one);
    // Returns the report of the cases so far, with seconds 0 and not interrupted.
    const StressReport& report() const { return report_; }

  private:
    std::size_t listed_;
    StressReport report_;
    std::map<std::string, std::size_t> countByKind_;
};

// Returns one line of JSON with "\n", printable ASCII.
std::string stressCaseLine(const StressCase& one);
// Parses such a line; the case has exactly the same numbers. std::nullopt if the text is no such line.
std::optional<StressCase> parseStressCase(std::string_view line);

}  // namespace relief
