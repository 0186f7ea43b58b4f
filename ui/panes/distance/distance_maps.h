// The maps that the distance pane and its figures look at: found in the snapshot's cache, or built.
#pragma once

#include <memory>

#include "panes/distance/distance_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct DistanceMaps {
    relief::StoredMap firstMap;
    relief::StoredMap secondMap;
    std::shared_ptr<SlicedMap> first;
    std::shared_ptr<SlicedMap> second;  // null: none
};

// What is shown of this kind: the one that is asked for, the map that the method walks, or the Euclidean one.
std::string shownKind(const DistanceOptions& options, const Snapshot& snapshot);
// What the kinds are built with: of the options of a method that walks a map those that the kind has, too; else its
// defaults. Of two maps the second one has the voxels of the first.
struct MapOptions {
    std::string kind;
    relief::OptionValues options;
    bool operator==(const MapOptions&) const = default;
};
std::vector<MapOptions> mapOptions(const DistanceOptions& options, const Snapshot& snapshot);

// Takes a while where a map is not there yet: throws Cancelled, and InputError for what cannot be built or compared.
// before: what was looked at last; what is the same is taken from there.
DistanceMaps distanceMaps(const Snapshot& snapshot, const DistanceOptions& options, const DistanceMaps& before,
                          relief::Work& work);
DistanceSource distanceSource(const Snapshot& snapshot, const DistanceMaps& maps);

}  // namespace reliefui
