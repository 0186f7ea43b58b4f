// Makes any filter by name.
#pragma once

#include <memory>
#include <optional>

#include "filtering/elliptical_options.h"
#include "filtering/filters/filter_choice.h"
#include "filtering/texture_filter.h"

namespace relief {

// Makes a filter. `supersample` is made as a bilinear filter of its samples. tools.picture: not null, not empty. Throws
// InputError (names, options), MemoryError, Cancelled.
std::unique_ptr<const TextureFilter> makeFilter(const FilterChoice& choice, const FilterTools& tools, MapCache& maps,
                                                Work& work);
// Returns true if the filter reads the mean pyramid.
bool needsLevels(const FilterChoice& choice);
// How the filter weights the texels of an ellipse, with defaults filled in; std::nullopt for filters that sample
// points. Throws InputError (names, options).
std::optional<EllipticalSettings> ellipticalSettings(const FilterChoice& choice);

}  // namespace relief
