#include "views/distance_maps.h"

#include <algorithm>

#include "relief/maps/map_choice.h"
#include "relief/tracers.h"

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
    const MapWalk walk = walkedMap(snapshot.scenario.method);
    return walk ? walk.kind : relief::mapKinds().front();
}

relief::OptionValues mapOptions(const std::string& kind, const MapWalk& walk) {
    relief::OptionValues options;
    for (const relief::OptionDescription& option : relief::findTracer(relief::methodOfMap(kind)).options) {
        const auto given = walk.given.find(option.name);
        if (given != walk.given.end() && fits(option, given->second)) options.insert(*given);
    }
    return options;
}

DistanceMaps distanceMaps(const Snapshot& snapshot, const DistanceOptions& options, const DistanceMaps& before,
                          relief::Work& work) {
    const MapWalk walk = walkedMap(snapshot.scenario.method);
    const relief::HeightField& field = snapshot.request->field;
    const auto build = [&](const std::string& kind) {
        return relief::buildMap(kind, mapOptions(kind, walk), field, *snapshot.maps, work);
    };
    const auto sliced = [&](const relief::StoredMap& map, const relief::StoredMap& known,
                            const std::shared_ptr<SlicedMap>& same) {
        const bool unchanged = same && identity(map) == identity(known) && same->slabTexels() == field.slabTexels();
        if (unchanged) return same;
        return std::make_shared<SlicedMap>(map, field);
    };
    DistanceMaps maps;
    maps.firstMap = build(shownKind(options, snapshot));
    maps.first = sliced(maps.firstMap, before.firstMap, before.first);
    if (options.minus.empty()) return maps;
    maps.secondMap = build(options.minus);
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
    source.steps = &snapshot.trace.steps;
    source.walk = walkedMap(snapshot.scenario.method);
    return source;
}

}  // namespace reliefui
