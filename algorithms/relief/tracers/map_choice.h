// Which method works with which stored map: maps built by kind with the options of their tracer, and a stored map given
// to a tracer in place of one that it would build.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/maps/map_files.h"

namespace relief {

// Kinds that can be built and stored, in the order of lists.
const std::vector<std::string>& mapKinds();
// The method that works inside this one, with its options; nothing of methods that have none.
std::optional<MethodChoice> innerMethod(const MethodChoice& choice);
// The stored map that the method, or the one inside it, traces with, and the options that build it: all of the tracing
// method's, given or its defaults. Nothing if it uses none.
struct UsedMap {
    std::string kind;
    OptionValues options;
};
std::optional<UsedMap> usedMap(const MethodChoice& choice);
// The method with a map that can be stored, where it has a choice and none was made: cones of texels.
MethodChoice withStoredMap(const MethodChoice& choice);
// The tracer that walks maps of this kind; throws InputError("", ...) with the known ones.
const std::string& methodOfMap(const std::string& kind);

// From the cache or built, as the kind's tracer would with these options; throws InputError for options it has not or
// out of range, beyond the cache's memory, Cancelled.
StoredMap buildMap(const std::string& kind, const OptionValues& options, const HeightField& field, MapCache& cache,
                   Work& work);

// readStoredMap(); parameters that no tracer can ask for are rejected.
StoredMap loadMap(const std::string& path, const HeightField& field, std::size_t maxBytes, Work& work);

// Puts the map where the tracer will look for it. Gives the choice with the options that the map was built with; throws
// InputError(path, ...) if the method walks no map of this kind or was given other options.
MethodChoice useMap(const std::string& path, const StoredMap& map, const MethodChoice& choice, const HeightField& field,
                    MapCache& cache);

}  // namespace relief
