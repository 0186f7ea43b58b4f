// Which method works with which stored map. Maps are built by kind, with the options of their tracer; a stored map can
// be given to a tracer instead of one that it would build.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/maps/map_files.h"

namespace relief {

// Returns true if the name is one of these.
bool isListed(const std::vector<std::string>& names, const std::string& name);

// Kinds of maps that can be built and stored, in the order of lists.
const std::vector<std::string>& mapKinds();
// The method that works inside this one, with its options; std::nullopt for methods that have no inner method.
std::optional<MethodChoice> innerMethod(const MethodChoice& choice);
// The stored map that the method, or the one inside it, traces with, and the options that build it: all options of the
// tracing method, given or default. std::nullopt if it uses none.
struct UsedMap {
    std::string kind;
    OptionValues options;
};
std::optional<UsedMap> usedMap(const MethodChoice& choice);
// The method with the layout option set to cones of texels, which can be stored, wherever the method has such an option
// and it was not given.
MethodChoice withStoredMap(const MethodChoice& choice);
// The tracer that walks maps of this kind. Throws InputError("", ...), which lists the known kinds.
const std::string& methodOfMap(const std::string& kind);

// Takes the map from the cache or builds it as the kind's tracer would with these options. Throws InputError for
// unknown options, values out of range and maps that exceed the cache's memory; Cancelled.
StoredMap buildMap(const std::string& kind, const OptionValues& options, const HeightField& field, MapCache& cache,
                   Work& work);

// readStoredMap(), which here rejects parameters that no tracer can request.
StoredMap loadMap(const std::string& path, const HeightField& field, std::size_t maxBytes, Work& work);

// Puts the map into the cache under the key that the tracer will look up. Returns the choice with the options that the
// map was built with. Throws InputError(path, ...) if the method does not walk maps of this kind or was given other
// options.
MethodChoice useMap(const std::string& path, const StoredMap& map, const MethodChoice& choice, const HeightField& field,
                    MapCache& cache);

}  // namespace relief
