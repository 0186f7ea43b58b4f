#include "scenario/pane_states_json.h"

#include "measuring/pareto.h"
#include "measuring/row_methods.h"
#include "relief/maps/map_choice.h"

namespace relief {

namespace {

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
        if (!reader.has(key)) reader.fail(key, "a number");
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

}  // namespace

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
    if (panes.footprint != standard.footprint) json["footprint"] = {{"neighbours", panes.footprint.neighbours}};
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
    return json;
}

}  // namespace relief
