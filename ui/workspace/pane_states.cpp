#include "workspace/pane_states.h"

#include <algorithm>

#include "measuring/bench/bench_rows.h"
#include "measuring/bench/pareto.h"
#include "relief/files.h"
#include "relief/tracers/map_choice.h"
#include "scenario/json_reader.h"
#include "scenario/row_methods.h"
#include "workspace/range_json.h"

namespace reliefui {

namespace {

using relief::InputError;
using relief::Json;
using relief::JsonReader;
using relief::mapKinds;
using relief::Message;
using relief::MessageId;
using relief::parseErrorMeasure;
using relief::parseRowMethod;

constexpr double kLeastHeights = 0.25;
constexpr double kMostHeights = 4;
constexpr int kMostSlices = 1 << 26;
constexpr double kFarthestPoint = 1 << 26;  // texels

void inRange(const std::string& subject, const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InputError(subject, Message(MessageId::OutOfRange,
                                      {{"what", what}, {"value", value}, {"range", relief::rangeOf(low, high)}}));
}

void checkQuery(const std::string& subject, const QueryPoint& point) {
    inRange(subject, "s", point.s, -kFarthestPoint, kFarthestPoint);
    inRange(subject, "t", point.t, -kFarthestPoint, kFarthestPoint);
    inRange(subject, "z", point.z, 0, 1);
}

const std::vector<std::string>& pyramidPaneLevels() {
    static const std::vector<std::string> names{"max", "mean", "min", "all"};
    return names;
}

// Throws InputError naming `what` with what is known.
void checkPaneName(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    throw InputError("panes", Message(MessageId::UnknownName,
                                      {{"what", what}, {"name", name}, {"known", relief::commaList(known)}}));
}

void readDistance(JsonReader reader, DistancePane& pane) {
    const auto map = [&](const char* key, std::string& to) {
        reader.named(key, [&](const std::string& name) {
            checkPaneName("map", name, mapKinds());
            to = name;
        });
    };
    map("map", pane.map);
    map("minus", pane.minus);
    reader.named("axis", [&](const std::string& name) {
        checkPaneName("axis", name, {"x", "y", "z"});
        pane.axis = name;
    });
    if (reader.has("slice")) reader.readWhole("slice", pane.slice.emplace());
    if (reader.has("sector")) reader.readWhole("sector", pane.sector.emplace());
    reader.read("lines", pane.lines);
    reader.read("near-ray", pane.nearRay);
    reader.finish();
}

void readRows(JsonReader reader, RowsPane& pane) {
    if (reader.has("variants")) pane.variants.clear();
    reader.readTexts("variants", [&](const std::string& text) {
        parseRowMethod(text, "variants");
        pane.variants.push_back(text);
    });
    reader.readWhole("pixels", pane.pixels);
    reader.read("double", pane.inDouble);
    reader.read("logarithmic", pane.logarithmic);
    reader.finish();
}

void readCharts(JsonReader reader, ChartsPane& pane) {
    reader.named("shown", [&](const std::string& name) {
        checkPaneName("charts", name, chartsPaneShown());
        pane.shown = name;
    });
    reader.named("error", [&](const std::string& name) {
        parseErrorMeasure(name, "error");
        pane.error = name;
    });
    reader.read("live", pane.live);
    reader.read("maps", pane.maps);
    reader.finish();
}

void readPyramid(JsonReader reader, PyramidPane& pane) {
    reader.named("levels", [&](const std::string& name) {
        checkPaneName("levels", name, pyramidPaneLevels());
        pane.levels = name;
    });
    reader.read("stacked", pane.stacked);
    reader.read("near-ray", pane.nearRay);
    reader.read("follow", pane.follow);
    reader.finish();
}

// All three: a point that a file gives in part is a mistake.
void readQuery(JsonReader reader, std::optional<QueryPoint>& query) {
    QueryPoint& point = query.emplace();
    const auto number = [&](const char* key, double& value) {
        if (!reader.has(key)) reader.fail(key, MessageId::WantANumber);
        reader.read(key, value);
    };
    number("s", point.s);
    number("t", point.t);
    number("z", point.z);
    reader.finish();
}

Json distanceJson(const DistancePane& pane) {
    Json json = {{"lines", pane.lines}, {"near-ray", pane.nearRay}};
    if (!pane.map.empty()) json["map"] = pane.map;
    if (!pane.minus.empty()) json["minus"] = pane.minus;
    if (!pane.axis.empty()) json["axis"] = pane.axis;
    if (pane.slice) json["slice"] = *pane.slice;
    if (pane.sector) json["sector"] = *pane.sector;
    return json;
}

void readPanes(JsonReader reader, PaneStates& panes) {
    if (reader.has("pyramid")) readPyramid(reader.child("pyramid"), panes.pyramid);
    if (reader.has("profile")) {
        JsonReader part = reader.child("profile");
        part.read("all-levels", panes.profile.allLevels);
        part.read("near-ray", panes.profile.nearRay);
        part.read("true-aspect", panes.profile.trueAspect);
        part.finish();
    }
    if (reader.has("distance")) readDistance(reader.child("distance"), panes.distance);
    if (reader.has("footprint")) {
        JsonReader part = reader.child("footprint");
        part.readWhole("neighbours", panes.footprint.neighbours);
        part.read("weights", panes.footprint.weights);
        part.finish();
    }
    if (reader.has("rows")) readRows(reader.child("rows"), panes.rows);
    if (reader.has("charts")) readCharts(reader.child("charts"), panes.charts);
    if (reader.has("trace")) {
        JsonReader part = reader.child("trace");
        part.named("colors", [&](const std::string& name) {
            checkPaneName("colors", name, tracePaneColors());
            panes.trace.colors = name;
        });
        part.read("heights", panes.trace.heights);
        part.read("follow", panes.trace.follow);
        part.finish();
    }
    if (reader.has("query")) readQuery(reader.child("query"), panes.query);
    if (reader.has("ranges")) readRanges(reader.child("ranges"), panes.ranges);
    reader.finish();
}

Json panesJson(const PaneStates& panes) {
    const PaneStates standard;
    Json json = Json::object();
    if (panes.pyramid != standard.pyramid) {
        json["pyramid"] = {{"levels", panes.pyramid.levels},
                           {"stacked", panes.pyramid.stacked},
                           {"near-ray", panes.pyramid.nearRay},
                           {"follow", panes.pyramid.follow}};
    }
    if (panes.profile != standard.profile) {
        json["profile"] = {{"all-levels", panes.profile.allLevels},
                           {"near-ray", panes.profile.nearRay},
                           {"true-aspect", panes.profile.trueAspect}};
    }
    if (panes.distance != standard.distance) json["distance"] = distanceJson(panes.distance);
    if (panes.footprint != standard.footprint) {
        json["footprint"] = {{"neighbours", panes.footprint.neighbours}, {"weights", panes.footprint.weights}};
    }
    if (panes.rows != standard.rows) {
        json["rows"] = {{"variants", panes.rows.variants},
                        {"pixels", panes.rows.pixels},
                        {"double", panes.rows.inDouble},
                        {"logarithmic", panes.rows.logarithmic}};
    }
    if (panes.charts != standard.charts) {
        json["charts"] = {{"shown", panes.charts.shown},
                          {"error", panes.charts.error},
                          {"live", panes.charts.live},
                          {"maps", panes.charts.maps}};
    }
    if (panes.trace != standard.trace) {
        json["trace"] = {
            {"colors", panes.trace.colors}, {"heights", panes.trace.heights}, {"follow", panes.trace.follow}};
    }
    if (panes.query) json["query"] = {{"s", panes.query->s}, {"t", panes.query->t}, {"z", panes.query->z}};
    if (panes.ranges != standard.ranges) json["ranges"] = rangesJson(panes.ranges);
    return json;
}

}  // namespace

const std::vector<std::string>& chartsPaneShown() {
    static const std::vector<std::string> names{"all", "pareto", "histograms"};
    return names;
}

const std::vector<std::string>& tracePaneColors() {
    static const std::vector<std::string> names{"decision", "level", "phase"};
    return names;
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
    inRange(subject, "pixels", panes.rows.pixels, 0, static_cast<double>(relief::kWidestRow));
    checkPaneName("charts", panes.charts.shown, chartsPaneShown());
    parseErrorMeasure(panes.charts.error, "error");
    checkPaneName("colors", panes.trace.colors, tracePaneColors());
    inRange(subject, "heights", panes.trace.heights, kLeastHeights, kMostHeights);
    if (panes.query) checkQuery(subject, *panes.query);
    checkRanges(panes.ranges, subject);
}

PaneStates panesOf(const relief::Scenario& scenario) {
    PaneStates panes;
    if (!scenario.ui.empty()) {
        const std::string file;
        const Json json = relief::parseJson(scenario.ui, file);
        readPanes(JsonReader({scenario.ui, file}, json, {}), panes);
    }
    return panes;
}

void setPanesOf(relief::Scenario& scenario, const PaneStates& panes) {
    scenario.ui = panes == PaneStates{} ? std::string() : panesJson(panes).dump();
}

relief::Scenario parseWindowScenario(const std::string& text, const std::string& fileName) {
    relief::Scenario scenario = relief::parseScenario(text, fileName);
    const Json json = relief::parseJson(text, fileName);
    JsonReader reader({text, fileName}, json, {});
    PaneStates panes;
    // As parseScenario() chooses.
    for (const char* key : {"ui", "panes"}) {
        if (!reader.has(key)) continue;
        readPanes(reader.child(key), panes);
        break;
    }
    checkPanes(panes, fileName);
    setPanesOf(scenario, panes);
    return scenario;
}

relief::Scenario loadWindowScenario(const std::string& path) {
    return parseWindowScenario(relief::readTextFile(path), path);
}

}  // namespace reliefui
