// The colour ranges of pictures in a scenario: the object `ranges` beside the panes' states, with a member for each
// picture whose range somebody has chosen:
//   "steps": {"scale": "log", "ends": "percentile", "low": 1, "high": 99, "threshold": 30}
// scale: "linear" or "log"; ends: "all", "percentile" (low and high are percent) or "own" (low and high are values);
// threshold: values up to it share one colour. What is not given is as in the picture's standard.
#pragma once

#include "painting/color_range.h"
#include "scenario/scenario.h"
#include "workspace/state_json.h"

namespace reliefui {

// As the state of a pane (workspace/pane_store.h).
struct RangesState {
    static constexpr const char* kName = "ranges";
    ColorRanges ranges;

    void read(relief::JsonReader reader);
    // relief::InputError for ends that enclose nothing.
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const RangesState&) const = default;
};

ColorRanges rangesOf(const relief::Scenario& scenario);

}  // namespace reliefui
