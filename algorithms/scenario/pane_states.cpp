#include "scenario/pane_states.h"

#include <algorithm>

#include "measuring/bench_rows.h"
#include "measuring/pareto.h"
#include "measuring/row_methods.h"
#include "relief/maps/map_choice.h"

namespace relief {

namespace {

constexpr double kLeastHeights = 0.25;
constexpr double kMostHeights = 4;
constexpr int kMostSlices = 1 << 26;
constexpr double kFarthestPoint = 1 << 26;  // texels

void inRange(const std::string& subject, const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InputError(
        subject, Message(MessageId::OutOfRange,
                         {{"what", what}, {"value", value}, {"range", numberText(low) + " to " + numberText(high)}}));
}

void checkQuery(const std::string& subject, const QueryPoint& point) {
    inRange(subject, "s", point.s, -kFarthestPoint, kFarthestPoint);
    inRange(subject, "t", point.t, -kFarthestPoint, kFarthestPoint);
    inRange(subject, "z", point.z, 0, 1);
}

}  // namespace

const std::vector<std::string>& pyramidPaneLevels() {
    static const std::vector<std::string> names{"max", "mean", "min", "all"};
    return names;
}

const std::vector<std::string>& chartsPaneShown() {
    static const std::vector<std::string> names{"all", "pareto", "histograms"};
    return names;
}

const std::vector<std::string>& tracePaneColors() {
    static const std::vector<std::string> names{"decision", "level", "phase"};
    return names;
}

void checkPaneName(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    std::string all;
    for (const std::string& one : known) all.append(all.empty() ? "" : ", ").append(one);
    throw InputError("panes", Message(MessageId::UnknownName, {{"what", what}, {"name", name}, {"known", all}}));
}

void checkPanes(const PaneStates& panes, const std::string& subject) {
    checkPaneName("levels", panes.pyramid.levels, pyramidPaneLevels());
    for (const std::string& map : {panes.distance.map, panes.distance.minus}) {
        if (!map.empty()) checkPaneName("map", map, mapKinds());
    }
    if (!panes.distance.axis.empty()) checkPaneName("axis", panes.distance.axis, {"x", "y", "z"});
    inRange(subject, "slice", panes.distance.slice.value_or(0), 0, kMostSlices);
    inRange(subject, "sector", panes.distance.sector.value_or(0), 0, kMostSlices);
    checkPaneName("neighbours", std::to_string(panes.footprint.neighbours), {"0", "4", "8"});
    inRange(subject, "variants", static_cast<double>(panes.rows.variants.size()), 0, kMostRowVariants);
    for (const std::string& variant : panes.rows.variants) parseRowMethod(variant, "variants");
    inRange(subject, "pixels", panes.rows.pixels, 0, static_cast<double>(kWidestRow));
    checkPaneName("charts", panes.charts.shown, chartsPaneShown());
    parseErrorMeasure(panes.charts.error, "error");
    checkPaneName("colors", panes.trace.colors, tracePaneColors());
    inRange(subject, "heights", panes.trace.heights, kLeastHeights, kMostHeights);
    if (panes.query) checkQuery(subject, *panes.query);
}

}  // namespace relief
