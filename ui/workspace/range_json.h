// The colour ranges of pictures in a scenario: the object `ranges` of the panes' choices, with a member for each
// picture whose range somebody has chosen:
//   "steps": {"scale": "log", "ends": "percentile", "low": 1, "high": 99, "threshold": 30}
// scale: "linear" or "log"; ends: "all", "percentile" (low and high are percent) or "own" (low and high are values);
// threshold: values up to it share one colour. What is not given is as in the picture's standard.
#pragma once

#include "painting/color_range.h"
#include "scenario/json_reader.h"

namespace reliefui {

void readRanges(relief::JsonReader reader, ColorRanges& ranges);
relief::Json rangesJson(const ColorRanges& ranges);
// relief::InputError for ends that enclose nothing.
void checkRanges(const ColorRanges& ranges, const std::string& subject);

}  // namespace reliefui
