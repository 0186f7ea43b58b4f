// The maps shown by the distance pane and its figures: taken from the snapshot's cache, or built.
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

// The kind to show: the selected one, otherwise the map used by the method, otherwise the Euclidean one.
std::string shownKind(const DistanceOptions& options, const Snapshot& snapshot);
// Options for building the maps. If the method uses a map, its options apply as far as the kind has them; otherwise the
// defaults. The second of two maps has the same voxels as the first.
struct MapOptions {
    std::string kind;
    relief::OptionValues options;
    bool operator==(const MapOptions&) const = default;
};
std::vector<MapOptions> mapOptions(const DistanceOptions& options, const Snapshot& snapshot);

// Finds or builds the maps, which may take long. Throws Cancelled, and InputError for maps that cannot be built or
// compared. before: the previous maps, which are reused if they are the same.
DistanceMaps distanceMaps(const Snapshot& snapshot, const DistanceOptions& options, const DistanceMaps& before,
                          relief::Work& work);
DistanceSource distanceSource(const Snapshot& snapshot, const DistanceMaps& maps);

}  // namespace reliefui
