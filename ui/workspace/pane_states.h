// How the window's panes look at a scenario: what a person has chosen in them. A plain value, which the scenario
// carries as its object `ui`; nothing is rendered or traced anew when it changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "painting/color_range.h"
#include "scenario/scenario.h"

namespace reliefui {

struct PyramidPane {
    std::string levels = "max";  // "max", "mean", "min", "all"
    bool stacked = false;        // the levels one above the other, as slabs
    bool nearRay = true;
    bool follow = false;
    bool operator==(const PyramidPane&) const = default;
};

struct ProfilePane {
    bool allLevels = false;
    bool nearRay = true;
    bool trueAspect = false;
    bool operator==(const ProfilePane&) const = default;
};

struct DistancePane {
    std::string map;            // of mapKinds(); empty: the method's own
    std::string minus;          // the map that is taken away; empty: none
    std::string axis;           // "x", "y", "z"; empty: as the ray runs
    std::optional<int> slice;   // from 0; none: the one at the step
    std::optional<int> sector;  // from 0; none: the ray's
    bool lines = true;
    bool nearRay = true;
    bool operator==(const DistancePane&) const = default;
};

struct FootprintPane {
    int neighbours = 0;   // 0, 4 or 8
    bool weights = true;  // the weight function and its map beside it
    bool operator==(const FootprintPane&) const = default;
};

struct RowsPane {
    // As `relief bench rows` spells them.
    std::vector<std::string> variants{"affine", "direct", "incremental:anchor=0", "streams:streams=4"};
    int pixels = 0;  // of the row, up to kWidestRow; 0: the picture's
    bool inDouble = false;
    bool logarithmic = true;
    bool operator==(const RowsPane&) const = default;
};

struct ChartsPane {
    std::string shown = "all";   // "all", "pareto", "histograms"
    std::string error = "mean";  // as of ErrorMeasure
    bool live = true;
    bool maps = false;
    bool operator==(const ChartsPane&) const = default;
};

struct TracePane {
    std::string colors = "decision";  // of tracePaneColors()
    double heights = 1;               // exaggerated so many times, 0.25 to 4
    bool follow = false;
    bool operator==(const TracePane&) const = default;
};

// A point of the slab whose Euclidean and refined distances the distance map and the profile show: texels, and a height
// from 0 to 1. Where the picture repeats, s and t may lie in any of its copies.
struct QueryPoint {
    double s = 0;
    double t = 0;
    double z = 0;
    bool operator==(const QueryPoint&) const = default;
};

struct PaneStates {
    PyramidPane pyramid;
    ProfilePane profile;
    DistancePane distance;
    FootprintPane footprint;
    RowsPane rows;
    ChartsPane charts;
    TracePane trace;
    std::optional<QueryPoint> query;
    ColorRanges ranges;  // of layers, maps and pyramids
    bool operator==(const PaneStates&) const = default;
};

inline constexpr std::size_t kMostRowVariants = 4;  // what can be told apart

const std::vector<std::string>& chartsPaneShown();
const std::vector<std::string>& tracePaneColors();

// relief::InputError for the first value that is unknown or out of range.
void checkPanes(const PaneStates& panes, const std::string& subject);

// The choices that the scenario's `ui` holds. Throws relief::InputError for names and values that the panes do not
// know.
PaneStates panesOf(const relief::Scenario& scenario);
void setPanesOf(relief::Scenario& scenario, const PaneStates& panes);
// As parseScenario() and loadScenario(); the panes' choices are checked, too, and a fault in them names its line.
relief::Scenario parseWindowScenario(const std::string& text, const std::string& fileName);
relief::Scenario loadWindowScenario(const std::string& path);

}  // namespace reliefui
