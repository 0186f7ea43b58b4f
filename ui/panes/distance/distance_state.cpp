#include "panes/distance/distance_state.h"

#include "relief/tracers/map_choice.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

constexpr int kMostSlices = 1 << 26;

void checkMap(const std::string& name) {
    checkName("map", name, relief::mapKinds());
}

void checkAxis(const std::string& name) {
    checkName("axis", name, {"x", "y", "z"});
}

}  // namespace

void DistancePane::read(relief::JsonReader reader) {
    const auto name = [&](const char* key, std::string& to, void (*check)(const std::string&)) {
        reader.named(key, [&](const std::string& given) {
            check(given);
            to = given;
        });
    };
    name("map", map, checkMap);
    name("minus", minus, checkMap);
    name("axis", axis, checkAxis);
    if (reader.has("slice")) reader.readWhole("slice", slice.emplace());
    if (reader.has("sector")) reader.readWhole("sector", sector.emplace());
    reader.read("lines", lines);
    reader.read("near-ray", nearRay);
    reader.finish();
}

void DistancePane::check(const std::string& subject) const {
    if (!map.empty()) checkMap(map);
    if (!minus.empty()) checkMap(minus);
    if (!axis.empty()) checkAxis(axis);
    checkWithin(subject, "slice", slice.value_or(0), 0, kMostSlices);
    checkWithin(subject, "sector", sector.value_or(0), 0, kMostSlices);
}

relief::Json DistancePane::json() const {
    relief::Json json = {{"lines", lines}, {"near-ray", nearRay}};
    if (!map.empty()) json["map"] = map;
    if (!minus.empty()) json["minus"] = minus;
    if (!axis.empty()) json["axis"] = axis;
    if (slice) json["slice"] = *slice;
    if (sector) json["sector"] = *sector;
    return json;
}

}  // namespace reliefui
