// Every filter behind one face.
#pragma once

#include <memory>
#include <optional>

#include "filtering/elliptical_options.h"
#include "filtering/filters/filter_choice.h"
#include "filtering/texture_filter.h"

namespace relief {

// `supersample` reads each of its samples bilinearly. Throws InputError (names, options), Cancelled.
std::unique_ptr<const TextureFilter> makeFilter(const FilterChoice& choice, const FilterTools& tools, MapCache& maps,
                                                Work& work);
// Whether the filter reads the mean pyramid.
bool needsLevels(const FilterChoice& choice);
// How the filter weighs the texels of an ellipse, its defaults put in; nothing of filters that read at points. Throws
// InputError (names, options).
std::optional<EllipticalSettings> ellipticalSettings(const FilterChoice& choice);

}  // namespace relief
