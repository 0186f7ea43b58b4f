// Distance and cone maps in files: one TIFF, all layers side by side in one picture, codes as they are, and what they
// mean as JSON in its ImageDescription: kind, parameters, surface, addressing, metric, checksums of the map and of the
// heights it was made of. A file that is damaged, of another version, or of another height map, surface, addressing or
// depth is refused with one line (InputError naming the file).
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

// "refined", "cone", ...
std::string mapKindName(const StoredMap& map);
std::size_t mapBytes(const StoredMap& map);
// "64 x 64 x 16": voxels, or cells and sectors.
std::string mapSizeText(const StoredMap& map);

// path: .tif or .tiff; appears only when complete. heights: those that the map was built from. Throws WorkError.
void saveMap(const std::string& path, const StoredMap& map, const FloatImage& heights);

// The map of that field. Refuses what would take more than maxBytes before allocating it, and parameters that
// `buildable` rejects (as a damaged file's are); may be cancelled. loadMap() of tracers/map_choice.h checks by the
// list.
using MapCheck = bool (*)(const StoredMap& map);
StoredMap readStoredMap(const std::string& path, const HeightField& field, std::size_t maxBytes, MapCheck buildable,
                        Work& work);

}  // namespace relief
