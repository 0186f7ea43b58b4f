// Finds the layers, and what was done between the last two of them, by which a tracer's answers came about.
#pragma once

#include <optional>

#include "measuring/diagnose/searched_rays.h"

namespace relief {

// Returns the conventions of `rays` with the search in layers, with a secant or halvings of the last layer, that gives
// nearly all of the answers; std::nullopt if there is none, or if an exact search gives them. given: the field.
// lattice: the number of equal layers at which all answers lie, 0 if there is none; a search in that many layers is
// left out.
std::optional<TracerModel> fittedLayers(const SearchedRays& rays, const HeightField& given, int lattice);

}  // namespace relief
