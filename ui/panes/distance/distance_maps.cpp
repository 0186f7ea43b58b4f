#include "panes/distance/distance_maps.h"

#include <algorithm>

#include "relief/tracers.h"
#include "relief/tracers/map_choice.h"

namespace reliefui {

namespace {

const void* identity(const relief::StoredMap& map) {
    return std::visit([](const auto& m) -> const void* { return m.get(); }, map);
}

bool fits(const relief::OptionDescription& option, const std::string& text) {
    try {
        relief::checkOption(option, text);
        return true;
    } catch (const relief::InputError&) {
        return false;
    }
}

}  // namespace

std::string shownKind(const DistanceOptions& options, const Snapshot& snapshot) {
    if (!options.kind.empty()) return options.kind;
    const auto used = relief::usedMap(snapshot.scenario.method);
    return used ? used->kind : relief::mapKinds().front();
}

std::vector<MapOptions> mapOptions(const DistanceOptions& options, const Snapshot& snapshot) {
    std::vector<MapOptions> all;
    const auto used = relief::usedMap(snapshot.scenario.method);
    relief::OptionValues requested = used ? used->options : relief::OptionValues{};
    for (const std::string& kind : {shownKind(options, snapshot), options.minus}) {
        if (kind.empty()) continue;
        const relief::MethodDescription& method = relief::findTracer(relief::methodOfMap(kind));
        MapOptions one{kind, method.defaults};
        for (const relief::OptionDescription& option : method.options) {
            const auto given = requested.find(option.name);
            if (given != requested.end() && fits(option, given->second)) one.options[option.name] = given->second;
        }
        requested = one.options;
        all.push_back(std::move(one));
    }
    return all;
}

DistanceMaps distanceMaps(const Snapshot& snapshot, const DistanceOptions& options, const DistanceMaps& before,
                          relief::Work& work) {
    const relief::HeightField& field = snapshot.request->field;
    const std::vector<MapOptions> requested = mapOptions(options, snapshot);
    const auto build = [&](const MapOptions& one) {
        return relief::buildMap(one.kind, one.options, field, *snapshot.maps, work);
    };
    const auto sliced = [&](const relief::StoredMap& map, const relief::StoredMap& known,
                            const std::shared_ptr<SlicedMap>& same) {
        const bool unchanged = same && identity(map) == identity(known) && same->slabTexels() == field.slabTexels();
        if (unchanged) return same;
        return std::make_shared<SlicedMap>(map, field);
    };
    DistanceMaps maps;
    maps.firstMap = build(requested.front());
    maps.first = sliced(maps.firstMap, before.firstMap, before.first);
    if (requested.size() < 2) return maps;
    maps.secondMap = build(requested.back());
    maps.second = sliced(maps.secondMap, before.secondMap, before.second);
    return maps;
}

DistanceSource distanceSource(const Snapshot& snapshot, const DistanceMaps& maps) {
    DistanceSource source;
    source.field = &snapshot.request->field;
    source.maxima = snapshot.maxima;
    source.first = maps.first.get();
    source.second = maps.second.get();
    source.hasRay = snapshot.trace.onRelief;
    source.ray = snapshot.trace.ray;
    source.hit = snapshot.trace.hit;
    source.exact = snapshot.trace.exact;
    source.steps = &snapshot.trace.steps;
    return source;
}

}  // namespace reliefui
