// The colour ranges in a scenario: the object `ranges`, next to the panes' states, with a member for each picture whose
// range the user has changed:
//   "steps": {"scale": "log", "ends": "percentile", "low": 1, "high": 99, "threshold": 30}
// scale: "linear" or "log"; ends: "all", "percentile" (low and high in percent) or "own" (low and high are values);
// threshold: values up to it share one colour. Missing members have the picture's standard value.
#pragma once

#include "painting/color_range.h"
#include "scenario/scenario.h"
#include "workspace/state_json.h"

namespace reliefui {

// Has the form of a pane's state (workspace/pane_store.h).
struct RangesState {
    static constexpr const char* kName = "ranges";
    ColorRanges ranges;

    void read(relief::JsonReader reader);
    // Throws relief::InputError for an empty range.
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const RangesState&) const = default;
};

ColorRanges rangesOf(const relief::Scenario& scenario);

}  // namespace reliefui
