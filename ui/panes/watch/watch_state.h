// The user's choices in the watch pane.
#pragma once

#include <string>
#include <vector>

#include "workspace/state_json.h"

namespace reliefui {

inline constexpr std::size_t kMostWatched = 16;

struct WatchPane {
    static constexpr const char* kName = "watch";
    // Columns of the steps, or expressions over them (scenario/step_columns.h).
    std::vector<std::string> values{"lambda_after", "level", "value"};
    // Index of the value to whose changes one can run.
    int chosen = 0;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const WatchPane&) const = default;

    // Returns the chosen value; empty if none is watched.
    std::string chosenValue() const;
};

}  // namespace reliefui
