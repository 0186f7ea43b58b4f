// Distance and cone maps in files: one TIFF with all layers next to each other in one picture, as unchanged codes. The
// ImageDescription stores as JSON: kind, parameters, surface, addressing, metric, and checksums of the map and of the
// heights from which it was built. A file that is damaged, has another version, or belongs to another height map,
// surface, addressing or depth is rejected with a message of one line (InputError naming the file).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "relief/maps/cone_map.h"
#include "relief/maps/distance_map.h"

namespace relief {

inline constexpr int kMapVersion = 1;

using StoredMap = std::variant<std::shared_ptr<const DistanceMap>, std::shared_ptr<const ConeMap>>;

// The name of the map's kind: "refined", "cone", ...
std::string mapKindName(const StoredMap& map);
std::size_t mapBytes(const StoredMap& map);
// The size as text: "64 x 64 x 16", voxels, or cells and sectors.
std::string mapSizeText(const StoredMap& map);

// Saves a map. path: .tif or .tiff; the file appears only when it is complete. heights: those from which the map was
// built. Throws WorkError.
void saveMap(const std::string& path, const StoredMap& map, const FloatImage& heights);

// Reads the map of that field. Before allocation it rejects files that would take more than maxBytes, and parameters
// that `buildable` rejects (such as those of a damaged file). Throws InputError, Cancelled. loadMap() of
// tracers/map_choice.h calls it with a check by the list of methods.
using MapCheck = bool (*)(const StoredMap& map);
StoredMap readStoredMap(const std::string& path, const HeightField& field, std::size_t maxBytes, MapCheck buildable,
                        Work& work);

}  // namespace relief
